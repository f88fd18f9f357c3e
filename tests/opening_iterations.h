// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_opening_iterations_h
#define stickslip_tests_opening_iterations_h

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "opening_layers.h"

namespace StickSlip::Tests
{
  /** Faults that are sheared, and pulled on half of their length. */
  template <int dim>
  std::pair<double, double>
  alternating_traction(const Point<dim> &x, const unsigned int fault)
  {
    return {0.65, std::sin(2. * x[0] + 0.3 + fault) + 0.1};
  }

  /** States over seven decades, from node to node. */
  template <int dim>
  double
  rough_alpha(const Point<dim> &, const unsigned int k)
  {
    return 8. * std::sin(12.9898 * (k + 1.));
  }

  /** Two of three nodes touch, at the others there is a gap. */
  template <int dim>
  double
  some_gaps(const Point<dim> &, const unsigned int k)
  {
    return k % 3 == 0 ? -1e-3 : 0.;
  }



  /** Starts of iterations. */
  enum class Start
  {
    zero,
    all_open,
    random,
    /** The solution, a million times too fast. */
    too_fast,
    /** The solution, one percent too fast. */
    near
  };

  constexpr Start all_starts[] = {Start::zero,
                                  Start::all_open,
                                  Start::random,
                                  Start::too_fast,
                                  Start::near};

  template <int dim>
  NodalVector
  make_start(OpeningLayers<dim> &layers,
             const Start         start,
             const NodalVector  &solution)
  {
    const LevelDescription<dim> &finest = layers.problem.hierarchy().finest();
    std::mt19937                 engine(3);
    std::normal_distribution<double> normal;
    NodalVector                      w = layers.start();
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        if (finest.fixed.is_active(i, c))
          {
            double &value = w.local_element(i * dim + c);
            if (start == Start::random)
              value = 1e-2 * normal(engine);
            if (start == Start::too_fast)
              value = 1e6 * solution.local_element(i * dim + c);
            if (start == Start::near)
              value = 1.01 * solution.local_element(i * dim + c);
          }
    if (start == Start::all_open)
      layers.for_each_contact_node([&](const unsigned int node,
                                       const Point<dim> &,
                                       const unsigned int,
                                       const double,
                                       const int sign) {
        if (finest.fixed.is_active(node, dim - 1))
          w.local_element(node * dim + dim - 1) = sign;
      });
    return w;
  }



  /** Iterations of a step from all starts. */
  template <int dim>
  std::vector<unsigned int>
  count_iterations(OpeningLayers<dim>  &layers,
                   const Friction<dim> &friction,
                   const NodalVector   &b,
                   NodalVector         &solution)
  {
    const TNNMGParameters parameters;
    TNNMGSolver<dim>      solver(layers.problem.hierarchy(), parameters);
    solver.find_correction_decrease();
    std::vector<unsigned int> counts;
    for (const Start start : all_starts)
      {
        NodalVector        w       = make_start(layers, start, solution);
        const SolveSummary summary = solver.solve(*friction.functional, b, w);
        EXPECT_TRUE(summary.converged) << summary;
        counts.push_back(summary.iterations.size());
        for (const IterationSummary &iteration : summary.iterations)
          {
            // Up to rounding, which is all there is in the last ones.
            const double size = iteration.iterate_norm * iteration.iterate_norm;
            EXPECT_GE(iteration.smoother_decrease, -1e-13 * size);
            EXPECT_GE(iteration.correction_decrease, -1e-13 * size);
          }
        if (start == Start::zero)
          solution = w;
      }
    return counts;
  }



  /** Expect that faults that open take at most twice the iterations that they
   * take if they do not. Returns the numbers of the former. */
  template <int dim>
  std::vector<unsigned int>
  expect_few_iterations(const std::string                    &name,
                        const std::vector<BodyGeometry<dim>> &bodies,
                        const double                          tau)
  {
    OpeningLayers<dim>        opening(bodies, true), bilateral(bodies, false);
    NodalVector               solution;
    std::vector<unsigned int> without =
      count_iterations(bilateral,
                       bilateral.friction(rough_alpha<dim>),
                       bilateral.set_step(tau, alternating_traction<dim>),
                       solution);
    Friction<dim> friction = opening.friction(rough_alpha<dim>);
    opening.let_open(friction, some_gaps<dim>);
    const std::vector<unsigned int> with =
      count_iterations(opening,
                       friction,
                       opening.set_step(tau, alternating_traction<dim>),
                       solution);
    std::cout << name << ", tau = " << tau << ", "
              << opening.n_open(friction, solution) << " of "
              << friction.terms.size() << " nodes open:";
    // Bilateral faults have no start with all nodes open: that is zero, too.
    for (unsigned int i = 0; i < with.size(); ++i)
      {
        std::cout << ' ' << with[i] << " (" << without[i] << ')';
        EXPECT_LE(with[i], 2 * without[i]);
      }
    std::cout << std::endl;
    return with;
  }



  /** Iterations are as many on all meshes, up to a few. */
  inline void
  expect_level(const std::vector<std::vector<unsigned int>> &counts)
  {
    for (unsigned int i = 0; i < counts.front().size(); ++i)
      {
        unsigned int least = 1000, most = 0;
        for (const auto &of_mesh : counts)
          {
            least = std::min(least, of_mesh[i]);
            most  = std::max(most, of_mesh[i]);
          }
        EXPECT_LE(most - least, 4u) << "start " << i;
      }
  }
} // namespace StickSlip::Tests

#endif
