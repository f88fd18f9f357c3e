// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_coupled_limit_h
#define stickslip_contrib_coupled_limit_h

#include <stickslip/multigrid/linearised_operator.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <map>

#include "coupled_problem.h"
#include "frozen_faults.h"
#include "linear_method.h"
#include "welded_problem.h"

namespace Measure
{
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
      const double tau          = scene.time.initial_step;
      const double bytes_before = allocated_bytes();
      combine_time              = seconds(
        [&]() { problem.combine(Newmark<dim>().operator_coefficients(tau)); });
      active = hierarchy.finest().fixed;
      for (const unsigned int p : hierarchy.finest().nonsmooth_nodes)
        active.mask_node(p);
      // Levels are made here first.
      linearise_time = seconds([&]() { freeze(); });
      level_bytes    = allocated_bytes() - bytes_before;
      set_rhs(tau);
    }

    Method
    conjugate_gradients_method()
    {
      Method method      = common("coupled");
      method.repetitions = 3;
      method.prepare     = [this]() {
        const NodalVector &solution = reference();
        freeze();
        n_steps = count_steps(LinearisedOperator<dim>{hierarchy},
                              CyclePreconditioner<dim>{hierarchy},
                              rhs,
                              solution);
      };
      method.solve = [this]() {
        freeze();
        take_steps(LinearisedOperator<dim>{hierarchy},
                   CyclePreconditioner<dim>{hierarchy},
                   w,
                   rhs,
                   n_steps);
        return std::make_pair(n_steps, n_steps);
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
          solve_exactly(LinearisedOperator<dim>{hierarchy},
                        CyclePreconditioner<dim>{hierarchy},
                        reference_solution,
                        rhs);
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
        // Not near the middle between two integers.
        result[d] = std::lround(point[d] * 1e6 * numbers::SQRT2);
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
      method.bytes            = coupled.problem_bytes + level_bytes;
      method.error            = [this]() {
        // The last solve was another one's.
        const NodalVector solution = w;
        return relative_energy_error(LinearisedOperator<dim>{hierarchy},
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
        .apply(acceleration);
      w = problem.make_vector();
      problem.to_jumps(w, acceleration);
      NodalVector force = w;
      problem.term(SpatialProblem<dim>::mass).vmult(force, w);
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
    /** Steps of CG. */
    unsigned int n_steps      = 0;
    double       combine_time = 0, linearise_time = 0, level_bytes = 0;
  };
} // namespace Measure

#endif
