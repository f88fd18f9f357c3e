// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/block.h>
#include <stickslip/geometry/fault_cutting.h>
#include <stickslip/scene/scene_reader.h>

#include <cmath>

#include "error_message.h"
#include "mesh_volume.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A body below an arch, and how it is divided. */
  template <int dim>
  Block<dim>
  arched_block()
  {
    Block<dim> block;
    block.name         = "lower";
    block.section      = "Bodies/lower";
    block.corners      = {{{-2., -1.}, {2., -1.5}, {2.5, 0.}, {-2., 0.}}};
    block.polylines[3] = {{-1., 0.4}, {0., 0.5}, {1.5, 0.3}};
    block.along_y      = {{-1., 2.}};
    block.cells.fill(2);
    block.cells[0] = 7;
    return block;
  }



  /** Twice the area inside a polygon, m^2. */
  double
  twice_area(const std::vector<Point<2>> &polygon)
  {
    double sum = 0.;
    for (unsigned int k = 0; k < polygon.size(); ++k)
      {
        const Point<2> &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        sum += a[0] * b[1] - a[1] * b[0];
      }
    return sum;
  }



  std::vector<Point<2>>
  outline(const Block<2> &block)
  {
    const auto           &c = block.corners;
    std::vector<Point<2>> result;
    const auto            add = [&result](const Point<2>              &corner,
                               const std::vector<Point<2>> &points) {
      result.push_back(corner);
      result.insert(result.end(), points.begin(), points.end());
    };
    const auto reversed = [](std::vector<Point<2>> points) {
      std::reverse(points.begin(), points.end());
      return points;
    };
    add(c[0], block.polylines[2]);
    add(c[1], block.polylines[1]);
    add(c[2], reversed(block.polylines[3]));
    add(c[3], reversed(block.polylines[0]));
    return result;
  }



  /** Two blocks that a fault in the shape of an arch or a step separates. */
  std::vector<Block<2>>
  two_blocks()
  {
    std::vector<Block<2>> blocks(2, arched_block<2>());
    blocks[1].name         = "upper";
    blocks[1].section      = "Bodies/upper";
    blocks[1].corners      = {{{-2., 0.}, {2.5, 0.}, {2.5, 2.}, {-2., 2.}}};
    blocks[1].polylines[2] = blocks[0].polylines[3];
    blocks[1].polylines[3].clear();
    blocks[1].cells = {{10, 3}};
    return blocks;
  }



  const std::vector<MeshFault> the_fault = {
    {"fault", "fault", {{{{"lower", "top"}}, {{"upper", "bottom"}}}}}};



  CutMesh<2>
  cut(const std::vector<Block<2>> &blocks)
  {
    return cut_at_faults(cells_of_blocks(blocks), the_fault);
  }



  std::string
  message_of_blocks(const std::function<void(std::vector<Block<2>> &)> &change)
  {
    return message_of([&change]() {
      std::vector<Block<2>> blocks = two_blocks();
      change(blocks);
      cut(blocks);
    });
  }



  const std::string scene = R"(
subsection Bodies
  set Names = lower, upper
  subsection lower
    set Corners      = -2 -1, 2 -1, 2 0, -2 0
    set Coarse cells = 4, 2
  end
  subsection upper
    set Corners      = -2 0, 2 0, 2 1, -2 1
    set Coarse cells = 3, 1
  end
end
subsection Faults
  set Names = main
  subsection main
    set Between = lower top, upper bottom
  end
end
subsection Boundary conditions
  set Sides = lower bottom
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Output
  set Event start slip rate = 1e-3
end
)";



  std::string
  message_of_scene(const std::string &override)
  {
    return message_of([&override]() {
      const TemporaryFolder folder;
      SceneReader(folder.write("scene.prm", scene), {override}).read<2>();
    });
  }
} // namespace



TEST(BlockCells, FillTheOutline)
{
  const std::vector<Block<2>> blocks = two_blocks();
  const CutMesh<2>            mesh   = cut(blocks);
  for (const unsigned int b : {0, 1})
    EXPECT_NEAR(volume(*mesh.bodies[b].triangulation()),
                0.5 * twice_area(outline(blocks[b])),
                1e-13);
  EXPECT_EQ(mesh.bodies[0].cells.size(), 14u);
  EXPECT_EQ(mesh.bodies[1].cells.size(), 30u);
}



TEST(BlockCells, AreExtrudedAlongY)
{
  const CutMesh<3> mesh =
    cut_at_faults(cells_of_blocks(std::vector<Block<3>>{arched_block<3>()}),
                  {});
  EXPECT_NEAR(volume(*mesh.bodies[0].triangulation()),
              3. * 0.5 * twice_area(outline(arched_block<2>())),
              1e-12);
  const std::array<const char *, 6> names = {
    {"left", "right", "front", "back", "bottom", "top"}};
  for (const char *const name : names)
    EXPECT_EQ(std::count_if(mesh.bodies[0].side_names.begin(),
                            mesh.bodies[0].side_names.end(),
                            [name](const auto &side) {
                              return side.second == name;
                            }),
              1)
      << name;
  for (const auto &side : mesh.bodies[0].side_names)
    if (side.second == "front" || side.second == "back")
      {
        const double y = side.second == "front" ? -1. : 2.;
        for (const Point<3> &vertex : mesh.bodies[0].vertices_on(side.first))
          EXPECT_EQ(vertex[1], y);
      }
}



// However many cells there are, the sides of a fault have all points of the
// polyline, and are nowhere else.
TEST(BlockCells, HaveThePointsOfPolylines)
{
  std::vector<Block<2>> blocks = two_blocks();
  for (const unsigned int n : {4u, 5u, 9u, 23u})
    {
      blocks[1].cells[0]    = n;
      const CutMesh<2> mesh = cut(blocks);
      for (const unsigned int side : {0, 1})
        {
          const BodySide part = mesh.topology.faults()[0].sides[side][0];
          const auto on_side  = mesh.bodies[part.body].vertices_on(part.side);
          double     length   = 0.;
          for (const auto &line :
               mesh.bodies[part.body].boundary.boundary_lines)
            if (line.boundary_id == part.side)
              length +=
                mesh.bodies[part.body].vertices[line.vertices[0]].distance(
                  mesh.bodies[part.body].vertices[line.vertices[1]]);
          double                exact  = 0.;
          std::vector<Point<2>> points = blocks[0].polylines[3];
          points.insert(points.begin(), blocks[0].corners[3]);
          points.push_back(blocks[0].corners[2]);
          for (unsigned int k = 0; k < points.size(); ++k)
            {
              EXPECT_NE(std::find(on_side.begin(), on_side.end(), points[k]),
                        on_side.end())
                << points[k];
              exact += k > 0 ? points[k].distance(points[k - 1]) : 0.;
            }
          EXPECT_NEAR(length, exact, 1e-13);
        }
    }
}



TEST(BlockCells, RefuseWhatIsNoBlock)
{
  using Blocks = std::vector<Block<2>>;
  expect_one_sentence_with(message_of_blocks([](Blocks &b) {
                             b[1].corners[2] = b[1].corners[1];
                           }),
                           {"'Bodies/upper/Corners'", "two corners"});
  expect_one_sentence_with(message_of_blocks([](Blocks &b) {
                             std::swap(b[1].corners[1], b[1].corners[3]);
                             b[1].polylines[2].clear();
                           }),
                           {"'Bodies/upper/Corners'", "clockwise"});
  expect_one_sentence_with(message_of_blocks([](Blocks &b) {
                             b[1].corners[2] = Point<2>(-1., 0.7);
                           }),
                           {"'Bodies/upper/Corners'", "inverted"});
  expect_one_sentence_with(message_of_blocks([](Blocks &b) {
                             // A triangle with a corner on one edge.
                             b[1].corners[0] = Point<2>(-2., 1.);
                             b[1].polylines[2].clear();
                             b[1].corners[3] = Point<2>(-2., 2.);
                             b[1].corners[1] = Point<2>(-2., 0.);
                           }),
                           {"'Bodies/upper/Corners'",
                            "(-2, 1)",
                            "between 0 and 180 degrees"});
  expect_one_sentence_with(
    message_of_blocks([](Blocks &b) { b[1].cells[0] = 3; }),
    {"'Bodies/upper/Bottom polyline'", "4 pieces", "3 'Coarse cells'"});
  expect_one_sentence_with(message_of_blocks([](Blocks &b) {
                             b[1].polylines[2].push_back(b[1].corners[1]);
                           }),
                           {"'Bodies/upper/Bottom polyline'",
                            "two points at (2.5, 0)"});
}



TEST(BlockCells, RefuseSidesThatDoNotTouch)
{
  using Blocks    = std::vector<Block<2>>;
  const auto move = [](Blocks &b, const double x, const double y) {
    for (Point<2> &corner : b[1].corners)
      corner += Point<2>(x, y);
    for (Point<2> &point : b[1].polylines[2])
      point += Point<2>(x, y);
  };
  EXPECT_EQ(message_of_blocks([](Blocks &) {}), "no error");
  expect_one_sentence_with(message_of_blocks(
                             [&](Blocks &b) { move(b, 0., 0.3); }),
                           {"'fault'", "0.278543 m apart at (-1.85, 0.06)"});
  expect_one_sentence_with(message_of_blocks(
                             [&](Blocks &b) { move(b, 0., 9.); }),
                           {"'lower top'", "'fault'", "does not touch"});
  expect_one_sentence_with(message_of_blocks(
                             [&](Blocks &b) { move(b, 4.5, 0.); }),
                           {"'lower top'", "'fault'", "does not touch"});
  expect_one_sentence_with(message_of_blocks(
                             [&](Blocks &b) { move(b, 0., -0.3); }),
                           {"'lower'", "'upper'", "overlap at"});
  // One straight side, where the other one is an arch.
  expect_one_sentence_with(message_of_blocks(
                             [](Blocks &b) { b[0].polylines[3].clear(); }),
                           {"'fault'", "m apart at"});
}



TEST(BlockScene, IsReadLikeOneOfMeshFiles)
{
  const TemporaryFolder    folder;
  const SceneParameters<2> read =
    SceneReader(folder.write("scene.prm", scene)).read<2>();
  ASSERT_NE(read.mesh, nullptr);
  EXPECT_EQ(read.topology.faults()[0].name, "main");
  EXPECT_EQ(read.boundary_conditions[0].side_name, "bottom");
  const auto bodies = read.coarse_bodies();
  EXPECT_EQ(bodies[0].cells->n_active_cells(), 8u);
  EXPECT_EQ(bodies[1].cells->n_active_cells(), 3u);
  EXPECT_EQ(bodies[0].refinement_passes, 4u);
}



TEST(BlockScene, RefusesWhatDoesNotFit)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> mistakes =
    {{"Bodies/upper/Corners=-2 0, 2 0, 2 1",
      {"'Bodies/upper/Corners'", "4 points"}},
     {"Bodies/upper/Corners=", {"'Bodies/upper/Corners'", "either all"}},
     {"Bodies/upper/Thickness=2", {"'Bodies/upper/Thickness'", "blocks"}},
     {"Bodies/Length unit=2", {"'Bodies/Length unit'", "blocks"}},
     {"Boundary conditions/Periodic along x=true",
      {"'Boundary conditions/Periodic along x'", "blocks"}},
     {"Faults/main/Normal stress=lithostatic",
      {"'Faults/main/Normal stress'", "bricks in a stack"}},
     {"Faults/main/Between=", {"'Faults/main/Between'", "Corners"}},
     {"Faults/main/Between=lower, upper", {"'lower' is no side"}},
     {"Faults/main/Between=lower top, upper base",
      {"'upper base' is no side", "left, right, bottom, top"}},
     {"Faults/main/Between=lower top, over bottom",
      {"no body 'over'", "lower, upper"}},
     {"Faults/main/Between=lower top, upper bottom + upper bottom",
      {"'upper bottom' is named twice"}},
     {"Faults/main/Between=lower top, upper top", {"'main'", "apart at"}}};
  for (const auto &[override, parts] : mistakes)
    expect_one_sentence_with(message_of_scene(override), parts);
}
