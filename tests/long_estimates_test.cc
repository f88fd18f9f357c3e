// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "simulation_scenes.h"
#include "step_errors.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  double
  quantile(std::vector<double> values, const double part)
  {
    std::sort(values.begin(), values.end());
    return values[std::min<std::size_t>(part * values.size(),
                                        values.size() - 1)];
  }



  /** Compare estimates and errors of one step of @p stride up to @p end. */
  void
  expect_right_estimates(const std::string &name,
                         const double       end,
                         const unsigned int stride)
  {
    SteppingScene       scene(published_scene(
      name, {"TNNMG/Tolerance=1e-12", "Time/Rate-state tolerance=1e-12"}));
    std::vector<double> faults, bodies;
    for (unsigned int i = 1; scene.state.time < end; ++i)
      {
        const SystemState<2> before = scene.state;
        const double         tau    = scene.advance().back().step_size;
        if (i % stride != 0)
          continue;
        const StepError error    = error_of_last_step(scene, before, tau),
                        estimate = scene.memory.last_error;
        // Fault and bodies at rest have errors of rounding.
        if (error.faults > 1e-12)
          faults.push_back(estimate.faults / error.faults);
        if (error.bodies > 1e-12)
          bodies.push_back(estimate.bodies / error.bodies);
      }
    std::cout << name << ", " << faults.size() << " steps: ";
    for (const std::vector<double> *ratios : {&faults, &bodies})
      {
        for (const double part : {0., 0.02, 0.1, 0.5, 0.9, 0.98, 1.})
          std::cout << quantile(*ratios, part) << ' ';
        std::cout << std::endl;
        EXPECT_GT(quantile(*ratios, 0.02), 1. / 3.);
        EXPECT_NEAR(quantile(*ratios, 0.5), 1., 0.1);
        EXPECT_LT(quantile(*ratios, 0.98), 3.);
      }
  }
} // namespace



// Estimated errors over true ones, of faults and bodies, through all events.
TEST(LongEstimates, AreThatOfTheErrorInTheSpringSlider)
{
  expect_right_estimates("spring_slider", 59., 200);
}



TEST(LongEstimates, AreThatOfTheErrorInFiveBodies)
{
  expect_right_estimates("layered_five_bodies", 50., 300);
}
