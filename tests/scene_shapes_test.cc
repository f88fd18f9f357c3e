// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/lithostatic_stress.h>

#include <cmath>
#include <sstream>

#include "error_message.h"
#include "mesh_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string stack = R"(
subsection Bodies
  set Names = lower, upper
  set Base elevation = -1
end
subsection Faults
  set Names = main
  subsection main
    set Elevation = 0.1 * sin(2 * pi * x / 5)
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value = 1e-3
  end
end
)";

  const std::string columns = R"(
subsection Bodies
  set Names = west, east
  set Mesh file = columns.msh
  subsection west
    set Uniform refinements = 2
  end
  subsection east
    set Uniform refinements = 2
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Shape = 1 + 0.05 * sin(pi * y)
    set Shape axis = x
  end
end
subsection Boundary conditions
  set Sides = west left, east right
  subsection west left
    set x condition = fixed
    set y condition = fixed
  end
  subsection east right
    set x condition = fixed
    set y condition = velocity
    set y value = 1e-3
  end
end
)";



  double
  elevation(const double x)
  {
    return 0.1 * std::sin(2. * numbers::PI * x / 5.);
  }



  SceneParameters<2>
  read_scene(const std::string              &text,
             const std::vector<std::string> &overrides = {})
  {
    const TemporaryFolder folder;
    folder.write("columns.msh", two_columns().text());
    folder.write("profile.txt", "y\n0 1\n0.5 1.02\n1 1\n2 1.04\n");
    return SceneReader(folder.write("scene.prm", text), overrides).read<2>();
  }



  /** The message when the meshes of a scene are made. */
  std::string
  message(const std::string &text, const std::vector<std::string> &overrides)
  {
    return message_of([&]() { read_scene(text, overrides).coarse_bodies(); });
  }



  std::vector<Point<2>>
  fault_points(const SceneParameters<2> &scene, const unsigned int side)
  {
    return MeshHierarchy<2>(scene.coarse_bodies(),
                            scene.topology,
                            MPI_COMM_WORLD)
      .finest()
      .surface(0, side)
      .points;
  }
} // namespace



TEST(SceneShapes, FaultsOfAStackHaveAnElevation)
{
  const auto scene = read_scene(stack);
  for (const unsigned int side : {0, 1})
    for (const Point<2> &point : fault_points(scene, side))
      EXPECT_NEAR(point[1], elevation(point[0]), 1e-16);
  EXPECT_EQ(scene.bodies[1].geometry.thickness_at(Point<2>(1.25, 0.)),
            1. - elevation(1.25));
}



TEST(SceneShapes, LithostaticStressFollowsTheElevation)
{
  const auto scene =
    read_scene(stack,
               {"Gravity/Acceleration=10",
                "Bodies/upper/Upper slope=0.2",
                "Bodies/upper/Material/Density=1e3*(4 + x) + 4e3*y"});
  for (const double x : {-2., 0.3, 1.25})
    {
      const double top = 1. + 0.2 * (x + 2.5), lower = elevation(x);
      const double exact = 10. * (1e3 * (4. + x) * (top - lower) +
                                  2e3 * (top * top - lower * lower));
      EXPECT_NEAR(lithostatic_stress(scene, 0, {Point<2>(x, lower)})[0],
                  exact,
                  1e-8);
    }
}



// A plain number is the level stack moved.
TEST(SceneShapes, ANumberIsALevelFault)
{
  const auto scene = read_scene(stack, {"Faults/main/Elevation=0.25"});
  for (const Point<2> &point : fault_points(scene, 1))
    EXPECT_EQ(point[1], 0.25);
  const auto level =
    MeshHierarchy<2>(scene.coarse_bodies(), scene.topology, MPI_COMM_WORLD)
      .finest()
      .surface(0, 0);
  EXPECT_TRUE(level.is_plane());
}



TEST(SceneShapes, FaultsOfMeshFilesHaveAShape)
{
  for (const unsigned int side : {0, 1})
    {
      for (const Point<2> &point : fault_points(read_scene(columns), side))
        EXPECT_EQ(point[0], 1. + 0.05 * std::sin(numbers::PI * point[1]));
      const auto smooth = read_scene(columns,
                                     {"Faults/fault/Shape=smooth",
                                      "Faults/fault/Shape axis=last"});
      for (const Point<2> &point : fault_points(smooth, side))
        EXPECT_EQ(point[0], 1.);
    }
  const TemporaryFolder folder;
  folder.write("columns.msh", two_columns().text());
  folder.write("profile.txt", "y\n0 1\n0.5 1.02\n1 1\n2 1.04\n");
  std::string text = columns;
  text.replace(text.find("1 + 0.05 * sin(pi * y)"), 22, "table profile.txt");
  const auto scene = SceneReader(folder.write("scene.prm", text)).read<2>();
  for (const Point<2> &point : fault_points(scene, 0))
    EXPECT_NEAR(point[0],
                1. + (point[1] < 0.5 ? 0.04 * point[1] :
                      point[1] < 1.  ? 0.04 * (1. - point[1]) :
                                       0.04 * (point[1] - 1.)),
                1e-15);
}



TEST(SceneShapes, WrittenParametersGiveTheSameShapes)
{
  const TemporaryFolder folder;
  folder.write("columns.msh", two_columns().text());
  for (const std::string &scene_text : {stack, columns})
    {
      const auto scene =
        SceneReader(folder.write("scene.prm", scene_text)).read<2>();
      std::ostringstream text, again;
      write_parameters(scene, text);
      const auto same =
        SceneReader(folder.write("again.prm", text.str())).read<2>();
      write_parameters(same, again);
      EXPECT_EQ(again.str(), text.str());
      EXPECT_EQ(fault_points(same, 0), fault_points(scene, 0));
    }
}



TEST(SceneShapes, MistakesAreAnsweredWithOneSentence)
{
  EXPECT_EQ(message(stack, {}), "no error");
  EXPECT_EQ(message(columns, {}), "no error");
  expect_one_sentence_with(message(stack, {"Faults/main/Elevation=0.1*y"}),
                           {"Faults/main/Elevation", "must not depend on y"});
  expect_one_sentence_with(message(stack, {"Faults/main/Elevation=flat"}),
                           {"Faults/main/Elevation", "flat"});
  expect_one_sentence_with(message(stack, {"Faults/main/Elevation=x"}),
                           {"'Bodies/", "Elevation", "thickness of -1.5 m"});
  expect_one_sentence_with(message(stack, {"Bodies/lower/Rigid=true"}),
                           {"Faults/main/Elevation", "'lower' is rigid"});
  expect_one_sentence_with(
    message(stack,
            {"Faults/main/Elevation=0.1*x",
             "Boundary conditions/Periodic along x=true"}),
    {"Faults/main/Elevation", "one end along x", "both must agree"});
  EXPECT_EQ(message(stack, {"Boundary conditions/Periodic along x=true"}),
            "no error");
  expect_one_sentence_with(message(stack, {"Faults/main/Shape=smooth"}),
                           {"Faults/main/Shape", "no effect"});
  expect_one_sentence_with(message(columns, {"Faults/fault/Elevation=0"}),
                           {"Faults/fault/Elevation", "no effect"});
  expect_one_sentence_with(message(columns, {"Faults/fault/Shape=smoth"}),
                           {"Faults/fault/Shape", "smoth"});
  expect_one_sentence_with(message(columns, {"Faults/fault/Shape=1 + 0.1*x"}),
                           {"Faults/fault/Shape", "must not depend on x"});
  expect_one_sentence_with(message(columns, {"Faults/fault/Shape axis=z"}),
                           {"Faults/fault/Shape axis", "two dimensions"});
  expect_one_sentence_with(message(columns, {"Faults/fault/Shape=1.2"}),
                           {"'fault'", "0.2 m off its 'Shape'", "a tenth"});
}
