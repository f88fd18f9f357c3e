// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_iteration_counts_h
#define stickslip_tests_iteration_counts_h

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "friction_chain.h"

namespace StickSlip::Tests
{
  /** States alpha of the fault nodes, by name: functions of the place along the
   * fault and of the number of the node. */
  using NamedStates = std::vector<
    std::pair<const char *,
              std::function<double(const double, const unsigned int)>>>;

  /** A fault that sticks, slips, sticks beyond the place @p middle only, and
   * does either at random. */
  inline NamedStates
  stuck_and_slipping(const double middle)
  {
    return {{"stuck", [](const double, const unsigned int) { return 12.; }},
            {"slipping", [](const double, const unsigned int) { return -9.; }},
            {"half and half",
             [middle](const double x, const unsigned int) {
               return x < middle ? -9. : 9.;
             }},
            {"random", [](const double, const unsigned int k) {
               return 8. * std::sin(12.9898 * (k + 1.));
             }}};
  }



  /**
   * Iterations from zero for a Newmark step from @p start, in the order of the
   * step sizes and states. All faults have the same @p normal_stress, Pa, and
   * nodes the @p place that their states are functions of.
   */
  inline std::vector<unsigned int>
  iterations_from_zero(SpatialProblem<2>    &problem,
                       BoundaryValues<2>    &boundary,
                       const SystemState<2> &start,
                       const double          normal_stress,
                       const std::function<double(const Point<2> &)> &place,
                       const NamedStates                             &states,
                       const std::vector<double>                     &taus)
  {
    const LevelDescription<2> &level = problem.hierarchy().finest();
    std::vector<double>        weights(level.nonsmooth_nodes.size()),
      places(level.nonsmooth_nodes.size());
    for (const FaultContact<2> &fault : problem.jump_basis().faults())
      for (unsigned int k = 0; k < fault.slave.nodes.size(); ++k)
        {
          const auto term =
            std::lower_bound(level.nonsmooth_nodes.begin(),
                             level.nonsmooth_nodes.end(),
                             level.nodes.local_index(fault.slave.nodes[k]));
          if (term == level.nonsmooth_nodes.end() ||
              *term != level.nodes.local_index(fault.slave.nodes[k]))
            continue;
          const unsigned int position = term - level.nonsmooth_nodes.begin();
          weights[position]           = fault.coupling.weight[k];
          places[position]            = place(fault.slave.points[k]);
        }

    std::vector<unsigned int> result;
    for (const double tau : taus)
      {
        problem.combine(Newmark<2>().operator_coefficients(tau));
        const NodalVector rhs =
          Newmark<2>().right_hand_side(problem, start, tau);
        for (const auto &[name, alpha] : states)
          {
            std::vector<double> alphas;
            for (unsigned int k = 0; k < places.size(); ++k)
              alphas.push_back(alpha(places[k], k));
            const Friction<2>     friction = make_friction<2>(Kind::truncated,
                                                          level.nonsmooth_nodes,
                                                          weights,
                                                          normal_stress,
                                                          alphas);
            const TNNMGParameters parameters;
            TNNMGSolver<2>        solver(problem.hierarchy(), parameters);
            NodalVector           w = problem.make_vector();
            boundary.set_velocities(start.time, w);
            const SolveSummary summary =
              solver.solve(*friction.functional, rhs, w);
            EXPECT_TRUE(summary.converged) << name << '\n' << summary;
            result.push_back(summary.iterations.size());
          }
      }
    return result;
  }



  /** Counts of several scenes agree up to two, and are small. */
  inline void
  expect_alike(const std::vector<std::vector<unsigned int>> &counts,
               const NamedStates                            &states,
               const std::vector<double>                    &taus)
  {
    for (unsigned int k = 0; k < counts.front().size(); ++k)
      {
        std::string  text;
        unsigned int least = 1000, most = 0;
        for (const auto &of_scene : counts)
          {
            least = std::min(least, of_scene[k]);
            most  = std::max(most, of_scene[k]);
            text += ' ' + std::to_string(of_scene[k]);
          }
        const std::string name =
          std::string(states[k % states.size()].first) +
          ", tau = " + std::to_string(taus[k / states.size()]) + ":" + text;
        std::cout << name << '\n';
        EXPECT_LE(most - least, 2u) << name;
        EXPECT_LE(most, 12u) << name;
      }
  }
} // namespace StickSlip::Tests

#endif
