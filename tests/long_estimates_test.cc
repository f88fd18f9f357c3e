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
} // namespace



// Every so many steps of the published spring slider, through all of its events.
TEST(LongEstimates, AreThatOfTheErrorUpToTheLastEvent)
{
  SteppingScene scene(published_scene("spring_slider",
                                      {"TNNMG/Tolerance=1e-12",
                                       "Time/Rate-state tolerance=1e-12"}));
  std::vector<double> faults, bodies;
  for (unsigned int i = 1; scene.state.time < 59.; ++i)
    {
      const SystemState<2> before = scene.state;
      const double         tau    = scene.advance().back().step_size;
      if (i % 200 != 0)
        continue;
      const StepError error    = error_of_last_step(scene, before, tau),
                      estimate = scene.memory.last_error;
      faults.push_back(estimate.faults / error.faults);
      bodies.push_back(estimate.bodies / error.bodies);
      std::cout << scene.state.time << ' ' << tau << ' ' << estimate.faults
                << ' ' << error.faults << ' ' << estimate.bodies << ' '
                << error.bodies << std::endl;
    }
  for (const std::vector<double> *ratios : {&faults, &bodies})
    std::cout << "ratios: least " << quantile(*ratios, 0.) << ", tenth "
              << quantile(*ratios, 0.1) << ", median "
              << quantile(*ratios, 0.5) << ", nine tenths "
              << quantile(*ratios, 0.9) << ", largest "
              << quantile(*ratios, 1.) << std::endl;
}
