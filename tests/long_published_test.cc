// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

TEST(LongSpringSlider, GivesThePublishedEvents)
{
  const RunHistory run(published_scene("spring_slider"));
  EXPECT_NEAR(run.steps.back().time, 60., 1e-9);

  // Events as in doc/results.md; later ones depend on the compiler.
  EXPECT_NEAR(run.events.size(), 22., 2.);
  ASSERT_FALSE(run.events.empty());
  EXPECT_NEAR(run.events.front().start, 22.277, 1e-3);
  double       fastest_node = 0;
  unsigned int n_central    = 0;
  for (const SlipEvent &event : run.events)
    {
      SCOPED_TRACE("event at t = " + std::to_string(event.start));
      EXPECT_GT(event.peak_mean_slip_rate, 5e-4);
      EXPECT_LT(event.peak_mean_slip_rate, 1e-2);
      fastest_node = std::max(fastest_node, event.peak_slip_rate);
      n_central += std::abs(event.nucleation[0]) < 1. ? 1 : 0;
    }
  EXPECT_GT(fastest_node, 1e-2);
  EXPECT_GT(2 * n_central, run.events.size());

  double smallest = 1e9, largest = 0;
  for (const RunHistory::Step &step : run.steps)
    {
      if (step.time < 15.)
        {
          ASSERT_LT(step.fault.mean_slip_rate, 1e-8) << "t = " << step.time;
        }
      if (step.time > 2. && step.time < 59.)
        {
          smallest = std::min(smallest, step.step_size);
          largest  = std::max(largest, step.step_size);
        }
    }
  EXPECT_GT(largest / smallest, 100.);
}



TEST(LongSpringSlider, EventTimesHardlyDependOnTheTolerance)
{
  const auto first_events = [](const std::vector<std::string> &overrides) {
    std::vector<std::string> all = {"Time/End time=28"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return RunHistory(published_scene("spring_slider", all)).events;
  };
  const std::vector<SlipEvent> coarse = first_events({}),
                               fine   = first_events({"Time/Tolerance=1.3e-7"});
  ASSERT_GE(coarse.size(), 4u);
  ASSERT_GE(fine.size(), 4u);
  const double recurrence = (fine[3].start - fine[0].start) / 3.;
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_LT(std::abs(coarse[i].start - fine[i].start), 0.006 * recurrence)
      << "event " << i;
}



TEST(LongSpringSlider, CreepsWithThePrintedCharacteristicSlip)
{
  const RunHistory run(published_scene("spring_slider_printed_L"));
  EXPECT_NEAR(run.steps.back().time, 60., 1e-9);
  EXPECT_TRUE(run.events.empty());
  for (const RunHistory::Step &step : run.steps)
    if (step.time >= 40.)
      {
        ASSERT_NEAR(step.fault.mean_slip_rate, 2e-4, 0.03 * 2e-4)
          << "t = " << step.time;
      }
}



namespace
{
  /** Of fault4, the only one that slips, and of any other, m/s. */
  struct FiveBodies
  {
    std::vector<SlipEvent> events;
    double                 largest_below = 0;
  };



  FiveBodies
  run_five_bodies(const std::vector<std::string> &entries)
  {
    const SceneParameters<2> scene =
      published_scene("layered_five_bodies", entries);
    const std::vector<std::string> names = {"fault1",
                                            "fault2",
                                            "fault3",
                                            "fault4"};
    const TemporaryFolder          folder;
    Simulation<2>                  simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    EventCatalogue<2> catalogue(folder.file("events.csv"),
                                names,
                                make_fault_layouts(
                                  simulation.spatial_problem().jump_basis()),
                                event_start_slip_rate(scene),
                                scene.output.event_end_fraction);
    catalogue.add(0., snapshots(simulation, names));
    FiveBodies result;
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
    result.events = catalogue.entries();
    for (const SlipEvent &event : result.events)
      EXPECT_EQ(event.fault, "fault4");
    return result;
  }



  /** The first event with that inertia. */
  SlipEvent
  first_event(const std::string &inertia)
  {
    SCOPED_TRACE(inertia);
    const FiveBodies run =
      run_five_bodies({"Time/Inertia=" + inertia, "Time/End time=32.2"});
    EXPECT_LT(run.largest_below, 1e-11);
    EXPECT_EQ(run.events.size(), 1u);
    if (run.events.empty())
      return {};
    EXPECT_NEAR(run.events.front().nucleation[0], -0.5, 0.1);
    return run.events.front();
  }
} // namespace



TEST(LongFiveBodies, FirstEventWithAndWithoutMass)
{
  const SlipEvent dynamic       = first_event("dynamic"),
                  quasi_dynamic = first_event("quasi-dynamic"),
                  quasi_static  = first_event("quasi-static");
  // Nucleation is slow: waves hardly matter.
  EXPECT_NEAR(dynamic.start, 31.57, 0.02);
  EXPECT_NEAR(quasi_static.start, dynamic.start, 0.01);
  // Radiation damping holds back, inertia too, but less.
  EXPECT_GT(quasi_dynamic.start, dynamic.start);
  EXPECT_LT(quasi_dynamic.start, dynamic.start + 0.05);
  EXPECT_LT(quasi_dynamic.peak_mean_slip_rate, dynamic.peak_mean_slip_rate);
  EXPECT_LT(dynamic.peak_mean_slip_rate, quasi_static.peak_mean_slip_rate);
}



TEST(LongFiveBodies, PastTheNinthEvent)
{
  // With a tenth of the default tolerance as with the published settings, the
  // tenth event has an aftershock from the left end, which the default misses.
  const std::vector<SlipEvent>
    fine =
      run_five_bodies({"Time/Tolerance=1.3e-7", "Time/End time=54.5"}).events,
    coarse = run_five_bodies({"Time/End time=50.5"}).events;
  ASSERT_EQ(fine.size(), 11u);
  ASSERT_EQ(coarse.size(), 9u);
  // Begins of the published settings, doc/data/results_events_layered.csv.
  const double published[] = {31.5714,
                              34.1191,
                              36.7323,
                              39.2061,
                              41.4369,
                              44.3832,
                              44.6165,
                              46.7052,
                              49.9000};
  // Mean of the intervals; an aftershock comes after 0.23 s.
  const double interval = 2.3;
  for (unsigned int i = 0; i < 9; ++i)
    {
      SCOPED_TRACE("event " + std::to_string(i + 1));
      EXPECT_NEAR(fine[i].start, published[i], 0.013 * interval);
      EXPECT_NEAR(coarse[i].start, fine[i].start, 0.03 * interval);
    }
  EXPECT_NEAR(fine[9].start, 53.005, 0.05);
  EXPECT_NEAR(fine[10].start - fine[9].start, 0.70, 0.1);
  EXPECT_LT(fine[10].nucleation[0], -2.);
}
