// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <iostream>

#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies, the upper one of which nothing holds, on a fault with a
   * characteristic slip that is passed within microseconds after an impact. */
  const char *const two_bodies = R"(
subsection Bodies
  set Names = lower, upper
  subsection lower
    set Lower lateral corner = -2.5
    set Upper lateral corner = 2.5
    set Thickness            = 1
    set Coarse cells         = 10, 2
    set Refinement passes    = 2
  end
  subsection upper
    set Lower lateral corner = -2.5
    set Upper lateral corner = 2.5
    set Thickness            = 1
    set Coarse cells         = 10, 2
    set Refinement passes    = 2
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Contact             = unilateral
    set a                   = 0.010
    set b                   = 0.015
    set Characteristic slip = 2e-5
  end
end
subsection Boundary conditions
  set Sides = lower bottom
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** The run to its end, with the openings of the fault on the way. */
  unsigned int
  n_landings(Simulation<2> &simulation)
  {
    simulation.set_up();
    unsigned int result = 0;
    bool         flies  = false;
    while (!simulation.is_finished())
      {
        simulation.advance();
        bool touches = false;
        for (const double gap : simulation.state().gap)
          touches = touches || gap == 0.;
        result += flies && touches;
        flies = !touches;
      }
    return result;
  }
} // namespace



TEST(OpeningChattering, NeedsNoShorterStepsThanItsTolerance)
{
  Simulation<2> simulation(
    read_opening_scene<2>(
      two_bodies,
      {"Boundary conditions/lower bottom/y condition=velocity",
       "Boundary conditions/lower bottom/y value=0.3*sin(100*t)",
       "Boundary conditions/lower bottom/Ramp length=0.05",
       "Time/Tolerance=3e-7",
       "Time/End time=0.1"}),
    MPI_COMM_WORLD);
  EXPECT_GE(n_landings(simulation), 2u);
}



// A fall to 1 m/s on a fault that is touched node by node, and 8 ms of what
// follows. Tractions of nodes that have stuck are the most sensitive to how
// they have slid.
TEST(OpeningChattering, WhatFollowsAnImpactIsNotAMatterOfTheSteps)
{
  std::vector<std::vector<Tensor<1, 1>>> slips, tractions;
  for (const std::vector<std::string> &tolerances :
       {std::vector<std::string>{"Time/Body tolerance=5e-4"},
        {"Time/Body tolerance=5e-5",
         "Time/Tolerance=1.3e-7",
         "Time/Smallest step=1e-12"}})
    {
      std::vector<std::string> overrides = {
        "Faults/fault/Initial gap=0.0509684+1e-3*x",
        "Gravity/Acceleration=9.81",
        "Time/Largest step=5e-4",
        "Time/Initial step=5e-4",
        "TNNMG/Tolerance=1e-10",
        "Time/End time=0.109937"};
      overrides.insert(overrides.end(), tolerances.begin(), tolerances.end());
      Simulation<2> simulation(read_opening_scene<2>(two_bodies, overrides),
                               MPI_COMM_WORLD);
      EXPECT_EQ(n_landings(simulation), 1u);
      std::cout << simulation.counts().accepted << " steps\n";
      EXPECT_LE(simulation.counts().accepted, slips.empty() ? 2500u : 5500u);
      slips.push_back(simulation.state().slip);
      tractions.emplace_back();
      for (unsigned int k = 0; k < slips.back().size(); ++k)
        tractions.back().push_back(written_traction(simulation.fault_nodes(),
                                                    simulation.node_laws(),
                                                    simulation.state(),
                                                    k));
    }
  for (const auto &[values, allowed] :
       {std::make_pair(&slips, 0.015), std::make_pair(&tractions, 0.05)})
    {
      double largest = 0., difference = 0.;
      for (unsigned int k = 0; k < values->front().size(); ++k)
        {
          largest = std::max(largest, values->back()[k].norm());
          difference =
            std::max(difference,
                     (values->back()[k] - values->front()[k]).norm());
        }
      EXPECT_LT(difference, allowed * largest);
      EXPECT_GT(largest, 0.);
    }
}



TEST(OpeningChattering, WavesAreAnErrorWhereOnlyWeldedSidesTouch)
{
  // A crack opens in the middle of a weld: nothing rubs, and waves run through
  // the bodies.
  std::vector<double> gaps;
  for (const auto &[of_faults, of_bodies] :
       {std::make_pair("1.3e-6", "1e-3"), std::make_pair("1.3e-8", "1e-5")})
    {
      Simulation<2> simulation(
        read_opening_scene<2>(
          two_bodies,
          {"Faults/fault/Contact=bilateral",
           "Faults/fault/Friction=welded",
           "Faults/fault/Regions/Names=crack",
           "Faults/fault/Regions/crack/Where=abs(x) < 1",
           "Faults/fault/Regions/crack/Friction=rate and state",
           "Faults/fault/Regions/crack/Contact=unilateral",
           "Boundary conditions/Sides=lower bottom, upper top",
           "Boundary conditions/upper top/y condition=traction",
           "Boundary conditions/upper top/y value=2e5 * sin(2 * pi * t)",
           "Boundary conditions/upper top/Ramp length=0.2",
           std::string("Time/Tolerance=") + of_faults,
           std::string("Time/Body tolerance=") + of_bodies,
           "Time/Smallest step=1e-12",
           "Time/End time=0.12"}),
        MPI_COMM_WORLD);
      n_landings(simulation);
      const std::vector<double> &gap = simulation.state().gap;
      gaps.push_back(*std::max_element(gap.begin(), gap.end()));
      std::cout << gaps.back() << " m after " << simulation.counts().accepted
                << " steps\n";
    }
  EXPECT_GT(gaps[1], 1e-3);
  EXPECT_NEAR(gaps[0], gaps[1], 2e-3 * gaps[1]);
}
