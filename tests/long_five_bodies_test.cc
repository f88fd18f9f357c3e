// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct FirstEvent
  {
    double start = 0;
    /** Of fault4, and of any other, m/s. */
    double largest_mean_slip_rate = 0, largest_below = 0;
  };



  /** The published five bodies to the end of the first event. */
  FirstEvent
  first_event(const std::string &inertia)
  {
    SCOPED_TRACE(inertia);
    const SceneParameters<2> scene =
      published_scene("layered_five_bodies",
                      {"Time/Inertia=" + inertia, "Time/End time=32.2"});
    const std::vector<std::string> names = {"fault1",
                                            "fault2",
                                            "fault3",
                                            "fault4"};
    const TemporaryFolder          folder;
    EventCatalogue<2>              catalogue(folder.file("events.csv"),
                                names,
                                event_start_slip_rate(scene),
                                scene.output.event_end_fraction);
    Simulation<2>                  simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    catalogue.add(0., snapshots(simulation, names));
    FirstEvent result;
    while (!simulation.is_finished())
      {
        simulation.advance();
        const auto faults = snapshots(simulation, names);
        catalogue.add(simulation.state().time, faults);
        for (unsigned int f = 0; f < 3; ++f)
          result.largest_below =
            std::max(result.largest_below,
                     fault_statistics(faults[f]).mean_slip_rate);
      }
    EXPECT_EQ(catalogue.events().size(), 1u);
    for (const SlipEvent &event : catalogue.events())
      {
        EXPECT_EQ(event.fault, "fault4");
        EXPECT_NEAR(event.nucleation_x, -0.5, 0.1);
        result.start                  = event.start;
        result.largest_mean_slip_rate = event.peak_mean_slip_rate;
      }
    return result;
  }
} // namespace



TEST(LongFiveBodies, FirstEventWithAndWithoutMass)
{
  const FirstEvent dynamic       = first_event("dynamic"),
                   quasi_dynamic = first_event("quasi-dynamic"),
                   quasi_static  = first_event("quasi-static");
  // Nucleation is slow: waves hardly matter.
  EXPECT_NEAR(dynamic.start, 31.57, 0.02);
  EXPECT_NEAR(quasi_static.start, dynamic.start, 0.01);
  // Radiation damping holds back, inertia too, but less.
  EXPECT_GT(quasi_dynamic.start, dynamic.start);
  EXPECT_LT(quasi_dynamic.start, dynamic.start + 0.05);
  EXPECT_LT(quasi_dynamic.largest_mean_slip_rate,
            dynamic.largest_mean_slip_rate);
  EXPECT_LT(dynamic.largest_mean_slip_rate,
            quasi_static.largest_mean_slip_rate);
  for (const FirstEvent &event : {dynamic, quasi_dynamic, quasi_static})
    EXPECT_LT(event.largest_below, 1e-11);
}
