// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct PushedRun
  {
    double       slip    = 0;
    unsigned int n_steps = 0;
    /** Ends of all steps, s. */
    std::vector<double> ends;
  };



  /** Bodies that are pushed for 20 ms, long after the loading has begun. */
  PushedRun
  pushed(const Settings &settings)
  {
    const Settings pulse = {
      "Boundary conditions/upper top/x condition=traction",
      "Boundary conditions/upper top/x value=if(abs(t-3.3)<0.01, 4e4, 0)",
      "Boundary conditions/upper top/Ramp length=0",
      "Output/Event start slip rate=1e-3",
      "Time/End time=4"};
    Simulation<2> simulation(read_scene(creeping_bodies, pulse + settings),
                             MPI_COMM_WORLD);
    simulation.set_up();
    PushedRun run;
    while (!simulation.is_finished())
      {
        simulation.advance();
        run.ends.push_back(simulation.state().time);
      }
    run.n_steps                  = simulation.counts().accepted;
    const FaultSnapshot<2> fault = snapshots(simulation).front();
    for (const auto &slip : fault.slip)
      run.slip = std::max(run.slip, std::abs(slip[0]));
    return run;
  }
} // namespace



TEST(ShortLoads, AreNotSteppedOver)
{
  const PushedRun exact =
    pushed({"Time/Step size control=constant", "Time/Largest step=1e-3"});
  EXPECT_GT(exact.slip, 1e-5);
  for (const std::string control : {"embedded", "step doubling"})
    {
      const PushedRun run = pushed(
        {"Time/Step size control=" + control, "Time/Doubling threshold=7e-6"});
      std::cout << control << ": " << run.n_steps << " steps, slip " << run.slip
                << " m, with steps of 1 ms " << exact.slip << " m\n";
      EXPECT_NEAR(run.slip, exact.slip, 0.02 * exact.slip);
      EXPECT_LT(run.n_steps, exact.n_steps / 2);
      for (const double time : {3.29, 3.31})
        EXPECT_TRUE(std::any_of(run.ends.begin(),
                                run.ends.end(),
                                [&](const double end) {
                                  return std::abs(end - time) < 1e-9;
                                }))
          << time;
    }
}
