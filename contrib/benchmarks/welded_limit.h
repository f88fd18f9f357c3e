// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_welded_limit_h
#define stickslip_contrib_welded_limit_h

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <map>

#include "algebraic_multigrid.h"
#include "coupled_limit.h"
#include "geometric_multigrid.h"

namespace Measure
{
  /** The welded problem and the solvers that work on it. */
  template <int dim>
  class WeldedLimit
  {
  public:
    explicit WeldedLimit(const SceneParameters<dim> &scene)
    {
      const double bytes_at_start = allocated_bytes();
      meshes_s                    = seconds([&]() {
        problem =
          std::make_unique<WeldedProblem<dim>>(scene, scene.time.initial_step);
      });
      mesh_bytes                  = allocated_bytes() - bytes_at_start;
      assembly_s = seconds([&]() { problem->assemble_system(); });
      // The solution is none of the solver's own.
      matrix_bytes = allocated_bytes() - bytes_at_start - mesh_bytes;
    }

    Method
    geometric_method()
    {
      Method       method = common("geometric");
      const double start  = allocated_bytes();
      method.meshes_s += seconds([&]() {
        geometric = std::make_unique<GeometricMultigrid<dim>>(*problem);
      });
      const double with_dofs = allocated_bytes();
      method.assembly_s += seconds([&]() { geometric->assemble_levels(); });
      method.preconditioner_s = seconds([&]() { geometric->set_up(); });
      method.mesh_bytes += with_dofs - start;
      method.bytes += allocated_bytes() - with_dofs;
      method.repetitions = 3;
      use_conjugate_gradients(method, *geometric);
      return method;
    }

    Method
    algebraic_method()
    {
      Method       method = common("algebraic");
      const double start  = allocated_bytes();
      algebraic           = std::make_unique<AlgebraicMultigrid<dim>>(*problem);
      method.assembly_s += seconds([&]() { algebraic->copy_matrix(); });
      method.preconditioner_s = seconds([&]() { algebraic->set_up(); });
      // In place of the matrix of deal.II.
      method.bytes       = allocated_bytes() - start;
      method.repetitions = 2;
      use_conjugate_gradients(method, *algebraic);
      return method;
    }

    Method
    umfpack_method()
    {
      Method       method = common("umfpack");
      const double start  = allocated_bytes();
      umfpack             = std::make_unique<SparseDirectUMFPACK>();
      method.preconditioner_s =
        seconds([&]() { umfpack->factorize(problem->system_matrix); });
      method.bytes += allocated_bytes() - start;
      auto &x      = solutions["umfpack"];
      method.solve = [&]() {
        x = problem->rhs;
        umfpack->solve(x);
        problem->constraints.set_zero(x);
        return std::make_pair(1u, 0u);
      };
      return method;
    }

    Method
    mumps_method()
    {
      Method       method     = common("mumps");
      const double start      = allocated_bytes();
      mumps                   = std::make_unique<MumpsSolver<dim>>(*problem);
      method.preconditioner_s = seconds([&]() { mumps->factorise(); });
      method.bytes            = allocated_bytes() - start;
      auto &x                 = solutions["mumps"];
      method.solve            = [&]() {
        x = problem->rhs;
        mumps->solve(x, problem->rhs);
        problem->constraints.set_zero(x);
        return std::make_pair(1u, 0u);
      };
      return method;
    }

    /** By CG where there is a preconditioner, else by the factorisation. */
    const Vector<double> &
    reference()
    {
      Vector<double> &x = solutions["reference"];
      if (x.size() > 0)
        return x;
      x.reinit(problem->rhs.size());
      if (geometric)
        solve_exactly(problem->system_matrix, *geometric, x, problem->rhs);
      else if (algebraic)
        solve_exactly(problem->system_matrix, *algebraic, x, problem->rhs);
      else
        x = solutions[umfpack ? "umfpack" : "mumps"];
      return x;
    }

    /** Relative difference to the solution of the other discretisation. */
    double
    difference(CoupledLimit<dim> &coupled)
    {
      unsigned int   n_nodes, n_doubled;
      const auto     values = coupled.values_by_position(n_nodes, n_doubled);
      Vector<double> other(problem->rhs.size());
      AssertThrow(problem->dof_handler.n_dofs() ==
                    types::global_dof_index(n_nodes - n_doubled) * dim,
                  ExcMessage("The meshes are not alike."));
      std::vector<Point<dim>> points(other.size());
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                           problem->dof_handler,
                                           points);
      const FiniteElement<dim>            &fe = problem->dof_handler.get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : problem->dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (!problem->constraints.is_constrained(dofs[i]))
              other(dofs[i]) = values.at(CoupledLimit<dim>::key(
                points[dofs[i]]))[fe.system_to_component_index(i).first];
        }
      Vector<double> own = reference();
      problem->constraints.set_zero(own);
      return relative_energy_error(problem->system_matrix, other, own);
    }

  private:
    Method
    common(const std::string &name)
    {
      Method method;
      method.name       = name;
      method.unknowns   = problem->dof_handler.n_dofs();
      method.meshes_s   = meshes_s;
      method.assembly_s = assembly_s;
      method.mesh_bytes = mesh_bytes;
      method.bytes      = matrix_bytes;
      solutions[name].reinit(problem->rhs.size());
      method.error = [this, name]() {
        return relative_energy_error(problem->system_matrix,
                                     solutions[name],
                                     reference());
      };
      return method;
    }

    template <typename Preconditioner>
    void
    use_conjugate_gradients(Method &method, const Preconditioner &P)
    {
      auto &x        = solutions[method.name];
      auto &n        = n_steps[method.name];
      method.prepare = [this, &n, &P]() {
        n = count_steps(problem->system_matrix, P, problem->rhs, reference());
      };
      method.solve = [this, &x, &n, &P]() {
        take_steps(problem->system_matrix, P, x, problem->rhs, n);
        return std::make_pair(n, n);
      };
    }

    std::unique_ptr<WeldedProblem<dim>>      problem;
    std::unique_ptr<GeometricMultigrid<dim>> geometric;
    std::unique_ptr<AlgebraicMultigrid<dim>> algebraic;
    std::unique_ptr<SparseDirectUMFPACK>     umfpack;
    std::unique_ptr<MumpsSolver<dim>>        mumps;
    std::map<std::string, Vector<double>>    solutions;
    /** Steps of CG. */
    std::map<std::string, unsigned int> n_steps;
    double meshes_s = 0, assembly_s = 0, mesh_bytes = 0, matrix_bytes = 0;
  };
} // namespace Measure

#endif
