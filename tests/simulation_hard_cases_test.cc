// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/magnitude.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // The state of the spring slider's fault at that time, with changes.
  struct FaultAt
  {
    FaultSnapshot<2> fault;
    unsigned int     n_steps = 0;

    FaultAt(const std::string &time, std::vector<std::string> overrides)
    {
      overrides.push_back("Time/End time=" + time);
      Simulation<2> simulation(published_scene("spring_slider", overrides),
                               MPI_COMM_WORLD);
      simulation.set_up();
      while (!simulation.is_finished())
        {
          simulation.advance();
          ++n_steps;
        }
      fault = snapshots(simulation).front();
    }
  };
} // namespace



TEST(HardCases, TractionOfFaultsTooSlowForNumbers)
{
  // Up to here the fault is stuck, and the traction that of the elastic bodies,
  // whatever the direct effect. Slip rates are those with which friction
  // balances it, exp(-300) m/s at a = 1e-3, and none at all at 1e-4.
  const std::string time = "6";
  const FaultAt reference(time, {"Faults/fault/a=0.01", "Faults/fault/b=0"});
  const FaultAt slow(time, {"Faults/fault/a=1e-3", "Faults/fault/b=0"});
  const FaultAt slowest(time, {"Faults/fault/a=1e-4", "Faults/fault/b=0"});
  double        largest = 0;
  for (const auto &traction : reference.fault.shear_traction)
    largest = std::max(largest, std::abs(traction[0]));
  EXPECT_GT(largest, 4e3);
  bool some_underflow = false;
  for (unsigned int k = 0; k < reference.fault.points.size(); ++k)
    {
      const double expected = reference.fault.shear_traction[k][0];
      EXPECT_NEAR(slow.fault.shear_traction[k][0], expected, 2e-4 * largest);
      EXPECT_NEAR(slowest.fault.shear_traction[k][0], expected, 2e-4 * largest);
      some_underflow = some_underflow || slowest.fault.slip_rate[k][0] == 0.;
      EXPECT_LT(magnitude(slow.fault.slip_rate[k]), 1e-100);
    }
  EXPECT_TRUE(some_underflow);
}



TEST(HardCases, SlipRatesPassTheLeastSquare)
{
  // From 8.5 s on some slip rates are above 1e-162 m/s, so that their squares
  // are no longer zero; the error estimate must not jump on the way.
  const FaultAt slider("9", {"Faults/fault/a=1e-3", "Faults/fault/b=0"});
  double        fastest = 0;
  for (const auto &rate : slider.fault.slip_rate)
    fastest = std::max(fastest, magnitude(rate));
  EXPECT_GT(fastest, 1e-160);
  EXPECT_LT(slider.n_steps, 1000u);
}



TEST(HardCases, StatesOfTwelveDecadesAtNeighbouringNodes)
{
  // Friction at the start is not zero but that of the equilibrium, and this
  // is what the first steps are compared with.
  const FaultAt slider("1",
                       {"Faults/fault/Initial state="
                        "if(cos(pi * (x + 2.5) / 0.03125) > 0, 1e6, 1e-6)"});
  EXPECT_LT(slider.n_steps, 2000u);
  for (unsigned int k = 0; k < slider.fault.state.size(); ++k)
    {
      const double x    = slider.fault.points[k][0];
      const bool   even = std::cos(numbers::PI * (x + 2.5) / 0.03125) > 0;
      EXPECT_NEAR(slider.fault.state[k],
                  (even ? 1e6 : 1e-6) + 1.,
                  1e-9 * slider.fault.state[k]);
    }
}



TEST(HardCases, TheSofterSideIsTheSlave)
{
  // Whichever is finer. With the stiff side as slave this takes 20 iterations a
  // step for cells of one size, and more where its cells are smaller.
  for (const std::string stiff : {"lower", "upper"})
    for (const std::string passes : {"2", "4"})
      {
        SCOPED_TRACE(stiff + ", other body refined " + passes + " times");
        const std::string other = stiff == "lower" ? "upper" : "lower";
        SteppingScene     scene(published_scene(
          "spring_slider",
          {"Bodies/" + stiff + "/Material/Young modulus=4.12e11",
               "Bodies/" + other + "/Refinement passes=" + passes}));
        EXPECT_EQ(
          scene.problem.jump_basis().faults().front().sides.slave_is_second(),
          stiff == "lower");
        scene.advance_until(4.);
        EXPECT_LT(scene.memory.work.tnnmg_iterations,
                  6 * scene.memory.n_solved);
      }
}



TEST(HardCases, TallNarrowCellsComeToRest)
{
  // At the ends of the fault, where hardly anything presses, nodes reverse
  // their slip and come to rest in the first milliseconds: friction jumps
  // there.
  const FaultAt slider("0.1",
                       {"Bodies/lower/Coarse cells=200, 2",
                        "Bodies/upper/Coarse cells=200, 2",
                        "Bodies/lower/Refinement passes=1",
                        "Bodies/upper/Refinement passes=1"});
  EXPECT_LT(slider.n_steps, 1000u);
}
