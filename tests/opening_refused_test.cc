// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <cmath>

#include "falling_block.h"
#include "leaning_rod.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The message of a run that cannot go on; nothing of the failed steps is in
   * its state. */
  std::string
  message_of(Simulation<2> &simulation)
  {
    simulation.set_up();
    while (!simulation.is_finished())
      {
        const SystemState<2> before = simulation.state();
        try
          {
            simulation.advance();
          }
        catch (const StepSizeTooSmall &error)
          {
            EXPECT_TRUE(same_bits(simulation.state(), before));
            EXPECT_EQ(simulation.state().gap, before.gap);
            EXPECT_EQ(simulation.state().time, before.time);
            return error.what();
          }
      }
    return "";
  }



  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace



TEST(OpeningRefused, ABodyWithoutMassAndHold)
{
  for (const std::string inertia : {"quasi-static", "quasi-dynamic"})
    {
      SCOPED_TRACE(inertia);
      const std::string        top = "Boundary conditions/block top/";
      const SceneParameters<2> scene =
        read_opening_scene<2>(falling_block,
                              {"Time/Inertia=" + inertia,
                               "Faults/contact/Initial gap=0",
                               "Bodies/block/Uniform refinements=2",
                               "Bodies/foundation/Uniform refinements=2",
                               "Boundary conditions/Sides=foundation bottom, "
                               "block top",
                               top + "y condition=traction",
                               top + "y value=1e5",
                               "Time/Smallest step=1e-5",
                               "TNNMG/Tolerance=1e-8",
                               "Time/Rate-state tolerance=1e-7"});
      Simulation<2>     simulation(scene, MPI_COMM_WORLD);
      const std::string message = message_of(simulation);
      EXPECT_TRUE(contains(message, "'contact' is open over ")) << message;
      EXPECT_TRUE(contains(message, "is not determined")) << message;
      EXPECT_FALSE(contains(message, "grow without bound")) << message;
    }
}



TEST(OpeningRefused, FrictionAndContactThatDoNotSettle)
{
  // Slip of the foot presses it down by more than what friction on it takes
  // back: each normal stress is answered by one that is further off. Stresses
  // are combined from the twelfth iteration on only.
  const SceneParameters<2> scene =
    read_opening_scene<2>(leaning_rod(40.),
                          {"TNNMG/Cycles per correction=10",
                           "Time/Largest number of rate-state iterations=11"});
  Simulation<2>     simulation(scene, MPI_COMM_WORLD);
  const std::string message = message_of(simulation);
  EXPECT_TRUE(
    contains(message,
             "friction and the normal stress of the contact did not settle"))
    << message;
  EXPECT_TRUE(contains(message, "angle of friction")) << message;
  EXPECT_LT(simulation.state().time, 1.);
}



TEST(OpeningRefused, VelocitiesThatTooFewCyclesDoNotFind)
{
  const SceneParameters<2> scene =
    read_opening_scene<2>(leaning_rod(40.), {"TNNMG/Cycles per correction=2"});
  Simulation<2>     simulation(scene, MPI_COMM_WORLD);
  const std::string message = message_of(simulation);
  EXPECT_TRUE(contains(message, "did not settle within 100 iterations"))
    << message;
  EXPECT_FALSE(contains(message, "rate and state")) << message;
  EXPECT_LT(simulation.state().time, 1.);
}



TEST(OpeningRefused, NotWhatCombinedStressesFind)
{
  // On the other side of the angle of friction it sticks, as in a jam.
  for (const double angle : {42., 36.})
    {
      const SceneParameters<2> scene =
        read_opening_scene<2>(leaning_rod(angle),
                              {"TNNMG/Cycles per correction=10"});
      Simulation<2> simulation(scene, MPI_COMM_WORLD);
      EXPECT_EQ(message_of(simulation), "");
      const SystemState<2> &state   = simulation.state();
      unsigned int          n_touch = 0;
      for (unsigned int k = 0; k < state.gap.size(); ++k)
        {
          if (angle == 36.)
            {
              EXPECT_NEAR(state.slip[k][0], 0., 1e-5);
            }
          else if (state.gap[k] == 0.)
            {
              EXPECT_NEAR(state.slip_rate[k][0], -1e-3, 1e-5);
            }
          n_touch += state.normal_stress[k] > 0.;
        }
      EXPECT_GT(n_touch, 0u);
    }
}
