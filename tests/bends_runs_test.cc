// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The bodies at the end of sliding by half a metre over two bends. */
  FaultSnapshot<2>
  end_of_sliding(const Settings &settings, unsigned int &mappings)
  {
    const Settings wavy = {"Faults/fault/Elevation=0.005 * sin(3 * x)",
                           "Bodies/lower/Coarse cells=7, 2",
                           "Time/Step size control=constant",
                           "Time/Largest step=0.02",
                           "Time/Rate-state tolerance=1e-10",
                           "TNNMG/Tolerance=1e-11"};
    Simulation<2>  simulation(fast_sliding_scene(wavy + settings),
                             MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    mappings = simulation.counts().contact_mappings;
    return snapshots(simulation).front();
  }



  class SlidingOverBends : public ::testing::TestWithParam<const char *>
  {};
} // namespace



TEST_P(SlidingOverBends, IsTheSameWhateverTheSolver)
{
  const Settings     inertia = {std::string("Time/Inertia=") + GetParam()};
  unsigned int       mappings;
  const auto         fault = end_of_sliding(inertia, mappings);
  const unsigned int n     = mappings;
  EXPECT_GT(n, 20u);
  double largest = 0.;
  for (const auto &slip : fault.slip)
    largest = std::max(largest, slip.norm());
  EXPECT_GT(largest, 0.4);
  for (const std::string solver : {"Time/Rate solver=condensed Newton",
                                   "TNNMG/Linear correction=UMFPACK",
                                   "Time/Rate-state method=nested"})
    {
      SCOPED_TRACE(solver);
      const auto other = end_of_sliding(inertia + Settings{solver}, mappings);
      EXPECT_EQ(mappings, n);
      ASSERT_EQ(other.slip.size(), fault.slip.size());
      for (unsigned int k = 0; k < fault.slip.size(); ++k)
        {
          EXPECT_LT((other.slip[k] - fault.slip[k]).norm(), 1e-7 * largest);
          EXPECT_NEAR(other.state[k], fault.state[k], 1e-6 * fault.state[k]);
          EXPECT_LT((other.shear_traction[k] - fault.shear_traction[k]).norm(),
                    1e-6 * fault.shear_traction[k].norm() + 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Inertia,
                         SlidingOverBends,
                         ::testing::Values("dynamic",
                                           "quasi-dynamic",
                                           "quasi-static"),
                         [](const auto &info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
