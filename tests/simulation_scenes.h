// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_simulation_scenes_h
#define stickslip_tests_simulation_scenes_h

#include <stickslip/output/event_catalogue.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/fault_layouts.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <cstdlib>

#include "fault_snapshots.h"
#include "project_directories.h"
#include "temporary_folder.h"

namespace StickSlip::Tests
{
  /** A scene of the project's folder parameters/. */
  inline SceneParameters<2>
  published_scene(const std::string              &name,
                  const std::vector<std::string> &overrides = {})
  {
    return SceneReader(STICKSLIP_SOURCE_DIR "/parameters/" + name + ".prm",
                       overrides)
      .read<2>();
  }



  /**
   * Record of a whole run of a scene with the one fault "fault". Only for
   * controls that take one step at a time.
   */
  struct RunHistory
  {
    struct Step
    {
      double          time, step_size;
      FaultStatistics fault;
    };

    std::vector<Step>      steps;
    std::vector<SlipEvent> events;

    /** The fault when the mean slip rate was largest. */
    FaultSnapshot<2> fastest;

    explicit RunHistory(const SceneParameters<2> &scene,
                        const MPI_Comm            communicator = MPI_COMM_WORLD)
    {
      const TemporaryFolder folder;
      Simulation<2>         simulation(scene, communicator);
      simulation.set_up();
      EventCatalogue<2> catalogue(folder.file("events.csv"),
                                  {"fault"},
                                  make_fault_layouts(
                                    simulation.spatial_problem().jump_basis()),
                                  event_start_slip_rate(scene),
                                  scene.output.event_end_fraction);
      catalogue.add(0., snapshots(simulation));
      double largest = 0, time = 0;
      while (!simulation.is_finished())
        {
          simulation.advance();
          const auto faults = snapshots(simulation);
          catalogue.add(simulation.state().time, faults);
          steps.push_back({simulation.state().time,
                           simulation.state().time - time,
                           fault_statistics(faults.front())});
          time = simulation.state().time;
          if (steps.back().fault.mean_slip_rate > largest)
            {
              largest = steps.back().fault.mean_slip_rate;
              fastest = faults.front();
            }
        }
      catalogue.finish();
      events = catalogue.entries();
    }
  };
} // namespace StickSlip::Tests

#endif
