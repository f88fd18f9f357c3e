// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/fault_snapshots.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <cmath>

#include "pushed_block.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double gravity = 9.81;



  /** The flight of a block that is thrown, as far as it touches nothing. */
  struct Flight
  {
    double begin = 0., end = 0., largest_gap = 0.;
    /** Mean slip at both ends. */
    double slip_at_begin = 0., slip_at_end = 0.;
    /** Energy missing in the balance at both ends, J/m. */
    double missing_at_begin = 0., missing_at_end = 0.;
  };



  /** Mean over the nodes of the fault in contact, or opposite each other. */
  double
  mean_slip(const Simulation<2> &simulation)
  {
    const FaultNodes<2> &faults = simulation.fault_nodes();
    double               sum = 0., weight = 0.;
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        sum += faults.weights()[k] * simulation.state().slip[k][0];
        weight += faults.weights()[k];
      }
    return sum / weight;
  }



  void
  expect_no_pressure_at_gaps(const Simulation<2> &simulation)
  {
    const SystemState<2> &state = simulation.state();
    for (unsigned int k = 0; k < state.gap.size(); ++k)
      if (simulation.fault_nodes().in_contact(k))
        {
          EXPECT_GE(state.gap[k], 0.);
          EXPECT_TRUE(state.gap[k] == 0. || state.normal_stress[k] == 0.);
        }
  }



  Flight
  fly(Simulation<2> &simulation)
  {
    Flight flight;
    simulation.set_up();
    bool flies = false;
    while (!simulation.is_finished() && (!flies || flight.end == 0.))
      {
        simulation.advance();
        const SystemState<2>      &state = simulation.state();
        const std::vector<double> &gap   = state.gap;
        const FaultNodes<2>       &nodes = simulation.fault_nodes();
        bool                       all   = true;
        for (unsigned int k = 0; k < gap.size(); ++k)
          {
            all                = all && (gap[k] > 0. || !nodes.in_contact(k));
            flight.largest_gap = std::max(flight.largest_gap, gap[k]);
          }
        if (state.time <= 1.2 * time_of_push)
          continue;
        if (!flies)
          {
            EXPECT_TRUE(all);
            flies                = true;
            flight.begin         = state.time;
            flight.slip_at_begin = mean_slip(simulation);
            flight.missing_at_begin =
              simulation.energy_balance()->defect(state);
          }
        if (!all)
          flight.end = state.time;
        else
          {
            flight.slip_at_end    = mean_slip(simulation);
            flight.missing_at_end = simulation.energy_balance()->defect(state);
          }
      }
    return flight;
  }
} // namespace



TEST(OpeningLanding, FarFromWhereItWasThrown)
{
  constexpr double         a_x = 20., a_y = 10.;
  const SceneParameters<2> scene =
    read_opening_scene<2>(falling_block,
                          pushed_block(a_x, a_y, {"Time/End time=0.5"}));
  Simulation<2> simulation(scene, MPI_COMM_WORLD);
  const Flight  flight = fly(simulation);

  // Open sides neither rub nor press: the centre of the block flies as in a
  // vacuum. It vibrates, by some millimetres.
  const double v_x = a_x * time_of_push, v_y = a_y * time_of_push;
  const double rise = v_y * time_of_push / 2. + v_y * v_y / (2. * gravity);
  const double fall = std::sqrt(2. * rise / gravity);
  EXPECT_NEAR(flight.largest_gap, rise, 0.05 * rise);
  EXPECT_NEAR(flight.end, time_of_push + v_y / gravity + fall, 0.01);
  EXPECT_NEAR((flight.slip_at_end - flight.slip_at_begin) /
                (flight.end - flight.begin),
              v_x,
              0.05 * v_x);
  // Several faces further on, and brought to rest by friction.
  EXPECT_GT(simulation.counts().contact_mappings, 3u);
  // New partners change nothing in the velocities of sides that are apart.
  EXPECT_NEAR(flight.missing_at_end,
              flight.missing_at_begin,
              1e-9 * simulation.energy_balance()->work().largest());
  const double landed = flight.slip_at_end;
  EXPECT_GT(landed, 0.4);
  while (!simulation.is_finished())
    simulation.advance();
  expect_no_pressure_at_gaps(simulation);
  EXPECT_LT(mean_slip(simulation) - landed, 0.9 * v_x * (0.5 - flight.end));
}



TEST(OpeningLanding, OverTheEdge)
{
  // By 1.1 m to the right, half a metre beyond the foundation.
  const SceneParameters<2> scene =
    read_opening_scene<2>(falling_block,
                          pushed_block(27., 10., {"Time/End time=0.45"}));
  Simulation<2>  simulation(scene, MPI_COMM_WORLD);
  const Flight   flight   = fly(simulation);
  constexpr auto n_beyond = [](const FaultNodes<2> &nodes) {
    unsigned int n = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      n += !nodes.in_contact(k);
    return n;
  };
  EXPECT_GT(n_beyond(simulation.fault_nodes()), 0u);
  EXPECT_LT(n_beyond(simulation.fault_nodes()), simulation.state().gap.size());
  bool touches = false;
  while (!simulation.is_finished())
    {
      simulation.advance();
      expect_no_pressure_at_gaps(simulation);
      const FaultNodes<2> &nodes = simulation.fault_nodes();
      for (unsigned int k = 0; k < nodes.size(); ++k)
        touches = touches || (nodes.in_contact(k) &&
                              simulation.state().normal_stress[k] > 0.);
    }
  EXPECT_TRUE(touches);
  EXPECT_GT(flight.end, 0.25);
}
