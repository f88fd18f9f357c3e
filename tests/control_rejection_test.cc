// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <sstream>

#include "nan_in_debug_mode.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::vector<std::string> all_controls = {"embedded",
                                                 "step doubling",
                                                 "constant"};



  // Every control, with the sizes of steps that suit the creeping scene.
  std::vector<std::string>
  control_overrides(const std::string &control)
  {
    return {"Time/Step size control=" + control,
            "Time/Largest step=0.0625",
            "Time/Initial step=0.0078125",
            "Time/Smallest step=1e-3",
            "Time/Doubling threshold=1e-4"};
  }



  // A loading velocity that is not a number around one time.
  std::string
  undefined_at(const double time, const double width)
  {
    std::ostringstream expression;
    expression.precision(17);
    expression << "(abs(t-" << time << ")<" << width << ") ? sqrt(-1) : 1e-3";
    return expression.str();
  }



  SteppingScene
  scene_undefined_at(const std::string &control,
                     const double       time,
                     const double       width,
                     const std::string &end_time = "2")
  {
    // Set directly, since the reader of scenes evaluates all functions.
    std::vector<std::string> overrides = control_overrides(control);
    overrides.push_back("Time/End time=" + end_time);
    SceneParameters<2> scene = read_scene(creeping_bodies, overrides);
    scene.boundary_conditions[1].expression[0] = undefined_at(time, width);
    return SteppingScene(scene);
  }



  std::string
  message_of_advance(SteppingScene &scene)
  {
    try
      {
        scene.controller->advance(scene.state, scene.memory);
      }
    catch (const StepSizeTooSmall &error)
      {
        return error.what();
      }
    return "no error";
  }
} // namespace



TEST(Rejection, FailedIterationLeavesTheStateUntouched)
{
  for (const std::string &control : all_controls)
    {
      SCOPED_TRACE(control);
      SteppingScene scene(creeping_bodies, control_overrides(control));
      scene.advance_until(0.3);
      const SystemState<2> before     = scene.state;
      const auto           n_rejected = scene.memory.n_rejected;

      // One iteration never shows that rate and state agree.
      const auto iterations = scene.scene.time.max_rate_state_iterations;
      scene.scene.time.max_rate_state_iterations = 1;
      const std::string message                  = message_of_advance(scene);
      EXPECT_NE(message.find("At t = 0.3"), std::string::npos) << message;
      EXPECT_NE(message.find("Time/Smallest step = 0.001 s"), std::string::npos)
        << message;
      EXPECT_NE(message.find("did not settle within 1 iterations"),
                std::string::npos)
        << message;
      EXPECT_GT(scene.memory.n_rejected, n_rejected);
      EXPECT_TRUE(same_bits(scene.state, before));

      // The run could go on from there.
      scene.scene.time.max_rate_state_iterations = iterations;
      const auto accepted                        = scene.advance();
      EXPECT_TRUE(accepted.back().converged);
      EXPECT_GT(scene.state.time, before.time);
    }
}



TEST(Rejection, ValueThatIsNoNumberIsNeverAccepted)
{
  SKIP_WHERE_NAN_IS_FATAL();
  for (const std::string &control : all_controls)
    {
      SCOPED_TRACE(control);
      // From t = 0.5 on there is no way ahead.
      SteppingScene  scene = scene_undefined_at(control, 1.5, 1.);
      SystemState<2> before;
      std::string    message;
      for (unsigned int i = 0; i < 1000 && message.empty(); ++i)
        {
          before = scene.state;
          try
            {
              scene.advance();
            }
          catch (const StepSizeTooSmall &error)
            {
              message = error.what();
            }
        }
      EXPECT_NE(message.find("not a number"), std::string::npos) << message;
      EXPECT_TRUE(same_bits(scene.state, before));
      EXPECT_LE(scene.state.time, 0.5);
      EXPECT_GT(scene.state.time, 0.5 - 4e-3);
      EXPECT_TRUE(std::isfinite(scene.state.velocity.l2_norm()));
      EXPECT_TRUE(std::isfinite(scene.state.displacement.l2_norm()));
      EXPECT_TRUE(std::isfinite(scene.state.acceleration.l2_norm()));
    }
}



TEST(Rejection, AttemptWithAnotherSizeEqualsAFreshStart)
{
  SKIP_WHERE_NAN_IS_FATAL();
  for (const std::string control : {"constant", "step doubling"})
    {
      SCOPED_TRACE(control);
      SteppingScene pilot(creeping_bodies, control_overrides(control));
      pilot.advance_until(0.4);
      const double time = pilot.state.time;
      const double tau  = pilot.advance().front().step_size;

      // The attempt with tau fails at its end, that with tau/2 passes.
      SteppingScene scene = scene_undefined_at(control, time + tau, 1e-3 * tau);
      scene.advance_until(0.4);
      ASSERT_EQ(scene.state.time, time);
      const SystemState<2> before     = scene.state;
      const auto           n_rejected = scene.memory.n_rejected;
      const StepResult<2>  restarted =
        scene.controller->advance(scene.state, scene.memory).front();
      EXPECT_GT(scene.memory.n_rejected, n_rejected);
      EXPECT_LT(restarted.step_size, tau);

      // With the same past, and made to take the smaller step at once by the
      // end of the run. Times are dyadic here, so that nothing is rounded.
      const double  n_steps = control == "constant" ? 1. : 2.;
      SteppingScene fresh   = scene_undefined_at(control, 9., 1e-3 * tau);
      fresh.advance_until(0.4);
      fresh.scene.time.end_time    = time + n_steps * restarted.step_size;
      const auto          n_before = fresh.memory.n_rejected;
      const StepResult<2> first =
        fresh.controller->advance(fresh.state, fresh.memory).front();
      EXPECT_EQ(fresh.memory.n_rejected, n_before);
      EXPECT_EQ(first.step_size, restarted.step_size);
      EXPECT_TRUE(same_bits(first.state, restarted.state));
      EXPECT_EQ(first.counts.multigrid_cycles,
                restarted.counts.multigrid_cycles);
    }
}



TEST(Rejection, EmbeddedControlForgetsTheFailedAttempt)
{
  SKIP_WHERE_NAN_IS_FATAL();
  SteppingScene pilot(creeping_bodies, control_overrides("embedded"));
  pilot.advance_until(0.4);
  const double time = pilot.state.time;
  const double tau  = pilot.advance().front().step_size;

  SteppingScene scene = scene_undefined_at("embedded", time + tau, 1e-3 * tau);
  scene.advance_until(0.4);
  ASSERT_EQ(scene.state.time, time);
  const auto          n_rejected = scene.memory.n_rejected;
  const StepResult<2> restarted =
    scene.controller->advance(scene.state, scene.memory).front();
  EXPECT_EQ(scene.memory.n_rejected, n_rejected + 1);
  EXPECT_EQ(restarted.step_size, tau / 2.);

  // With the same past, and made to take the smaller step at once by the end
  // of the run. Times are dyadic here, so that nothing is rounded.
  SteppingScene fresh = scene_undefined_at("embedded", 9., 1e-3 * tau);
  fresh.advance_until(0.4);
  fresh.scene.time.end_time = time + tau / 2.;
  const StepResult<2> first =
    fresh.controller->advance(fresh.state, fresh.memory).front();
  EXPECT_EQ(fresh.memory.n_rejected, n_rejected);
  EXPECT_EQ(first.step_size, tau / 2.);
  EXPECT_TRUE(same_bits(first.state, restarted.state));

  // Right after a rejection the next step does not grow.
  scene.state = restarted.state;
  EXPECT_LE(scene.advance().front().step_size, tau / 2.);
}



TEST(Rejection, ErrorsThatStayTooLargeNameTheirTolerance)
{
  // Nothing but the estimate can be at fault.
  SteppingScene embedded(creeping_bodies, control_overrides("embedded"));
  embedded.advance_until(0.3);
  embedded.scene.time.tolerance = 1e-30;
  SystemState<2> before         = embedded.state;
  std::string    message        = message_of_advance(embedded);
  EXPECT_NE(message.find("the estimated error stays above Time/Tolerance"),
            std::string::npos)
    << message;
  EXPECT_TRUE(same_bits(embedded.state, before));

  SteppingScene doubling(creeping_bodies, control_overrides("step doubling"));
  doubling.advance_until(0.3);
  doubling.scene.time.doubling_threshold = 1e-30;
  before                                 = doubling.state;
  message                                = message_of_advance(doubling);
  EXPECT_NE(message.find("Time/Doubling threshold"), std::string::npos)
    << message;
  EXPECT_TRUE(same_bits(doubling.state, before));
}
