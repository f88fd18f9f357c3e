// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Settings = std::vector<std::string>;

  /** The scene of BP3 with cells of 3.2 km. */
  SceneParameters<2>
  dipping_scene(const Settings &more = {})
  {
    Settings settings = {"Bodies/footwall/Refinement passes=9",
                         "Bodies/hanging_wall/Refinement passes=9"};
    settings.insert(settings.end(), more.begin(), more.end());
    return published_scene("seas/bp3_thrust60", settings);
  }



  /** Its fault upright; @p sign: of slip rate and stress. */
  Settings
  upright(const std::string &sign)
  {
    const std::string other = sign == "-" ? "" : "-";
    return {"Bodies/footwall/Corners=-6553.6e3 -6553.6e3, 0 -6553.6e3, 0 0, "
            "-6553.6e3 0",
            "Bodies/hanging_wall/Corners=0 -6553.6e3, 6553.6e3 -6553.6e3, "
            "6553.6e3 0, 0 0",
            "Bodies/footwall/Refine where=43e3 + y",
            "Bodies/hanging_wall/Refine where=43e3 + y",
            "Faults/fault/a=0.010 + 0.015 * min(1, max(0, (-y - 15e3) / 3e3))",
            "Faults/fault/Initial slip rate along x=" + sign + "1e-9",
            "Faults/fault/Initial shear stress along x=" + sign + "26546122",
            "Faults/fault/Regions/below/Where=-y - 40e3",
            "Faults/fault/Regions/below/Slip rate along x=" + sign + "1e-9",
            "Boundary conditions/footwall left/x value=0",
            "Boundary conditions/footwall left/y value=" + sign + "0.5e-9",
            "Boundary conditions/footwall bottom/x value=0",
            "Boundary conditions/footwall bottom/y value=" + sign + "0.5e-9",
            "Boundary conditions/hanging_wall right/x value=0",
            "Boundary conditions/hanging_wall right/y value=" + other +
              "0.5e-9",
            "Boundary conditions/hanging_wall bottom/x value=0",
            "Boundary conditions/hanging_wall bottom/y value=" + other +
              "0.5e-9",
            "Output/Stations="};
  }
} // namespace



// States are those of the description of BP3.
TEST(SeasScenes, ADippingFaultBeginsToSlideInEquilibrium)
{
  Simulation<2> simulation(dipping_scene({"Time/Initial step=1e-3"}),
                           MPI_COMM_WORLD);
  simulation.set_up();
  const FaultSnapshot<2> before = snapshots(simulation).front();
  simulation.advance();
  const FaultSnapshot<2> after = snapshots(simulation).front();
  EXPECT_LT(simulation.state().time, 0.01);
  unsigned int n = 0;
  for (unsigned int k = 0; k < before.points.size(); ++k)
    {
      const double distance = -before.points[k][1] / std::sin(M_PI / 3.);
      if (before.weights[k] == 0. || distance > 40e3)
        continue;
      ++n;
      EXPECT_NEAR(before.slip_rate[k][0], -1e-9, 1e-18);
      EXPECT_NEAR(before.normal_stress[k], 50e6, 1e-3);
      if (distance < 15e3)
        {
          EXPECT_NEAR(before.state[k], 8e3, 10.);
        }
      if (distance > 18e3)
        {
          EXPECT_NEAR(before.state[k], 8e6, 1e4);
        }
      EXPECT_NEAR(after.shear_traction[k][0] / before.shear_traction[k][0],
                  1.,
                  1e-9);
      EXPECT_NEAR(after.normal_stress[k] / before.normal_stress[k], 1., 1e-9);
    }
  EXPECT_GT(n, 10u);
}



TEST(SeasScenes, SlipOnAnUprightFaultLeavesTheNormalStressAsItIs)
{
  std::vector<FaultSnapshot<2>> faults;
  std::vector<double>           times;
  for (const std::string sign : {"-", ""})
    {
      Simulation<2> simulation(dipping_scene(upright(sign)), MPI_COMM_WORLD);
      simulation.set_up();
      for (unsigned int step = 0; step < 100; ++step)
        simulation.advance();
      faults.push_back(snapshots(simulation).front());
      times.push_back(simulation.state().time);
    }
  EXPECT_GT(times[0], 1e6);
  // Sizes of explicit steps are on no grid.
  EXPECT_NEAR(times[0], times[1], 1e-6 * times[0]);
  double largest = 0.;
  for (unsigned int k = 0; k < faults[0].points.size(); ++k)
    if (faults[0].weights[k] > 0.)
      {
        EXPECT_NEAR(faults[0].normal_stress[k] / 50e6, 1., 1e-9);
        EXPECT_NEAR(faults[1].normal_stress[k] / 50e6, 1., 1e-9);
        EXPECT_NEAR(faults[0].slip[k][0],
                    -faults[1].slip[k][0],
                    1e-6 * std::abs(faults[1].slip[k][0]));
        largest = std::max(largest, faults[1].slip[k][0]);
      }
  EXPECT_GT(largest, 1e-3);
}
