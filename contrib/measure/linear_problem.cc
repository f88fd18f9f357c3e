// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * linear_problem FILE.prm [--set ENTRY=VALUE]... [--solvers NAMES]
 *                [--repetitions N]
 *
 * Measures the linear limit of a rate problem: the operator of the scene's
 * first time step, of size Time/Initial step, with the faults welded, under
 * gravity, tractions and an acceleration that changes from node to node. NAMES
 * are some of
 *
 *   geometric   CG with the geometric multigrid method of deal.II
 *   algebraic   CG with ML of Trilinos
 *   coupled     CG with the V-cycle of this program
 *   tnnmg       TNNMG with its own criterion to stop
 *   umfpack, mumps
 *
 * separated by commas; those with CG stop when the residual is 1e-8 times the
 * first one. The solvers take turns, and the shortest time of each counts.
 * Prints a row for each. Bytes are what is allocated for matrices and
 * preconditioner, without the meshes; the error is that in the energy norm,
 * relative to the solution; cross_check is the difference between the solutions
 * of both discretisations in the same norm.
 */

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <stickslip/simulation/command_line.h>
#include <stickslip/simulation/scene_reader.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <map>

#include "algebraic_multigrid.h"
#include "coupled_problem.h"
#include "frozen_faults.h"
#include "geometric_multigrid.h"

namespace
{
  using namespace Measure;

  constexpr double       reduction           = 1e-8;
  constexpr double       reference_reduction = 1e-14;
  constexpr unsigned int max_iterations      = 1000;



  /** One solver, ready to solve, and what has been measured of it. */
  struct Method
  {
    std::string             name;
    types::global_dof_index unknowns = 0;
    double                  meshes_s = 0, assembly_s = 0, preconditioner_s = 0;
    double                  bytes = 0, mesh_bytes = 0;
    /** Solve from zero; returns the numbers of iterations and cycles. */
    std::function<std::pair<unsigned int, unsigned int>()> solve;
    std::function<double()>                                error;
    unsigned int                                           repetitions = 1;

    std::pair<unsigned int, unsigned int> iterations;
    double solve_s = std::numeric_limits<double>::max();
  };



  /** Number of iterations of CG from zero. */
  template <typename Operator, typename Preconditioner, typename VectorType>
  unsigned int
  conjugate_gradients(const Operator       &A,
                      const Preconditioner &preconditioner,
                      VectorType           &x,
                      const VectorType     &b,
                      const double          reduction)
  {
    x = 0.;
    SolverControl        control(max_iterations, reduction * b.l2_norm());
    SolverCG<VectorType> solver(control);
    solver.solve(A, x, b, preconditioner);
    return control.last_step();
  }



  /** The norm of x - y over that of y, in the energy norm. */
  template <typename Operator, typename VectorType>
  double
  relative_energy_error(const Operator   &A,
                        const VectorType &x,
                        const VectorType &y)
  {
    VectorType product = y, difference = x;
    A.vmult(product, y);
    const double size = y * product;
    difference -= y;
    A.vmult(product, difference);
    return std::sqrt(std::abs(difference * product) / size);
  }



  /** The linearised operator and the V-cycle of this program. */
  template <int dim>
  struct CoupledOperator
  {
    LevelHierarchy<dim> &hierarchy;

    void
    vmult(NodalVector &y, const NodalVector &x) const
    {
      hierarchy.vmult_linearised(y, x);
    }
  };

  template <int dim>
  struct CoupledPreconditioner
  {
    LevelHierarchy<dim> &hierarchy;

    void
    vmult(NodalVector &y, const NodalVector &x) const
    {
      hierarchy.v_cycle(y, x);
    }
  };



  /** The discretisation of this program with all jumps frozen. */
  template <int dim>
  class CoupledLimit
  {
  public:
    CoupledLimit(const SceneParameters<dim> &scene)
      : scene(scene)
      , coupled(scene)
      , problem(*coupled.problem)
      , hierarchy(problem.hierarchy())
      , faults(hierarchy.finest().nonsmooth_nodes)
      , solver(hierarchy, scene.tnnmg)
    {
      const double tau = scene.time.initial_step;
      combine_time     = seconds(
        [&]() { hierarchy.combine(Newmark::operator_coefficients(tau)); });
      active = hierarchy.finest().fixed;
      for (const unsigned int p : hierarchy.finest().nonsmooth_nodes)
        active.mask_node(p);
      linearise_time = seconds([&]() { freeze(); });
      set_rhs(tau);
    }

    Method
    conjugate_gradients_method()
    {
      Method method      = common("coupled");
      method.repetitions = 3;
      method.solve       = [this]() {
        freeze();
        const unsigned int n =
          conjugate_gradients(CoupledOperator<dim>{hierarchy},
                              CoupledPreconditioner<dim>{hierarchy},
                              w,
                              rhs,
                              reduction);
        return std::make_pair(n, n);
      };
      return method;
    }

    Method
    tnnmg_method()
    {
      Method method      = common("tnnmg");
      method.repetitions = 3;
      method.solve       = [this]() {
        w                          = 0.;
        const SolveSummary summary = solver.solve(faults, rhs, w);
        AssertThrow(summary.converged, ExcMessage("No convergence."));
        return std::pair<unsigned int, unsigned int>(summary.iterations.size(),
                                                     summary.n_cycles());
      };
      return method;
    }

    const NodalVector &
    reference()
    {
      if (reference_solution.size() == 0)
        {
          freeze();
          reference_solution = problem.make_vector();
          conjugate_gradients(CoupledOperator<dim>{hierarchy},
                              CoupledPreconditioner<dim>{hierarchy},
                              reference_solution,
                              rhs,
                              reference_reduction);
        }
      return reference_solution;
    }

    /** The reference solution by position, and the numbers of nodes. */
    std::map<std::array<long, dim>, Tensor<1, dim>>
    values_by_position(unsigned int &n_nodes, unsigned int &n_doubled)
    {
      NodalVector u = problem.make_nodal_vector();
      problem.to_nodal(u, reference());
      std::map<std::array<long, dim>, Tensor<1, dim>> values;
      const MeshLevel<dim> &finest = coupled.meshes->finest();
      n_nodes = n_doubled = 0;
      for (unsigned int b = 0; b < finest.bodies.size(); ++b)
        {
          const std::vector<Point<dim>> points =
            finest.bodies[b]->node_positions();
          for (unsigned int i = 0; i < points.size(); ++i)
            {
              Tensor<1, dim> value;
              const auto     node = finest.node(b, i);
              for (unsigned int c = 0; c < dim; ++c)
                value[c] = u.local_element(node * dim + c);
              ++n_nodes;
              if (!values.emplace(key(points[i]), value).second)
                ++n_doubled;
            }
        }
      return values;
    }

    static std::array<long, dim>
    key(const Point<dim> &point)
    {
      std::array<long, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = std::lround(point[d] * 1e8);
      return result;
    }

  private:
    Method
    common(const std::string &name)
    {
      Method method;
      method.name             = name;
      method.unknowns         = coupled.n_unknowns();
      method.meshes_s         = coupled.meshes_time;
      method.assembly_s       = coupled.problem_time;
      method.preconditioner_s = combine_time + linearise_time;
      method.mesh_bytes       = coupled.mesh_bytes;
      method.bytes            = coupled.problem_bytes;
      method.error            = [this]() {
        // The last solve was another one's.
        const NodalVector solution = w;
        return relative_energy_error(CoupledOperator<dim>{hierarchy},
                                     solution,
                                     reference());
      };
      return method;
    }

    void
    freeze()
    {
      hierarchy.linearise(std::vector<Tensor<2, dim>>(
                            hierarchy.finest().nonsmooth_nodes.size()),
                          active);
    }

    void
    set_rhs(const double tau)
    {
      const MeshLevel<dim> &finest       = coupled.meshes->finest();
      NodalVector           acceleration = problem.make_nodal_vector();
      for (unsigned int b = 0; b < finest.bodies.size(); ++b)
        {
          const std::vector<Point<dim>> points =
            finest.bodies[b]->node_positions();
          for (unsigned int i = 0; i < points.size(); ++i)
            for (unsigned int c = 0; c < dim; ++c)
              acceleration.local_element(finest.node(b, i) * dim + c) =
                rough_acceleration(points[i], c);
        }
      coupled.boundary->dirichlet_mask(coupled.meshes->n_levels() - 1)
        .local_part(finest.nodes)
        .apply(acceleration);
      w = problem.make_vector();
      problem.to_jumps(w, acceleration);
      NodalVector force = w;
      hierarchy.term(SpatialProblem<dim>::mass).vmult(force, w);
      rhs = problem.load(tau);
      rhs += force;
      active.apply(rhs);
    }

    const SceneParameters<dim> &scene;
    CoupledProblem<dim>         coupled;
    SpatialProblem<dim>        &problem;
    LevelHierarchy<dim>        &hierarchy;
    FrozenFaults<dim>           faults;
    TNNMGSolver<dim>            solver;
    NodeMask                    active;
    NodalVector                 rhs, w, reference_solution;
    double                      combine_time = 0, linearise_time = 0;
  };



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
        conjugate_gradients(problem->system_matrix,
                            *geometric,
                            x,
                            problem->rhs,
                            reference_reduction);
      else if (algebraic)
        conjugate_gradients(problem->system_matrix,
                            *algebraic,
                            x,
                            problem->rhs,
                            reference_reduction);
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
      auto &x      = solutions[method.name];
      method.solve = [this, &x, &P]() {
        const unsigned int n = conjugate_gradients(
          problem->system_matrix, P, x, problem->rhs, reduction);
        return std::make_pair(n, n);
      };
    }

    std::unique_ptr<WeldedProblem<dim>>      problem;
    std::unique_ptr<GeometricMultigrid<dim>> geometric;
    std::unique_ptr<AlgebraicMultigrid<dim>> algebraic;
    std::unique_ptr<SparseDirectUMFPACK>     umfpack;
    std::unique_ptr<MumpsSolver<dim>>        mumps;
    std::map<std::string, Vector<double>>    solutions;
    double meshes_s = 0, assembly_s = 0, mesh_bytes = 0, matrix_bytes = 0;
  };



  template <int dim>
  void
  measure(const SceneParameters<dim> &scene,
          const std::string          &solvers,
          const unsigned int          repetitions)
  {
    std::unique_ptr<CoupledLimit<dim>> coupled;
    std::unique_ptr<WeldedLimit<dim>>  welded;
    std::vector<Method>                methods;
    for (const std::string &name : Utilities::split_string_list(solvers))
      {
        if (name == "coupled" || name == "tnnmg")
          {
            if (!coupled)
              coupled = std::make_unique<CoupledLimit<dim>>(scene);
            methods.push_back(name == "tnnmg" ?
                                coupled->tnnmg_method() :
                                coupled->conjugate_gradients_method());
            continue;
          }
        if (!welded)
          welded = std::make_unique<WeldedLimit<dim>>(scene);
        if (name == "geometric")
          methods.push_back(welded->geometric_method());
        else if (name == "algebraic")
          methods.push_back(welded->algebraic_method());
        else if (name == "umfpack")
          methods.push_back(welded->umfpack_method());
        else if (name == "mumps")
          methods.push_back(welded->mumps_method());
        else
          AssertThrow(false, ExcMessage("There is no solver " + name + "."));
      }

    // In turns: what else the machine does meets all of them.
    for (unsigned int repetition = 0; repetition < repetitions; ++repetition)
      for (Method &method : methods)
        if (repetition < method.repetitions)
          method.solve_s =
            std::min(method.solve_s,
                     seconds([&]() { method.iterations = method.solve(); }));

    const double cross_check =
      welded && coupled ? welded->difference(*coupled) : 0.;
    ResultTable table;
    for (Method &method : methods)
      {
        // Those of the coupled problem share their solution.
        if (method.name == "coupled" || method.name == "tnnmg")
          method.solve();
        table.add("solver", method.name);
        table.add("unknowns", method.unknowns);
        table.add("tau", scene.time.initial_step);
        table.add("iterations", method.iterations.first);
        table.add("cycles", method.iterations.second);
        table.add("meshes_s", method.meshes_s);
        table.add("assembly_s", method.assembly_s);
        table.add("preconditioner_s", method.preconditioner_s);
        table.add("solve_s", method.solve_s);
        table.add("mesh_bytes_per_unknown",
                  method.mesh_bytes / method.unknowns);
        table.add("bytes_per_unknown", method.bytes / method.unknowns);
        table.add("error", method.error());
        table.add("cross_check", cross_check);
        table.add("largest_MiB", largest_resident_size());
        table.end_row();
      }
    table.print();
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      Options           options(argc, argv);
      const std::string solvers =
        options.take_value("--solvers", "geometric,coupled,tnnmg,algebraic");
      const unsigned int repetitions =
        Utilities::string_to_int(options.take_value("--repetitions", "3"));
      AssertThrow(Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1,
                  ExcMessage("This is for one process."));
      const CommandLine arguments = parse_command_line(options.rest());
      const SceneReader reader(arguments.parameter_file, arguments.overrides);
      if (reader.dimension() == 2)
        measure(reader.read<2>(), solvers, repetitions);
      else
        measure(reader.read<3>(), solvers, repetitions);
    }
  catch (const dealii::ExceptionBase &error)
    {
      std::cerr << "linear_problem: ";
      error.print_info(std::cerr);
      return 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << "linear_problem: " << error.what() << std::endl;
      return 1;
    }
}
