// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <sstream>

#include "error_message.h"
#include "mesh_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two layers of squares of 0.5, 10 x 2 each, with the fault at height 1. */
  MeshText
  two_layers()
  {
    MeshText mesh;
    mesh.groups     = {{2, 1, "lower"},
                       {2, 2, "upper"},
                       {1, 1, "main"},
                       {1, 2, "bottom"},
                       {1, 3, "top"},
                       {1, 4, "ends"}};
    const auto node = [](const int x, const int y) { return 11 * y + x + 1; };
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 11; ++x)
        mesh.nodes.push_back({{0.5 * x - 2.5, 0.5 * y, 0.}});
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 10; ++x)
        mesh.elements.push_back(
          {3,
           y < 2 ? 1 : 2,
           {node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)}});
    for (int x = 0; x < 10; ++x)
      for (const auto &[y, group] :
           std::vector<std::pair<int, int>>{{0, 2}, {2, 1}, {4, 3}})
        mesh.elements.push_back({1, group, {node(x, y), node(x + 1, y)}});
    for (int y = 0; y < 4; ++y)
      for (const int x : {0, 10})
        mesh.elements.push_back({1, 4, {node(x, y), node(x, y + 1)}});
    return mesh;
  }



  const std::string bricks = R"(
subsection Bodies
  set Names = lower, upper
  subsection lower
    set Refinement passes = 2
  end
  subsection upper
    set Refinement passes = 2
  end
end
)";

  const std::string layers = bricks + R"(
subsection Bodies
  set Mesh file = layers.msh
  set Length unit = 0.001
end
)";

  const std::string rest = R"(
subsection Faults
  set Names = main
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



  MeshText
  in_millimetres(MeshText mesh)
  {
    for (auto &node : mesh.nodes)
      for (double &x : node)
        x *= 1000.;
    return mesh;
  }



  SceneParameters<2>
  read_scene(const TemporaryFolder &folder, const std::string &text)
  {
    folder.write("layers.msh", in_millimetres(two_layers()).text());
    return SceneReader(folder.write("scene.prm", text)).read<2>();
  }



  std::string
  message_of_scene(const std::string &text)
  {
    const TemporaryFolder folder;
    return message_of([&]() { read_scene(folder, text); });
  }



  /** The scene with one more entry in a section. */
  std::string
  with(const std::string &text,
       const std::string &section,
       const std::string &entry)
  {
    std::string       result = text;
    const std::size_t place  = result.find("subsection " + section + "\n");
    EXPECT_NE(place, std::string::npos) << section;
    result.insert(result.find('\n', place) + 1, "set " + entry + "\n");
    return result;
  }



  /** Time and velocities after some steps, in rising order, since nodes are
   * numbered otherwise. */
  std::vector<double>
  velocities(const SceneParameters<2> &scene)
  {
    Simulation<2> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    for (unsigned int step = 0; step < 25; ++step)
      simulation.advance();
    std::vector<double> result = {simulation.state().time};
    for (const double speed : simulation.state().velocity)
      result.push_back(speed);
    std::sort(result.begin(), result.end());
    return result;
  }
} // namespace



TEST(MeshScene, RunsLikeTheSameBricks)
{
  const TemporaryFolder     folder;
  const std::vector<double> of_bricks =
    velocities(read_scene(folder, bricks + rest));
  const std::vector<double> of_mesh =
    velocities(read_scene(folder, layers + rest));
  ASSERT_EQ(of_mesh.size(), of_bricks.size());
  EXPECT_GT(of_bricks.back(), 1e-5);
  for (unsigned int k = 0; k < of_mesh.size(); ++k)
    EXPECT_NEAR(of_mesh[k], of_bricks[k], 1e-7 * of_bricks.back());
}



TEST(MeshScene, SidesAreGroups)
{
  const TemporaryFolder folder;
  const auto            scene = read_scene(folder, layers + rest);
  ASSERT_EQ(scene.boundary_conditions.size(), 2u);
  EXPECT_EQ(scene.boundary_conditions[1].side_name, "top");
  EXPECT_EQ(scene.topology.faults()[0].name, "main");
  const auto bodies = scene.coarse_bodies();
  EXPECT_EQ(bodies[1].side_names.at(scene.boundary_conditions[1].side), "top");
  EXPECT_EQ(bodies[0].refinement_passes, 2u);
  double highest = 0.;
  for (const Point<2> &vertex : bodies[1].cells->get_vertices())
    highest = std::max(highest, vertex[1]);
  EXPECT_NEAR(highest, 2., 1e-12);
}



TEST(MeshScene, WrittenParametersCanBeReadAnywhere)
{
  const TemporaryFolder folder, elsewhere;
  const auto            scene = read_scene(folder, layers + rest);
  std::ostringstream    text;
  write_parameters(scene, text);
  const auto again =
    SceneReader(elsewhere.write("again.prm", text.str())).read<2>();
  EXPECT_EQ(again.mesh_entries.files, folder.file("layers.msh"));
  EXPECT_EQ(again.coarse_bodies()[0].cells->n_active_cells(), 20u);
  std::ostringstream same;
  write_parameters(again, same);
  EXPECT_EQ(same.str(), text.str());
}



// Only the right half of the fault is refined, in bricks as well.
TEST(MeshScene, RefinesWhereItIsSaid)
{
  const TemporaryFolder folder;
  for (const std::string &bodies : {bricks, layers})
    {
      const auto scene =
        read_scene(folder,
                   with(bodies + rest, "lower", "Refine where = x - 1"));
      const MeshHierarchy<2> meshes(scene.coarse_bodies(),
                                    scene.topology,
                                    MPI_COMM_WORLD);
      unsigned int           n_long_left = 0, n_short_right = 0;
      const auto             lower = meshes.finest().surface(0, 0);
      for (unsigned int f = 0; f < lower.faces.size(); ++f)
        {
          const double x = std::min(lower.points[lower.faces[f][0]][0],
                                    lower.points[lower.faces[f][1]][0]);
          n_long_left += x < 0.5 && lower.face_size(f) > 0.4;
          n_short_right += x > 1.2 && lower.face_size(f) < 0.2;
        }
      EXPECT_EQ(n_long_left, 6u);
      EXPECT_EQ(n_short_right, 10u);
      EXPECT_EQ(meshes.finest().surface(0, 1).faces.size(), 40u);
    }
  expect_one_sentence_with(message_of([&]() {
                             read_scene(folder,
                                        with(layers + rest,
                                             "lower",
                                             "Refine where = y + depth"))
                               .coarse_bodies();
                           }),
                           {"Bodies/lower/Refine where", "depth"});
}



TEST(MeshScene, BetweenIsTakenApart)
{
  const auto bodies = parse_between("footwall,  hanging_wall");
  ASSERT_EQ(bodies[0].size(), 1u);
  EXPECT_EQ(bodies[0][0].body, "footwall");
  EXPECT_EQ(bodies[0][0].group, "");
  EXPECT_EQ(bodies[1][0].body, "hanging_wall");
  const auto sides = parse_between("lower top, left bottom + right  bottom");
  ASSERT_EQ(sides[1].size(), 2u);
  EXPECT_EQ(sides[0][0].group, "top");
  EXPECT_EQ(sides[1][1].body, "right");
  EXPECT_EQ(sides[1][1].group, "bottom");
  EXPECT_TRUE(parse_between("")[0].empty());
  for (const std::string wrong :
       {"lower", "a, b, c", "a, ", ", a", "a b c, d", "a +, b"})
    expect_one_sentence_with(message_of([&]() { parse_between(wrong); }),
                             {"'" + wrong + "'", "two bodies"});
}



TEST(MeshScene, MistakesAreAnsweredWithOneSentence)
{
  const std::string scene = layers + rest;
  EXPECT_EQ(message_of_scene(scene), "no error");
  std::string changed = scene;
  changed.replace(changed.find("upper top"), 9, "upper end");
  expect_one_sentence_with(message_of_scene(changed),
                           {"'upper end'", "is no side", "top, ends"});
  changed = scene;
  changed.replace(changed.find("layers.msh"), 10, "others.msh");
  expect_one_sentence_with(message_of_scene(changed), {"others.msh", "read"});
  changed = scene;
  changed.replace(changed.find("Names = lower, upper"), 20, "Names = lower");
  expect_one_sentence_with(message_of_scene(changed),
                           {"'upper' is not in 'Bodies/Names'"});
  expect_one_sentence_with(message_of_scene(
                             with(scene, "lower", "Thickness = 2")),
                           {"Bodies/lower/Thickness", "no effect"});
  expect_one_sentence_with(message_of_scene(
                             with(bricks + rest, "Bodies", "Length unit = 2")),
                           {"Bodies/Length unit", "bricks in a stack"});
  expect_one_sentence_with(
    message_of_scene(with(scene + "subsection Faults\n subsection main\n"
                                  "end\nend\n",
                          "main",
                          "Between = lower")),
    {"Faults/main/Between", "'lower'", "two bodies"});
  expect_one_sentence_with(
    message_of_scene(with(scene + "subsection Faults\n subsection main\n"
                                  "end\nend\n",
                          "main",
                          "Mesh group = crack")),
    {"'main'", "'crack'"});
  expect_one_sentence_with(
    message_of_scene(with(scene + "subsection Faults\n subsection main\n"
                                  "end\nend\n",
                          "main",
                          "Normal stress = lithostatic")),
    {"Faults/main/Normal stress", "bricks in a stack"});
}
