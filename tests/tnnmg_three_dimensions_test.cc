// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(TNNMG, ThreeDimensionsTakeAsFewIterations)
{
  // Across the direction of slip friction is mu / a times as stiff as along
  // it. Where that kept sliding nodes from the linear correction, problems
  // took up to 31 iterations.
  const std::function<double(const double, const unsigned int)> states[] = {
    [](const double, const unsigned int) { return 12.; },
    [](const double, const unsigned int) { return -9.; },
    [](const double x, const unsigned int) { return x < 0 ? -9. : 9.; },
    [](const double, const unsigned int k) {
      return 8. * std::sin(12.9898 * (k + 1.));
    }};

  for (const double tau : {1e-3, 1e-2, 1e-1})
    for (unsigned int i = 0; i < 4; ++i)
      {
        std::vector<unsigned int> counts;
        for (const unsigned int n_passes : {0, 1, 2})
          {
            LayeredSliderIn<3> slider({{5, 5, 1}}, {{7, 7, 2}}, n_passes);
            const NodalVector  b = slider.set_step(tau, 2.5e4);
            const Friction<3>  friction =
              slider.friction(Kind::truncated, states[i]);
            const TNNMGParameters parameters;
            NodalVector           w = slider.start();
            const SolveSummary    summary =
              TNNMGSolver<3>(slider.problem.hierarchy(), parameters)
                .solve(*friction.functional, b, w);
            EXPECT_TRUE(summary.converged) << summary;
            counts.push_back(summary.iterations.size());
          }
        std::cout << "tau = " << tau << ", state " << i << ": " << counts[0]
                  << ' ' << counts[1] << ' ' << counts[2] << '\n';
        for (const unsigned int n : counts)
          EXPECT_LE(n, 9u);
      }
}
