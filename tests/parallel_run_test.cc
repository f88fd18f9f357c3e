// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/agreed_failure.h>

#include "nan_in_debug_mode.h"
#include "parallel_comparison.h"
#include "shared_and_alone.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

TEST(ParallelRun, SpringSliderHasTheSameFirstEvent)
{
  const SceneParameters<2> scene =
    published_scene("spring_slider",
                    {"Time/End time=24", "TNNMG/Tolerance=1e-9"});
  const RunHistory ours(scene, MPI_COMM_WORLD);
  ASSERT_EQ(ours.events.size(), 1u);
  EXPECT_GT(ours.events[0].start, 20.);

  // One process repeats it alone, while the others wait for the figures.
  std::vector<double> expected(3);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      const RunHistory alone(scene, MPI_COMM_SELF);
      if (alone.events.size() == 1)
        expected = {alone.events[0].start,
                    alone.events[0].end,
                    alone.events[0].peak_slip_rate};
    }
  expected = Utilities::MPI::broadcast(MPI_COMM_WORLD, expected, 0);
  EXPECT_NEAR(ours.events[0].start, expected[0], 1e-6);
  EXPECT_NEAR(ours.events[0].end, expected[1], 1e-6);
  EXPECT_NEAR(ours.events[0].peak_slip_rate, expected[2], 1e-5 * expected[2]);
}



namespace
{
  void
  expect_equal_sliding(const std::vector<std::string> &more)
  {
    const SceneParameters<2> scene =
      fast_sliding_scene(Settings{"TNNMG/Tolerance=1e-9"} + more);
    SharedAndAlone runs(scene);
    EXPECT_GT(runs.alone.counts().contact_mappings, 5u);
    EXPECT_EQ(runs.shared.counts().contact_mappings,
              runs.alone.counts().contact_mappings);
    for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
      {
        EXPECT_NEAR(runs.ours.weights[k], runs.one.weights[k], 1e-6);
        if (runs.one.weights[k] > 0.)
          {
            EXPECT_NEAR(runs.one.slip[k][0], 0.5, 0.005);
          }
      }
    EXPECT_LT(difference(runs.shared.state().displacement,
                         runs.shared.meshes().finest().nodes,
                         runs.alone.state().displacement,
                         numbers_on_one(runs.shared.meshes().finest())),
              1e-6);
  }
} // namespace



TEST(ParallelRun, LargeSlidingIsTheSame)
{
  expect_equal_sliding({});
}



TEST(ParallelRun, LargeSlidingOfNonmatchingMeshesIsTheSame)
{
  expect_equal_sliding({"Bodies/lower/Coarse cells=7, 2"});
}



TEST(ParallelRun, LargeSlidingOverABendIsTheSame)
{
  expect_equal_sliding({"Faults/fault/Elevation=0.005 * sin(3 * x)",
                        "Bodies/lower/Coarse cells=7, 2"});
}



TEST(ParallelRun, LargeSlidingOfEndlessBodiesIsTheSame)
{
  expect_equal_sliding({"Boundary conditions/Periodic along x=true",
                        "Bodies/lower/Coarse cells=7, 2",
                        "Faults/fault/Initial state=1 + 0.2 * cos(pi * x)"});
}



TEST(ParallelRun, LargeSlidingWithoutInertiaIsTheSame)
{
  for (const std::string inertia : {"quasi-dynamic", "quasi-static"})
    expect_equal_sliding({"Time/Inertia=" + inertia});
}



TEST(ParallelRun, NoNumberOnOneProcessIsAFailureOnAll)
{
  SKIP_WHERE_NAN_IS_FATAL();
  // Near the right end only, so in the part of one process.
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Boundary conditions/upper top/x value="
                "if(x > 0.9 && t > 0.3 && t < 0.9, sqrt(-1), 2e-4)"});
  Simulation<2> simulation(scene, MPI_COMM_WORLD);
  simulation.set_up();
  const auto run = [&]() {
    while (!simulation.is_finished())
      simulation.advance();
  };
  EXPECT_THROW(run(), StepSizeTooSmall);
  // The last good state is there, and the same everywhere.
  EXPECT_LE(simulation.state().time, 0.3);
  EXPECT_GT(simulation.state().time, 0.29);
  EXPECT_TRUE(std::isfinite(simulation.state().velocity.l2_norm()));
  const auto times =
    Utilities::MPI::all_gather(MPI_COMM_WORLD, simulation.state().time);
  for (const double time : times)
    EXPECT_EQ(time, simulation.state().time);
}
