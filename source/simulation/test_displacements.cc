// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_control.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/faults/fault_nodes.h>
#include <stickslip/problem/stiffness_solution.h>
#include <stickslip/simulation/test_displacements.h>

namespace StickSlip
{
  namespace
  {
    /** Solve for all that is not known, and add the displacements to a list,
     * unless nothing moves. */
    template <int dim, int n_components>
    void
    add_displacement(SpatialProblem<dim, n_components> &problem,
                     const NodalVector                 &load,
                     NodalVector                       &w,
                     TestDisplacement                   displacement,
                     std::vector<TestDisplacement>     &displacements)
    {
      // Energies are right to the square of this.
      constexpr double reduction = 1e-6;

      if (load.l2_norm() == 0. && w.l2_norm() == 0.)
        return;
      const auto &finest = problem.hierarchy().finest();
      NodeMask    active = finest.fixed;
      for (const unsigned int p : finest.nonsmooth_nodes)
        active.mask_node(p);
      const std::string failure = "The error of the meshes was not found: ";
      try
        {
          solve_stiffness(problem, active, load, reduction, w);
        }
      catch (const SingularCoarseMatrix &error)
        {
          throw AgreedFailure(failure + error.what() + ".");
        }
      catch (const SolverControl::NoConvergence &)
        {
          throw AgreedFailure(failure +
                              "the boundary conditions must hold every body.");
        }
      displacement.values = problem.make_nodal_vector();
      problem.to_nodal(displacement.values, w);
      displacements.push_back(std::move(displacement));
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<TestDisplacement>
  test_displacements(SpatialProblem<dim, n_components>   &problem,
                     const double                         time,
                     const std::vector<SlipPattern<dim>> &patterns)
  {
    const auto                   &finest = problem.hierarchy().finest();
    const FaultNodes<dim>         faults(problem.jump_basis(), finest.nodes);
    std::vector<TestDisplacement> displacements;

    const NodalVector load_at_start = problem.load(0.);
    NodalVector       w             = problem.make_vector();
    add_displacement(
      problem, load_at_start, w, {{}, "loads at the start"}, displacements);

    NodalVector velocity = problem.make_nodal_vector();
    problem.boundary_values().set_velocities(time, velocity);
    problem.to_jumps(w, velocity);
    for (const unsigned int k : faults.owned_contact())
      for (unsigned int c = 0; c < n_components; ++c)
        w.local_element(faults.node(k) * n_components + c) = 0.;
    problem.set_known_jumps(time, w);
    NodalVector load = problem.load(time);
    load -= load_at_start;
    add_displacement(problem, load, w, {{}, "loading"}, displacements);

    load = 0.;
    for (const SlipPattern<dim> &pattern : patterns)
      {
        const std::vector<Point<dim>> &points =
          problem.jump_basis().faults()[pattern.fault].slave.points;
        const unsigned int first = faults.first_of_fault()[pattern.fault];
        w                        = 0.;
        for (const unsigned int k : faults.owned_contact())
          if (faults.fault(k) == pattern.fault &&
              finest.fixed.is_active(faults.node(k), 0))
            w.local_element(faults.node(k) * n_components) =
              pattern.slip(points[k - first]);
        add_displacement(problem,
                         load,
                         w,
                         {{}, pattern.name, pattern.allowance},
                         displacements);
      }
    return displacements;
  }



#define STICKSLIP_INSTANTIATE(dim, n_components)             \
  template std::vector<TestDisplacement> test_displacements( \
    SpatialProblem<dim, n_components> &,                     \
    const double,                                            \
    const std::vector<SlipPattern<dim>> &);

  STICKSLIP_INSTANTIATE(2, 1)
  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
} // namespace StickSlip
