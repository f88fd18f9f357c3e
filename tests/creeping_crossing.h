// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_creeping_crossing_h
#define stickslip_tests_creeping_crossing_h

#include "crossing_mesh.h"
#include "simulation_scenes.h"

namespace StickSlip::Tests
{
  /** A sheared block with three faults, "1" to "3", of which two cross the
   * first; they creep from the start. */
  inline SceneParameters<2>
  creeping_crossing_scene(const std::vector<std::string> &settings)
  {
    std::string faults;
    for (const char *name : {"1", "2", "3"})
      faults += std::string("  subsection ") + name + R"(
    set a                              = 0.02
    set b                              = 0.01
    set Reference friction coefficient = 0
    set Reference slip rate            = 1e-3
    set Characteristic slip            = 1e-3
    set Regularisation                 = arcsinh
    set Initial state                  = 1 + 0.1 * x
    set Normal stress                  = function
    set Normal stress function         = 2e4 + 1e3 * y
  end
)";
    const TemporaryFolder folder;
    folder.write("block.msh", crossing_faults_mesh(3).text());
    return SceneReader(folder.write("scene.prm",
                                    R"(
subsection Bodies
  set Names     = block
  set Mesh file = block.msh
end
subsection Faults
  set Names = 1, 2, 3
)" + faults + R"(end
subsection Boundary conditions
  set Sides = block sides
  subsection block sides
    set x condition = velocity
    set x value     = 2e-3 * y
    set y condition = velocity
    set y value     = 1e-3 * x
    set Ramp length = 0.1
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time             = 0.2
  set Largest step         = 0.02
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
)"),
                       settings)
      .read<2>();
  }



  /** The three faults at the end of a run. */
  inline std::vector<FaultSnapshot<2>>
  end_of_crossing(const std::vector<std::string> &settings,
                  const MPI_Comm                  communicator = MPI_COMM_WORLD)
  {
    Simulation<2> simulation(creeping_crossing_scene(settings), communicator);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation, {"1", "2", "3"});
  }



  /** All faults are the same up to a part of their largest slip and of their
   * states, and have slipped. */
  inline void
  expect_same_faults(const std::vector<FaultSnapshot<2>> &a,
                     const std::vector<FaultSnapshot<2>> &b,
                     const double                         tolerance)
  {
    ASSERT_EQ(a.size(), b.size());
    for (unsigned int f = 0; f < a.size(); ++f)
      {
        double largest = 0., slip = 0., state = 0.;
        ASSERT_EQ(a[f].slip.size(), b[f].slip.size());
        for (unsigned int k = 0; k < a[f].slip.size(); ++k)
          {
            EXPECT_EQ(a[f].points[k], b[f].points[k]);
            largest = std::max(largest, std::abs(a[f].slip[k][0]));
            slip = std::max(slip, std::abs(a[f].slip[k][0] - b[f].slip[k][0]));
            state =
              std::max(state,
                       std::abs(a[f].state[k] - b[f].state[k]) / a[f].state[k]);
          }
        EXPECT_GT(largest, 1e-5) << a[f].name;
        EXPECT_LE(slip, tolerance * largest) << a[f].name;
        EXPECT_LE(state, tolerance) << a[f].name;
      }
  }
} // namespace StickSlip::Tests

#endif
