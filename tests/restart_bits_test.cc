// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/time_series.h>

#include "error_message.h"
#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  double
  mean_slip_rate(Simulation<2> &simulation)
  {
    return fault_statistics(snapshots(simulation).front()).mean_slip_rate;
  }



  /** Advance, and write the row of the time series. */
  void
  advance(Simulation<2> &simulation, TimeSeries<2> &series)
  {
    const double time = simulation.state().time;
    simulation.advance();
    StepRecord row;
    row.time      = simulation.state().time;
    row.step_size = row.time - time;
    series.add(row, snapshots(simulation));
  }



  /** A simulation that is written to files and one that never is, both at 1 s
   * after more than two contact mappings. */
  struct KeptAndNeverWritten
  {
    Simulation<2> kept, never_written;

    explicit KeptAndNeverWritten(const SceneParameters<2> &scene)
      : kept(scene, MPI_COMM_WORLD)
      , never_written(scene, MPI_COMM_WORLD)
    {
      for (Simulation<2> *simulation : {&kept, &never_written})
        {
          simulation->set_up();
          while (simulation->state().time < 1.)
            simulation->advance();
        }
      EXPECT_GT(kept.counts().contact_mappings, 2u);
    }
  };



  /** Write the state of a simulation, and expect that another one goes on from
   * there with the same bits for a number of advances, and the simulation
   * itself with those of one that was never written. Returns the largest
   * mean slip rate on the way, m/s. */
  double
  expect_same_bits(const SceneParameters<2> &scene,
                   Simulation<2>            &never_written,
                   Simulation<2>            &kept,
                   const unsigned int        n_advances)
  {
    const TemporaryFolder folder;
    double                fastest = 0;
    EXPECT_TRUE(same_bits(kept.state(), never_written.state()));
    kept.write_state(folder.file("state"));
    Simulation<2> resumed(scene, MPI_COMM_WORLD);
    resumed.resume(folder.file("state"));
    EXPECT_TRUE(same_bits(resumed.state(), kept.state()));
    {
      TimeSeries<2> of_kept(folder.file("kept.csv"), snapshots(kept));
      TimeSeries<2> of_resumed(folder.file("resumed.csv"), snapshots(resumed));
      for (unsigned int i = 0; i < n_advances && !kept.is_finished(); ++i)
        {
          advance(kept, of_kept);
          advance(resumed, of_resumed);
          never_written.advance();
          EXPECT_TRUE(same_bits(resumed.state(), kept.state())) << i;
          EXPECT_TRUE(same_bits(never_written.state(), kept.state())) << i;
          if (i % 10 == 3)
            kept.write_state(folder.file("later"));
          fastest = std::max(fastest, mean_slip_rate(kept));
        }
    }
    EXPECT_EQ(content_of(folder.file("resumed.csv")),
              content_of(folder.file("kept.csv")));
    if (kept.energy_balance() != nullptr)
      {
        EXPECT_EQ(resumed.energy_balance()->defect(resumed.state()),
                  kept.energy_balance()->defect(kept.state()));
      }
    return fastest;
  }
} // namespace



TEST(Resume, GoesOnWithTheSameBitsAfterTheContactHasChanged)
{
  const Settings following = {"Gravity/Acceleration=1",
                              "Faults/fault/Normal stress=lithostatic",
                              "Faults/fault/Normal stress follows=true"};
  for (const Settings &more :
       {Settings{},
        following,
        Settings{"Time/Inertia=quasi-static"},
        Settings{"Time/Inertia=quasi-dynamic"},
        Settings{"Time/Step size control=step doubling",
                 "Time/Doubling threshold=1e-3"},
        Settings{"Time/Step size control=constant"},
        Settings{"Time/Rate solver=condensed Newton"},
        Settings{"Time/Rate-state method=nested"},
        Settings{"TNNMG/Coarse solver=AMG"},
        Settings{"TNNMG/Linear correction=UMFPACK"},
        Settings{"Faults/fault/Elevation=0.005*sin(3*x)"},
        following + Settings{"Faults/fault/Elevation=0.005*sin(3*x)"},
        Settings{"Boundary conditions/upper top/x value=0.25+0.1*sin(5*t)"}})
    {
      SCOPED_TRACE(more.empty() ? "as it is" : more.back());
      const SceneParameters<2> scene = fast_sliding_scene(more);
      KeptAndNeverWritten      runs(scene);
      const unsigned int       n_mappings = runs.kept.counts().contact_mappings;
      expect_same_bits(scene, runs.never_written, runs.kept, 15);
      EXPECT_GT(runs.kept.counts().contact_mappings, n_mappings);
    }
}



TEST(Resume, ExplicitStepsGoOnWithTheSameBits)
{
  for (const std::string energy : {"true", "false"})
    {
      SCOPED_TRACE(energy);
      const SceneParameters<2> scene =
        fast_sliding_scene({"Bodies/lower/Material/Shear viscosity=0",
                            "Bodies/lower/Material/Bulk viscosity=0",
                            "Bodies/upper/Material/Shear viscosity=0",
                            "Bodies/upper/Material/Bulk viscosity=0",
                            "Faults/fault/Normal stress follows=true",
                            "Time/Inertia=quasi-dynamic",
                            "Time/Step size control=Runge-Kutta",
                            "Output/Energy balance=" + energy});
      KeptAndNeverWritten runs(scene);
      expect_same_bits(scene, runs.never_written, runs.kept, 60);
    }
}



TEST(Resume, CentralDifferencesGoOnWithTheSameBits)
{
  const SceneParameters<2> scene =
    fast_sliding_scene({"Time/Step size control=central differences"});
  KeptAndNeverWritten runs(scene);
  expect_same_bits(scene, runs.never_written, runs.kept, 200);
}



TEST(Resume, GoesOnWithTheSameBitsThroughAnEvent)
{
  const SceneParameters<2> scene =
    published_scene("spring_slider",
                    {"Bodies/lower/Refinement passes=2",
                     "Bodies/upper/Refinement passes=1"});
  Simulation<2> kept(scene, MPI_COMM_WORLD),
    never_written(scene, MPI_COMM_WORLD);
  for (Simulation<2> *simulation : {&kept, &never_written})
    {
      simulation->set_up();
      // The start of the loading is no event.
      while (simulation->state().time < 15. ||
             mean_slip_rate(*simulation) < 1e-4)
        simulation->advance();
    }
  EXPECT_GT(expect_same_bits(scene, never_written, kept, 1500), 1e-3);
  // The event is over.
  EXPECT_LT(mean_slip_rate(kept), 1e-3);
}



TEST(Resume, WrongFilesAreRefused)
{
  const TemporaryFolder    folder;
  const SceneParameters<2> scene = fast_sliding_scene({});
  Simulation<2>            simulation(scene, MPI_COMM_WORLD);
  const auto message = [&](Simulation<2> &which, const std::string &name) {
    return message_of([&]() { which.resume(folder.file(name)); });
  };
  expect_one_sentence_with(message(simulation, "none"),
                           {folder.file("none"), "is not the state of a run"});
  folder.write("text", "no state\n");
  expect_one_sentence_with(message(simulation, "text"),
                           {"is not the state of a run"});

  simulation.set_up();
  simulation.write_state(folder.file("state"));
  const std::string content = content_of(folder.file("state"));
  folder.write("part", content.substr(0, content.size() / 2));
  expect_one_sentence_with(message(simulation, "part"), {"is damaged"});
  std::string changed = content;
  changed[changed.size() / 2] ^= 1;
  folder.write("changed", changed);
  expect_one_sentence_with(message(simulation, "changed"), {"is damaged"});
  const std::size_t version = content.find(' ') + 1;
  folder.write("other",
               content.substr(0, version) + "1" +
                 content.substr(content.find(' ', version)));
  expect_one_sentence_with(message(simulation, "other"),
                           {"another version of the program"});
  Simulation<2> finer(fast_sliding_scene({"Bodies/upper/Refinement passes=3"}),
                      MPI_COMM_WORLD);
  expect_one_sentence_with(message(finer, "state"),
                           {"is not the state of a run with these meshes"});
  EXPECT_THROW(simulation.write_state(folder.file("no/state")), InputError);
}
