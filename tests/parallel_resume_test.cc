// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  void
  advance_until(Simulation<2> &simulation, const double time)
  {
    while (simulation.state().time < time && !simulation.is_finished())
      simulation.advance();
  }



  void
  expect_close(Simulation<2> &a, Simulation<2> &b)
  {
    EXPECT_EQ(a.state().time, b.state().time);
    const FaultSnapshot<2> of_a = snapshots(a).front(),
                           of_b = snapshots(b).front();
    ASSERT_EQ(of_a.slip.size(), of_b.slip.size());
    for (unsigned int k = 0; k < of_a.slip.size(); ++k)
      {
        EXPECT_EQ(of_a.points[k], of_b.points[k]);
        EXPECT_NEAR(of_a.slip[k][0], of_b.slip[k][0], 1e-6);
        EXPECT_NEAR(of_a.slip_rate[k][0], of_b.slip_rate[k][0], 1e-5);
        EXPECT_NEAR(of_a.state[k], of_b.state[k], 1e-4 * of_b.state[k]);
      }
  }
} // namespace



/* A run on all processes goes on alone, and one alone on all processes. */
TEST(ParallelResume, AnyNumberOfProcessesGoesOn)
{
  // A level fault, and one that bends.
  for (const char *elevation : {"level", "0.005*sin(3*x)"})
    {
      const SceneParameters<2> scene =
        read_scene(creeping_bodies,
                   {std::string("Faults/fault/Elevation=") + elevation,
                    "Boundary conditions/upper top/x value=0.25",
                    "Boundary conditions/upper top/Ramp length=0.2",
                    "Faults/fault/Reference slip rate=0.25",
                    "Faults/fault/Characteristic slip=0.25",
                    "Faults/fault/Normal stress function=1e3",
                    "Time/End time=1.1",
                    "Time/Largest step=0.05",
                    "Time/Tolerance=1e-3",
                    "TNNMG/Tolerance=1e-9"});
      const TemporaryFolder folder;
      const std::string     file =
        Utilities::MPI::broadcast(MPI_COMM_WORLD, folder.file("state"));
      Simulation<2> shared(scene, MPI_COMM_WORLD), alone(scene, MPI_COMM_SELF);
      shared.set_up();
      advance_until(shared, 0.5);
      shared.write_state(file);
      EXPECT_GT(shared.counts().contact_mappings, 2u);
      alone.resume(file);
      advance_until(shared, 0.8);
      advance_until(alone, 0.8);
      expect_close(alone, shared);

      const bool is_first =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      const std::string second =
        Utilities::MPI::broadcast(MPI_COMM_WORLD, folder.file("second"));
      alone.write_state(is_first ? second : folder.file("mine"));
      MPI_Barrier(MPI_COMM_WORLD);
      Simulation<2> shared_again(scene, MPI_COMM_WORLD);
      shared_again.resume(second);
      advance_until(alone, 1.1);
      advance_until(shared_again, 1.1);
      expect_close(alone, shared_again);
      // No process deletes its files before the others have read them.
      MPI_Barrier(MPI_COMM_WORLD);
    }
}
