// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // The published spring slider with default settings through its first event;
  // run once for all tests.
  const RunHistory &
  first_event()
  {
    static const RunHistory history(
      published_scene("spring_slider", {"Time/End time=24"}));
    return history;
  }
} // namespace



TEST(SpringSlider, LoadsQuietlyAndThenSlips)
{
  const RunHistory &run = first_event();
  ASSERT_FALSE(run.events.empty());
  EXPECT_GT(run.events.front().start, 20.);
  EXPECT_LT(run.events.front().start, 23.5);
  for (const RunHistory::Step &step : run.steps)
    if (step.time < 15.)
      {
        ASSERT_LT(step.fault.mean_slip_rate, 1e-8) << "t = " << step.time;
      }
  EXPECT_GT(run.steps.front().fault.mean_slip_rate, 0.);
}



TEST(SpringSlider, SlipRatesOfTheEventsAreThePublishedOnes)
{
  const RunHistory &run = first_event();
  ASSERT_FALSE(run.events.empty());
  double fastest_node = 0;
  for (const SlipEvent &event : run.events)
    {
      EXPECT_GT(event.peak_mean_slip_rate, 5e-4);
      EXPECT_LT(event.peak_mean_slip_rate, 1e-2);
      EXPECT_GT(event.peak_time, event.start);
      fastest_node = std::max(fastest_node, event.peak_slip_rate);
    }
  EXPECT_GT(fastest_node, 1e-2);
}



TEST(SpringSlider, NucleatesNearTheCentreAndGrowsToBothSides)
{
  const RunHistory &run = first_event();
  ASSERT_FALSE(run.events.empty());
  EXPECT_LT(std::abs(run.events.front().nucleation[0]), 1.);

  // Both halves slip faster than the loading when the whole is fastest.
  double left = 0, right = 0;
  for (unsigned int k = 0; k < run.fastest.points.size(); ++k)
    (run.fastest.points[k][0] < 0 ? left : right) +=
      run.fastest.weights[k] * run.fastest.slip_rate[k].norm() / 2.5;
  EXPECT_GT(left, 2e-4);
  EXPECT_GT(right, 2e-4);
  for (const auto &rate : run.fastest.slip_rate)
    EXPECT_GT(rate[0], 0.);
}



TEST(SpringSlider, StepSizesSpanTwoOrdersOfMagnitude)
{
  // After the ramp, which holds them back.
  double smallest = 1e9, largest = 0;
  for (const RunHistory::Step &step : first_event().steps)
    if (step.time > 2. && step.time < 23.9)
      {
        smallest = std::min(smallest, step.step_size);
        largest  = std::max(largest, step.step_size);
      }
  EXPECT_GT(largest / smallest, 100.);
}



TEST(SpringSlider, StepsStayReasonableWhereNothingPresses)
{
  // Parts of the fault without friction slip at once, as the bodies are not in
  // equilibrium there, and back and forth as the waves pass.
  for (const std::string normal_stress : {"0", "4.9e4 * max(0, 1 - abs(x)/2)"})
    {
      SCOPED_TRACE(normal_stress);
      const RunHistory run(published_scene(
        "spring_slider",
        {"Time/End time=0.03",
         "Faults/fault/Normal stress=function",
         "Faults/fault/Normal stress function=" + normal_stress}));
      EXPECT_NEAR(run.steps.back().time, 0.03, 1e-12);
      EXPECT_LT(run.steps.size(), 3000u);
      EXPECT_GT(run.steps.back().fault.max_slip_rate, 1e-4);
    }
}
