// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <numeric>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The creeping bodies without ends, so fast that they slide by more than
   * their length, and with a wave in the state. */
  SceneParameters<2>
  endless_scene(const unsigned int n_periods)
  {
    const std::string upper = std::to_string(2 * n_periods - 1);
    return read_scene(
      creeping_bodies,
      {"Boundary conditions/Periodic along x=true",
       "Bodies/lower/Upper lateral corner=" + upper,
       "Bodies/upper/Upper lateral corner=" + upper,
       "Bodies/lower/Coarse cells=" + std::to_string(4 * n_periods) + ", 1",
       "Bodies/upper/Coarse cells=" + std::to_string(3 * n_periods) + ", 1",
       "Boundary conditions/upper top/x value=1",
       "Boundary conditions/upper top/Ramp length=0.2",
       "Faults/fault/Initial state=1 + 0.2 * cos(pi * x)",
       "Faults/fault/Reference slip rate=1",
       "Faults/fault/Characteristic slip=1",
       "Faults/fault/Normal stress function=1e3",
       "TNNMG/Tolerance=1e-11",
       "Time/Rate-state tolerance=1e-11",
       "Time/Step size control=constant",
       "Time/Initial step=0.02",
       "Time/Largest step=0.02",
       "Time/End time=2.4"});
  }



  double
  sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }
} // namespace



TEST(Periodic, SlidesPastItsLengthWithoutLosingContact)
{
  Simulation<2> simulation(endless_scene(1), MPI_COMM_WORLD);
  simulation.set_up();
  while (!simulation.is_finished())
    {
      simulation.advance();
      const auto &coupling =
        simulation.spatial_problem().jump_basis().faults()[0].coupling;
      EXPECT_NEAR(coupling.covered_area, 2., 1e-12);
      EXPECT_NEAR(sum(coupling.weight), 2., 1e-12);
      EXPECT_EQ(coupling.lost_area, 0.);
    }
  EXPECT_GT(simulation.counts().contact_mappings, 40u);
  const FaultSnapshot<2> fault = snapshots(simulation)[0];
  for (const auto &slip : fault.slip)
    EXPECT_GT(slip[0], 2.2);
}



TEST(Periodic, TwoPeriodsAreTwiceOne)
{
  Simulation<2> one(endless_scene(1), MPI_COMM_WORLD),
    two(endless_scene(2), MPI_COMM_WORLD);
  for (Simulation<2> *simulation : {&one, &two})
    {
      simulation->set_up();
      while (!simulation->is_finished())
        simulation->advance();
    }
  EXPECT_EQ(one.counts().contact_mappings, two.counts().contact_mappings);
  const FaultSnapshot<2> short_fault = snapshots(one)[0],
                         long_fault  = snapshots(two)[0];
  const unsigned int n               = short_fault.points.size();
  ASSERT_EQ(long_fault.points.size(), 2 * n);
  double lowest = 1e300, highest = 0;
  for (unsigned int k = 0; k < 2 * n; ++k)
    {
      EXPECT_NEAR(long_fault.points[k][0],
                  short_fault.points[k % n][0] + (k < n ? 0. : 2.),
                  1e-12);
      EXPECT_NEAR(long_fault.slip[k][0], short_fault.slip[k % n][0], 1e-8);
      EXPECT_NEAR(long_fault.slip_rate[k][0],
                  short_fault.slip_rate[k % n][0],
                  1e-8);
      EXPECT_NEAR(long_fault.state[k], short_fault.state[k % n], 1e-8);
      lowest  = std::min(lowest, long_fault.state[k]);
      highest = std::max(highest, long_fault.state[k]);
    }
  // The wave has not died out, so that there was something to compare.
  EXPECT_GT(highest - lowest, 1e-3);
}



TEST(Periodic, SpringSliderIsOneDimensional)
{
  Simulation<2> simulation(
    published_scene("spring_slider",
                    {"Boundary conditions/Periodic along x=true",
                     "Bodies/lower/Refinement passes=2",
                     "Bodies/upper/Refinement passes=1",
                     "TNNMG/Tolerance=1e-9",
                     "Time/End time=22"}),
    MPI_COMM_WORLD);
  simulation.set_up();
  for (const double stress : simulation.state().normal_stress)
    EXPECT_NEAR(stress, 5e3 * 9.81, 1e-7);
  double largest = 0;
  while (!simulation.is_finished())
    {
      simulation.advance();
      const auto  &slip_rate = simulation.state().slip_rate;
      const double first     = slip_rate[0][0];
      largest                = std::max(largest, std::abs(first));
      for (const auto &V : slip_rate)
        EXPECT_NEAR(V[0], first, 1e-5 * std::abs(first) + 1e-14);
    }
  EXPECT_GT(largest, 1e-4);
}
