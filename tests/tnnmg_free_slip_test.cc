// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(TNNMG, FaultsThatSlideFreelyAreALinearProblem)
{
  // With this state there is no friction up to a rate that nothing reaches.
  LayeredSlider   slider({{10, 2}}, {{10, 2}}, 4);
  TNNMGParameters parameters;
  parameters.tolerance = 1e-11;
  for (const double tau : {1e-1, 1e-2, 1e-3})
    {
      const NodalVector rhs = slider.set_step(tau, 2.5e4);
      const Friction<2> friction =
        slider.friction(Kind::truncated,
                        [](const double, const unsigned) { return -60.; });
      TNNMGSolver<2>     solver(slider.problem.hierarchy(), parameters);
      NodalVector        w       = slider.start();
      const SolveSummary summary = solver.solve(*friction.functional, rhs, w);
      EXPECT_TRUE(summary.converged);
      // 40 and more where the nodes are left to the smoother alone.
      EXPECT_LE(summary.iterations.size(), 14u) << tau;
      EXPECT_EQ(summary.iterations.back().n_truncated, 0u);

      NodalVector residual = rhs;
      slider.problem.operators().matrix().residual(residual, rhs, w);
      slider.problem.hierarchy().finest().fixed.apply(residual);
      EXPECT_LE(residual.l2_norm(), 1e-8 * rhs.l2_norm());
    }
}
