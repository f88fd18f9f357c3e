// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "kinds_scenes.h"
#include "turned_layers.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * A body from a mesh file that does not deform, against a brick.
 */

namespace
{
  FaultSnapshot<2>
  slipped(const SceneParameters<2> &scene)
  {
    Simulation<2> simulation(scene, MPI_COMM_WORLD);
    run(simulation);
    return snapshots(simulation).front();
  }



  /** A deforming layer of 2 m x 0.5 m on a rigid one, turned by an angle; the
   * rigid one moves under it. */
  FaultSnapshot<2>
  slipped_layers(const double angle, const Settings &more = {})
  {
    const TemporaryFolder folder;
    folder.write("layers.msh",
                 turned_layers(angle, Cells::quadrilaterals).text());
    const std::string bottom = "Boundary conditions/lower bottom/",
                      top    = "Boundary conditions/upper top/";
    return slipped(
      SceneReader(
        folder.write("layers.prm", turned_scene(angle)),
        Settings{"Bodies/lower/Rigid=true",
                 "Bodies/upper/Refinement passes=0",
                 "Faults/fault/Friction=velocity strengthening",
                 "Faults/fault/Normal stress=initial equilibrium",
                 "Gravity/Dip=" + shortest_form(angle * 180. / numbers::PI),
                 bottom + "x condition=velocity",
                 bottom + "y condition=velocity",
                 bottom + "x value=" + shortest_form(-1e-3 * std::cos(angle)),
                 bottom + "y value=" + shortest_form(-1e-3 * std::sin(angle)),
                 top + "x condition=fixed",
                 top + "y condition=free",
                 "Time/Inertia=quasi-dynamic",
                 "Time/End time=1",
                 "TNNMG/Tolerance=1e-10",
                 "Output/Event start slip rate=1"} +
          more)
        .read<2>());
  }



  /** Bricks of the same shape, on a level. */
  const std::string bricks = R"(
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -0.5
  subsection lower
    set Rigid                = true
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
  end
  subsection upper
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 6, 2
    set Uniform refinements  = 2
    set Refinement passes    = 0
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Friction            = velocity strengthening
    set Characteristic slip = 4e-6
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = velocity
    set x value     = -1e-3
  end
  subsection upper top
    set x condition = fixed
  end
end
subsection Time
  set Inertia              = quasi-dynamic
  set End time             = 1
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
subsection Output
  set Event start slip rate = 1
end
)";
} // namespace



TEST(RigidBody, OfAMeshFileIsThatOfABrick)
{
  const FaultSnapshot<2> brick = slipped(read_scene(bricks)),
                         level = slipped_layers(0.);
  const double slip            = mean(brick, brick.slip);
  EXPECT_GT(slip, 1e-7);
  ASSERT_EQ(brick.points.size(), level.points.size());
  for (unsigned int k = 0; k < brick.points.size(); ++k)
    {
      EXPECT_NEAR(level.slip[k][0], brick.slip[k][0], 1e-7 * slip);
      EXPECT_NEAR(level.normal_stress[k],
                  brick.normal_stress[k],
                  1e-7 * brick.normal_stress[k]);
    }
}



TEST(RigidBody, NextToARigidBodyIsRefused)
{
  expect_one_sentence_with(
    message_of([&]() { slipped_layers(0., {"Bodies/upper/Rigid=true"}); }),
    {"'Bodies/upper/Rigid' = 'true'", "at least one body must deform"});
}
