// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/faults/fault_norm.h>

#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

// A step of several characteristic slips, in which friction weakens and has
// more to say than the bodies: changes shrink by 0.7 from iteration to
// iteration, and what is to come after the last one is more than twice of it.
TEST(Settling, LeavesLessThanTheTolerance)
{
  SteppingScene scene(creeping_bodies,
                      {"Faults/fault/b=0.03",
                       "Faults/fault/Normal stress function=2e6",
                       "Time/Rate-state method=nested",
                       "Time/Initial step=1e-2",
                       "TNNMG/Tolerance=1e-13"});
  scene.advance_until(1.5);
  unsigned int n_iterations = 0;
  const auto   state_with   = [&](const double tolerance) {
    scene.scene.time.rate_state_tolerance = tolerance;
    const StepResult<2> result            = scene.step->take(scene.state, 5.);
    EXPECT_TRUE(result.converged) << tolerance << result.failure;
    n_iterations = result.counts.rate_state_iterations;
    return result.state.alpha;
  };
  const std::vector<double> exact = state_with(1e-12);
  for (double tolerance = 1e-3; tolerance > 1e-7; tolerance /= 3.)
    {
      std::vector<double> error = state_with(tolerance);
      for (unsigned int k = 0; k < error.size(); ++k)
        error[k] -= exact[k];
      EXPECT_LE(fault_norm(scene.faults, scene.laws, error), tolerance);
    }
  EXPECT_GT(n_iterations, 15u);
}
