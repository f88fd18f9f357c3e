// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/faults/fault_norm.h>

#include <cmath>
#include <sstream>

#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  bool
  is_on_grid(const double step_size, const double largest_step)
  {
    const double halvings = std::log2(largest_step / step_size);
    return halvings >= 0. && halvings == std::round(halvings) &&
           step_size == largest_step * std::exp2(-halvings);
  }



  // Run a scene to its end; all accepted steps.
  std::vector<StepResult<2>>
  run(SteppingScene &scene)
  {
    std::vector<StepResult<2>> steps;
    while (!scene.controller->is_finished(scene.state.time))
      for (StepResult<2> &step : scene.advance())
        steps.push_back(std::move(step));
    return steps;
  }



  // The estimated error of a step of size tau that ends at t = 1, after
  // steps of the same size. The loading begins smoothly, without waves.
  double
  estimated_error(const double tau)
  {
    std::ostringstream text;
    text.precision(17);
    text << tau;
    const std::string step_size = text.str();
    SteppingScene     scene(creeping_bodies,
                        {"Time/Largest step=" + step_size,
                             "Time/Initial step=" + step_size,
                             "Time/Tolerance=1e9",
                             "Boundary conditions/upper top/x value=4e-3*t^4",
                             "Boundary conditions/upper top/Ramp length=0",
                             "Time/Rate-state tolerance=1e-12",
                             "TNNMG/Tolerance=1e-12"});
    while (scene.state.time < 1.)
      EXPECT_EQ(scene.advance().front().step_size, tau);
    EXPECT_EQ(scene.state.time, 1.);
    return scene.memory.last_error.faults;
  }



  // Contact as Simulation rebuilds it after large slip, but with the
  // reference positions again.
  void
  rebuild_contact(SteppingScene &scene)
  {
    scene.problem.build_contact(scene.problem.make_vector());
    scene.prepare();
  }
} // namespace



TEST(StepSizes, AreTheSameWheneverTheClockStarts)
{
  // After 30000 years the time has an error of 0.1 ms; sizes of steps have
  // none.
  for (const std::string control : {"embedded", "step doubling"})
    {
      SCOPED_TRACE(control);
      const auto steps_from = [&control](const double start) {
        SteppingScene scene(creeping_bodies,
                            {"Time/Step size control=" + control,
                             "Time/Largest step=0.01",
                             "Time/Initial step=1e-3",
                             "Time/Tolerance=1e-6",
                             "Time/Doubling threshold=1e-6",
                             "Time/End time=2e12",
                             "Boundary conditions/upper top/Ramp length=0"});
        scene.state.time = start;
        std::vector<double> values;
        for (unsigned int i = 0; i < 60; ++i)
          for (const StepResult<2> &step : scene.advance())
            values.push_back(step.step_size);
        values.push_back(scene.memory.last_error.faults);
        values.push_back(scene.memory.last_error.bodies);
        values.push_back(scene.state.alpha.front());
        return values;
      };
      EXPECT_EQ(steps_from(0.), steps_from(1e12));
    }
}



TEST(StepSizes, AreOnTheGridAndEndAtTheEnd)
{
  // Neither the end nor the ramp fit to the grid.
  for (const std::string control : {"embedded", "step doubling", "constant"})
    {
      SCOPED_TRACE(control);
      const double                     largest = 0.1;
      SteppingScene                    scene(creeping_bodies,
                          {"Time/Step size control=" + control,
                                              "Time/Largest step=0.1",
                                              "Time/Initial step=0.003",
                                              "Time/Doubling threshold=1e-4",
                                              "Time/End time=1.2345",
                                              "Boundary conditions/upper top/Ramp length=0.77"});
      double                           time = 0, smallest = 1e9;
      const std::vector<StepResult<2>> steps = run(scene);
      // Step doubling takes two steps to the end.
      const unsigned int n_last = control == "step doubling" ? 2 : 1;
      for (unsigned int i = 0; i < steps.size(); ++i)
        {
          const double tau = steps[i].step_size;
          if (i + n_last < steps.size())
            {
              EXPECT_TRUE(is_on_grid(tau, largest)) << tau;
            }
          if (control != "constant" && time < 0.77)
            {
              EXPECT_LE(tau, 0.77 / 40.);
            }
          EXPECT_DOUBLE_EQ(steps[i].state.time, time + tau);
          time     = steps[i].state.time;
          smallest = std::min(smallest, tau);
        }
      EXPECT_DOUBLE_EQ(time, 1.2345);
      EXPECT_LT(smallest, largest);
      if (control == "embedded")
        {
          // The ramp stops holding the steps back once it has ended.
          double after_ramp = 0;
          for (const StepResult<2> &step : steps)
            after_ramp = std::max(after_ramp, step.step_size);
          EXPECT_GT(after_ramp, 0.77 / 40.);
        }
    }
}



TEST(StepSizes, ConstantStepsThatDivideTheRunAreAllEqual)
{
  SteppingScene scene(creeping_bodies,
                      {"Time/Step size control=constant",
                       "Time/Largest step=0.1",
                       "Time/End time=2"});
  const auto    steps = run(scene);
  EXPECT_EQ(steps.size(), 20u);
  for (const StepResult<2> &step : steps)
    EXPECT_NEAR(step.step_size, 0.1, 1e-13);
  EXPECT_DOUBLE_EQ(scene.state.time, 2.);
  EXPECT_EQ(scene.memory.n_solved, 20u);
}



TEST(StepSizes, FollowLoadsThatDependOnTime)
{
  // A load that is not felt by the fault, which cannot slip.
  for (const std::string control : {"embedded", "step doubling"})
    {
      SCOPED_TRACE(control);
      const double  omega = 2. * numbers::PI / 10.;
      SteppingScene scene(
        creeping_bodies,
        {"Time/Step size control=" + control,
         "Time/Largest step=1",
         "Time/Initial step=1e-3",
         "Time/End time=12",
         "Time/Loading tolerance=1e-3",
         "Faults/fault/Reference friction coefficient=100",
         "Boundary conditions/upper top/x value=1e-3*cos(2*pi*t/10)",
         "Boundary conditions/upper top/Ramp length=0"});
      const std::vector<StepResult<2>> steps   = run(scene);
      double                           largest = 0;
      for (const StepResult<2> &step : steps)
        largest = std::max(largest, step.step_size);
      // (omega tau)^2 / 12 is the error where the load is largest.
      EXPECT_LE(std::pow(omega * largest, 2) / 12., 4e-3);
      EXPECT_GT(largest, 0.05);
    }
}



TEST(StepDoubling, TakesThreeSolvesAndReusesTheFirstAfterARejection)
{
  SteppingScene scene(creeping_bodies,
                      {"Time/Step size control=step doubling",
                       "Time/Largest step=0.0625",
                       "Time/Initial step=0.015625",
                       "Time/Doubling threshold=1e-7"});
  unsigned int  n_with_rejection = 0, n_without = 0;
  while (scene.state.time < 1.)
    {
      const double        start    = scene.state.time;
      const unsigned long solved   = scene.memory.n_solved;
      const unsigned int  rejected = scene.memory.n_rejected;
      const auto          pair     = scene.advance();
      const unsigned int  n        = scene.memory.n_rejected - rejected;
      ASSERT_EQ(pair.size(), 2u);
      EXPECT_EQ(pair[0].step_size, pair[1].step_size);
      EXPECT_EQ(pair[0].state.time, start + pair[0].step_size);
      EXPECT_EQ(pair[1].state.time, pair[0].state.time + pair[1].step_size);
      EXPECT_EQ(scene.memory.n_solved - solved, 3u + 2u * n);
      ++(n > 0 ? n_with_rejection : n_without);
    }
  EXPECT_GT(n_with_rejection, 2u);
  EXPECT_GT(n_without, 2u);
}



TEST(StepDoubling, AcceptsWhatAgreesWithOneLargeStep)
{
  SteppingScene scene(creeping_bodies,
                      {"Time/Step size control=step doubling",
                       "Time/Largest step=0.0625",
                       "Time/Initial step=0.015625"});
  const double  threshold = scene.scene.time.doubling_threshold;
  SteppingScene other(creeping_bodies);
  double        last = 0;
  while (scene.state.time < 0.5)
    {
      const SystemState<2> before = scene.state;
      const auto           pair   = scene.advance();
      last                        = pair[0].step_size;
      const StepResult<2> large   = other.step->take(before, 2. * last);
      ASSERT_TRUE(large.converged);
      std::vector<double> difference = large.state.alpha;
      for (unsigned int k = 0; k < difference.size(); ++k)
        difference[k] -= pair[1].state.alpha[k];
      EXPECT_LE(fault_norm(scene.faults, scene.laws, difference),
                1.001 * threshold);
    }
}



TEST(StepDoubling, DoublesWhereALongerStepIsExpectedToPass)
{
  SteppingScene scene(creeping_bodies,
                      {"Time/Step size control=step doubling",
                       "Time/Initial step=0.00390625",
                       "Time/Doubling threshold=7e-6",
                       "Time/Ramp fraction=1"});
  const double  threshold = scene.scene.time.doubling_threshold;
  SteppingScene other(creeping_bodies);
  unsigned int  n_pairs = 0, n_doubled = 0, n_kept = 0;
  bool          should_double = false;
  double        last          = 0;
  while (scene.state.time < 1.)
    {
      const SystemState<2> before   = scene.state;
      const unsigned int   rejected = scene.memory.n_rejected;
      const auto           pair     = scene.advance();
      const double         tau      = pair[0].step_size;
      const bool is_first_attempt   = scene.memory.n_rejected == rejected;
      if (++n_pairs > 1 && is_first_attempt &&
          tau < scene.scene.time.largest_step)
        {
          EXPECT_EQ(tau, should_double ? 2. * last : last);
          ++(should_double ? n_doubled : n_kept);
        }
      last = tau;

      const StepResult<2> large      = other.step->take(before, 2. * tau);
      std::vector<double> difference = large.state.alpha;
      for (unsigned int k = 0; k < difference.size(); ++k)
        difference[k] -= pair[1].state.alpha[k];
      should_double =
        4. * fault_norm(scene.faults, scene.laws, difference) <= threshold;
    }
  EXPECT_GT(n_doubled, 2u);
  EXPECT_GT(n_kept, 2u);
}



TEST(EmbeddedControl, ErrorEstimateScalesWithTheThirdPower)
{
  const double coarse = estimated_error(0x1p-6), fine = estimated_error(0x1p-7),
               finest = estimated_error(0x1p-8);
  RecordProperty("order", std::to_string(std::log2(fine / finest)));
  EXPECT_NEAR(std::log2(coarse / fine), 3., 0.25);
  EXPECT_NEAR(std::log2(fine / finest), 3., 0.15);
}



TEST(EmbeddedControl, HistorySurvivesARebuiltContactMapping)
{
  // Coarse levels that lag behind would remember the time before.
  const std::vector<std::string> no_lag = {"TNNMG/Coarse update threshold=0"};
  SteppingScene kept(creeping_bodies, no_lag), rebuilt(creeping_bodies, no_lag);
  kept.advance_until(1.2);
  rebuilt.advance_until(1.2);
  ASSERT_TRUE(same_bits(kept.state, rebuilt.state));

  // Once more the mapping that is there: nothing may change in the following
  // steps, neither their size nor their prediction.
  rebuild_contact(rebuilt);
  const auto estimate = [](const SteppingScene &scene) {
    return scene.memory.last_error.faults;
  };
  for (unsigned int i = 0; i < 4; ++i)
    {
      const auto counts         = kept.advance().front().counts;
      const auto counts_rebuilt = rebuilt.advance().front().counts;
      EXPECT_EQ(counts_rebuilt.multigrid_cycles, counts.multigrid_cycles);
      EXPECT_GT(estimate(kept), 0.);
      EXPECT_EQ(estimate(rebuilt), estimate(kept));
      EXPECT_TRUE(same_bits(rebuilt.state, kept.state));
    }
}



// Lengths, velocities and displacements by the same factor at equal stresses:
// times stay as they are where the density falls by its square.
TEST(EmbeddedControl, TakesTheSameStepsOnFaultsOfAnySize)
{
  constexpr double size   = 8192.;
  const auto       scaled = [](const double value) {
    std::ostringstream text;
    text.precision(17);
    text << value * size;
    return text.str();
  };
  Settings large = {"Faults/fault/Initial state=1 + 0.2 * x / 8192",
                    "Faults/fault/Reference slip rate=" + scaled(1e-3),
                    "Faults/fault/Characteristic slip=" + scaled(1e-3),
                    "Boundary conditions/upper top/x value=" + scaled(1e-3),
                    "Bodies/Base elevation=" + scaled(-0.5)};
  for (const std::string body : {"Bodies/lower/", "Bodies/upper/"})
    large =
      large +
      Settings{body + "Lower lateral corner=" + scaled(-1.),
               body + "Upper lateral corner=" + scaled(1.),
               body + "Thickness=" + scaled(0.5),
               body + "Material/Density=" + scaled(5e3 / size / size / size)};
  const auto steps_of = [](const Settings &overrides) {
    SteppingScene       scene(creeping_bodies, overrides);
    std::vector<double> steps;
    for (const StepResult<2> &step : run(scene))
      steps.push_back(step.step_size);
    EXPECT_GT(scene.memory.largest_error.faults, 0.);
    return steps;
  };
  const std::vector<double> small_steps = steps_of({});
  EXPECT_GT(small_steps.size(), 50u);
  EXPECT_EQ(steps_of(large), small_steps);
}



// Parts of a fault with a known slip rate, and other faults, do not dilute the
// error.
TEST(FaultNorm, IsTheMeanSquareOfTheFaultThatSlipsFreely)
{
  SteppingScene scene(creeping_bodies);
  NodeLaws     &laws = scene.laws;
  EXPECT_NEAR(fault_norm(scene.faults,
                         laws,
                         std::vector<double>(scene.faults.size(), 3.)),
              3.,
              1e-14);
  laws.laws.push_back(laws.laws.front());
  laws.laws.back().is_prescribed = true;
  std::vector<double> values(scene.faults.size(), 3.);
  for (unsigned int k = 0; k < values.size() / 2; ++k)
    {
      laws.of_node[k] = laws.laws.size() - 1;
      values[k]       = 100.;
    }
  EXPECT_NEAR(fault_norm(scene.faults, laws, values), 3., 1e-14);
}
