// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>
#include <stickslip/geometry/fault_cutting.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesh_text.h"
#include "mesh_volume.h"
#include "project_directories.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  GroupedCells<dim>
  read(const std::string &file, const std::vector<std::string> &bodies)
  {
    return GroupedCells<dim>(
      {GmshFile(STICKSLIP_SOURCE_DIR "/tests/meshes/" + file)}, bodies);
  }



  /** Areas of the sides of a body, outwards. */
  template <int dim>
  std::map<types::boundary_id, Tensor<1, dim>>
  side_areas(const Triangulation<dim> &mesh)
  {
    std::map<types::boundary_id, Tensor<1, dim>> result;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            Tensor<1, dim> area;
            if constexpr (dim == 2)
              area = cross_product_2d(face->vertex(1) - face->vertex(0));
            else if (face->n_vertices() == 3)
              area = 0.5 * cross_product_3d(face->vertex(1) - face->vertex(0),
                                            face->vertex(2) - face->vertex(0));
            else
              area = 0.5 * cross_product_3d(face->vertex(3) - face->vertex(0),
                                            face->vertex(2) - face->vertex(1));
            const bool is_outward =
              area * (face->center() - cell->center()) > 0.;
            result[face->boundary_id()] += is_outward ? area : -area;
          }
    return result;
  }



  /** Properties of all meshes that have been cut: bodies have the volumes, all
   * of their boundary is named, and sides of faults are opposite. Returns the
   * normal of each fault times its area. */
  template <int dim>
  std::vector<Tensor<1, dim>>
  check_cut(const CutMesh<dim> &cut, const std::vector<double> &volumes)
  {
    EXPECT_EQ(cut.bodies.size(), volumes.size());
    std::vector<std::map<types::boundary_id, Tensor<1, dim>>> areas;
    for (unsigned int b = 0; b < volumes.size(); ++b)
      {
        const BodyCells<dim> &body = cut.bodies[b];
        const auto            mesh = body.triangulation();
        EXPECT_NEAR(volume(*mesh), volumes[b], 1e-12 * volumes[b]);
        EXPECT_EQ(mesh->n_vertices(), body.vertices.size());
        // The ones given are all there are, with their indicators.
        std::map<types::boundary_id, unsigned int> given, found;
        for (const auto &line : body.boundary.boundary_lines)
          ++given[line.boundary_id];
        for (const auto &quad : body.boundary.boundary_quads)
          ++given[quad.boundary_id];
        for (const auto &cell : mesh->active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              ++found[face->boundary_id()];
        EXPECT_EQ(found, given);
        for (const auto &side : given)
          EXPECT_EQ(body.side_names.count(side.first), 1u);
        EXPECT_EQ(body.side_names.size(), given.size());
        areas.push_back(side_areas(*mesh));
      }

    std::vector<Tensor<1, dim>> normals;
    for (const Fault &fault : cut.topology.faults())
      {
        std::array<Tensor<1, dim>, 2> outward;
        for (const unsigned int side : {0, 1})
          for (const BodySide &part : fault.sides[side])
            outward[side] += areas[part.body][part.side];
        EXPECT_LT((outward[0] + outward[1]).norm(), 1e-12) << fault.name;
        normals.push_back(outward[0]);
      }
    return normals;
  }



  template <int dim>
  void
  expect_near(const Tensor<1, dim> &a, const Tensor<1, dim> &b)
  {
    EXPECT_LT((a - b).norm(), 1e-12) << a << " is not " << b;
  }



  /** A mesh of quadrilaterals, repeated along the third axis. Both ends are in
   * the group "ends". */
  GroupedCells<3>
  extruded(const GroupedCells<2> &flat,
           const unsigned int     n_layers,
           const double           height)
  {
    GroupedCells<3>    result;
    const unsigned int n = flat.points.size();
    result.body_names    = flat.body_names;
    result.group_names   = flat.group_names;
    result.group_names.push_back("ends");
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      for (const Point<2> &point : flat.points)
        result.points.emplace_back(point[0],
                                   point[1],
                                   layer * height / n_layers);
    for (unsigned int layer = 0; layer < n_layers; ++layer)
      {
        for (const auto &cell : flat.cells)
          {
            result.cells.push_back({{}, 8, cell.body});
            for (unsigned int v = 0; v < 8; ++v)
              result.cells.back().vertices[v] =
                cell.vertices[v % 4] + (layer + v / 4) * n;
          }
        for (const auto &face : flat.faces)
          result.faces.push_back({{{face.vertices[0] + layer * n,
                                    face.vertices[1] + layer * n,
                                    face.vertices[0] + (layer + 1) * n,
                                    face.vertices[1] + (layer + 1) * n}},
                                  4,
                                  face.group});
      }
    for (const unsigned int layer : {0u, n_layers})
      for (const auto &cell : flat.cells)
        {
          auto vertices = cell.vertices;
          for (unsigned int &vertex : vertices)
            vertex += layer * n;
          result.faces.push_back(
            {vertices,
             4,
             static_cast<unsigned int>(result.group_names.size() - 1)});
        }
    return result;
  }



  /** Names of the bodies at a side of a fault. */
  std::vector<std::string>
  bodies_at(const FaultTopology &topology,
            const unsigned int   fault,
            const unsigned int   side)
  {
    std::vector<std::string> result;
    for (const BodySide &part : topology.faults()[fault].sides[side])
      result.push_back(topology.body_names()[part.body]);
    return result;
  }

  using Names = std::vector<std::string>;
} // namespace



TEST(FaultCutting, TwoColumns)
{
  const auto cut =
    cut_at_faults(GroupedCells<2>({two_columns().file()}, {"west", "east"}),
                  {{"main", "fault", {}}});
  const auto normals = check_cut(cut, {2., 2.});
  expect_near(normals[0], Tensor<1, 2>({2., 0.}));
  EXPECT_EQ(cut.bodies[0].vertices.size(), 6u);
  EXPECT_EQ(cut.bodies[1].vertices.size(), 6u);
  EXPECT_TRUE(cut.tips.empty());
  EXPECT_TRUE(cut.junctions.empty());
  const std::map<types::boundary_id, std::string> west = {{0, "bottom"},
                                                          {1, "top"},
                                                          {2, "left"},
                                                          {3, "main first"}};
  EXPECT_EQ(cut.bodies[0].side_names, west);
  EXPECT_EQ(cut.topology.faults()[0].name, "main");
}



TEST(FaultCutting, OrderOfBodiesOrBetweenGivesTheNormal)
{
  const GroupedCells<2> mesh({two_columns().file()}, {"east", "west"});
  const auto            normal =
    [&](const std::array<std::vector<MeshFault::Side>, 2> &between) {
      return check_cut(cut_at_faults(mesh, {{"main", "fault", between}}),
                       {2., 2.})[0];
    };
  expect_near(normal({}), Tensor<1, 2>({-2., 0.}));
  expect_near(normal({{{{"west", ""}}, {{"east", ""}}}}),
              Tensor<1, 2>({2., 0.}));
  expect_near(normal({{{{"east", ""}}, {{"west", ""}}}}),
              Tensor<1, 2>({-2., 0.}));
}



// Bodies with nodes of their own, whose sides are named, in one and two files.
TEST(FaultCutting, SidesOfSeparateBodies)
{
  const std::vector<MeshFault> faults = {
    {"main", "", {{{{"west", "fault"}}, {{"east", "east_side"}}}}}};
  const auto cut = cut_at_faults(
    GroupedCells<2>({two_separate_columns().file()}, {"west", "east"}), faults);
  expect_near(check_cut(cut, {2., 2.})[0], Tensor<1, 2>({2., 0.}));

  MeshText   west = two_separate_columns(), east = west;
  const auto keep = [](MeshText                        &mesh,
                       const std::vector<unsigned int> &elements,
                       const std::vector<unsigned int> &groups) {
    const MeshText all = mesh;
    mesh.elements.clear();
    mesh.groups.clear();
    for (const unsigned int e : elements)
      mesh.elements.push_back(all.elements[e]);
    for (const unsigned int g : groups)
      mesh.groups.push_back(all.groups[g]);
  };
  keep(west, {0, 1, 4, 5, 6, 8, 10, 11}, {0, 2, 3, 4, 5});
  keep(east, {2, 3, 7, 9, 12, 13, 14, 15}, {1, 3, 4, 6, 7});
  // Nonmatching: the body's own nodes on the fault are elsewhere.
  east.nodes[10][1] = 0.7;
  const auto two =
    cut_at_faults(GroupedCells<2>({west.file(), east.file()}, {"west", "east"}),
                  faults);
  expect_near(check_cut(two, {2., 2.})[0], Tensor<1, 2>({2., 0.}));
  EXPECT_EQ(two.bodies[1].vertices.size(), 6u);

  // Matching, both sides being the group of the fault.
  east.nodes[10][1]   = 1.;
  east.groups[4].name = "fault";
  const auto welded =
    cut_at_faults(GroupedCells<2>({west.file(), east.file()}, {"west", "east"}),
                  {{"main", "fault", {}}});
  expect_near(check_cut(welded, {2., 2.})[0], Tensor<1, 2>({2., 0.}));
}



TEST(FaultCutting, Slit)
{
  const auto mesh = read<2>("slit.msh", {"block"});
  const auto cut  = cut_at_faults(mesh, {{"main", "slit", {}}});
  // One body on both sides: the normal points upwards.
  expect_near(check_cut(cut, {4.})[0], Tensor<1, 2>({0., 1.}));
  ASSERT_EQ(cut.tips.size(), 2u);
  for (const auto &tip : cut.tips)
    {
      EXPECT_EQ(tip.fault, 0u);
      EXPECT_NEAR(std::abs(tip.position[0]), 0.5, 1e-14);
      EXPECT_NEAR(tip.position[1], 0., 1e-14);
    }
  EXPECT_TRUE(cut.junctions.empty());
  EXPECT_EQ(cut.n_closed_faces, 0u);
  // All vertices but the tips are doubled.
  const unsigned int n_faces =
    std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto &face) {
      return mesh.group_names[face.group] == "slit";
    });
  std::set<unsigned int> used;
  for (const auto &cell : mesh.cells)
    used.insert(cell.vertices.begin(), cell.vertices.begin() + 3);
  EXPECT_EQ(cut.bodies[0].vertices.size(), used.size() + n_faces - 1);
}



TEST(FaultCutting, NodesThatTheFileHasDoubledAlready)
{
  const auto whole =
    cut_at_faults(read<2>("slit.msh", {"block"}), {{"main", "slit", {}}});
  const auto cracked = cut_at_faults(read<2>("slit_cracked.msh", {"block"}),
                                     {{"main", "slit", {}}});
  expect_near(check_cut(cracked, {4.})[0], Tensor<1, 2>({0., 1.}));
  EXPECT_EQ(cracked.tips.size(), 2u);
  EXPECT_EQ(cracked.bodies[0].vertices.size(), whole.bodies[0].vertices.size());
  EXPECT_EQ(cracked.bodies[0].cells.size(), whole.bodies[0].cells.size());
}



TEST(FaultCutting, FaultThatEndsInside)
{
  const auto cut = cut_at_faults(read<2>("edge_crack.msh", {"block"}),
                                 {{"main", "crack", {}}});
  expect_near(check_cut(cut, {4.})[0],
              Tensor<1, 2>({std::tan(numbers::PI / 6.), 1.}));
  ASSERT_EQ(cut.tips.size(), 1u);
  EXPECT_LT(cut.tips[0].position.norm(), 1e-14);
  EXPECT_TRUE(cut.junctions.empty());
}



TEST(FaultCutting, FaultThatEndsAtAnother)
{
  const auto cut =
    cut_at_faults(read<2>("t_junction.msh", {"base", "west", "east"}),
                  {{"main", "main", {}}, {"branch", "branch", {}}});
  const auto normals = check_cut(cut, {4.2, 2.125, 1.675});
  expect_near(normals[0], Tensor<1, 2>({0., 4.}));
  expect_near(normals[1], Tensor<1, 2>({0.9, -0.5}));
  EXPECT_TRUE(cut.tips.empty());
  ASSERT_EQ(cut.junctions.size(), 1u);
  EXPECT_EQ(cut.junctions[0].n_parts, 3u);
  EXPECT_EQ(cut.junctions[0].faults, (std::set<unsigned int>{0, 1}));
  EXPECT_LT(cut.junctions[0].position.distance(Point<2>(0., 0.1)), 1e-14);
  EXPECT_EQ(bodies_at(cut.topology, 0, 0), Names({"base"}));
  EXPECT_EQ(bodies_at(cut.topology, 0, 1), Names({"west", "east"}));
  EXPECT_EQ(bodies_at(cut.topology, 1, 0), Names({"west"}));
  EXPECT_EQ(bodies_at(cut.topology, 1, 1), Names({"east"}));
}



TEST(FaultCutting, FaultThatEndsAtAnotherInSpace)
{
  const auto cut = cut_at_faults(
    extruded(read<2>("t_junction.msh", {"base", "west", "east"}), 3, 0.5),
    {{"main", "main", {}}, {"branch", "branch", {}}});
  const auto normals = check_cut(cut, {2.1, 1.0625, 0.8375});
  expect_near(normals[0], Tensor<1, 3>({0., 2., 0.}));
  expect_near(normals[1], Tensor<1, 3>({0.45, -0.25, 0.}));
  EXPECT_TRUE(cut.tips.empty());
  ASSERT_EQ(cut.junctions.size(), 4u);
  for (const auto &junction : cut.junctions)
    EXPECT_EQ(junction.n_parts, 3u);
}



// One body on all sides: the branch ends inside, and so does the other fault
// where only half of it is one.
TEST(FaultCutting, FaultsWithinOneBodyInSpace)
{
  GroupedCells<3> mesh =
    extruded(read<2>("t_junction.msh", {"base", "west", "east"}), 2, 1.);
  mesh.body_names = {"block"};
  for (auto &cell : mesh.cells)
    cell.body = 0;
  // The fault is where its faces are left of the junction.
  const unsigned int main =
    std::find(mesh.group_names.begin(), mesh.group_names.end(), "main") -
    mesh.group_names.begin();
  mesh.faces.erase(std::remove_if(mesh.faces.begin(),
                                  mesh.faces.end(),
                                  [&](const auto &face) {
                                    return face.group == main &&
                                           mesh.centre(face)[0] > 0.;
                                  }),
                   mesh.faces.end());
  const auto cut =
    cut_at_faults(mesh, {{"main", "main", {}}, {"branch", "branch", {}}});
  const auto normals = check_cut(cut, {8.});
  expect_near(normals[0], Tensor<1, 3>({-0.1, 2., 0.}));
  expect_near(normals[1], Tensor<1, 3>({-0.9, 0.5, 0.}));
  // Both faults meet at an edge, around which there are two parts.
  EXPECT_TRUE(cut.tips.empty());
  EXPECT_TRUE(cut.junctions.empty());

  // Without the branch the other one ends there, at three vertices.
  mesh.faces.erase(std::remove_if(mesh.faces.begin(),
                                  mesh.faces.end(),
                                  [&](const auto &face) {
                                    return mesh.group_names[face.group] ==
                                           "branch";
                                  }),
                   mesh.faces.end());
  const auto alone = cut_at_faults(mesh, {{"main", "main", {}}});
  check_cut(alone, {8.});
  EXPECT_EQ(alone.tips.size(), 3u);
  EXPECT_TRUE(alone.junctions.empty());
}



TEST(FaultCutting, FaultsThatCross)
{
  const auto cut =
    cut_at_faults(read<2>("cross.msh", {"south", "north"}),
                  {{"level", "level", {}}, {"upright", "upright", {}}});
  const auto normals = check_cut(cut, {2., 2.});
  expect_near(normals[0], Tensor<1, 2>({0., 2.}));
  expect_near(normals[1], Tensor<1, 2>({2., 0.}));
  EXPECT_TRUE(cut.tips.empty());
  ASSERT_EQ(cut.junctions.size(), 1u);
  EXPECT_EQ(cut.junctions[0].n_parts, 4u);
  EXPECT_LT(cut.junctions[0].position.norm(), 1e-14);
  for (const unsigned int side : {0, 1})
    EXPECT_EQ(bodies_at(cut.topology, 1, side), Names({"south", "north"}));
}



TEST(FaultCutting, DiscInARing)
{
  const double disc    = 8. * std::sin(numbers::PI / 8.);
  const auto   cut     = cut_at_faults(read<2>("ring.msh", {"disc", "ring"}),
                                 {{"main", "fault", {}}});
  const auto   normals = check_cut(cut, {disc, 3. * disc});
  expect_near(normals[0], Tensor<1, 2>());
  EXPECT_TRUE(cut.tips.empty());
  EXPECT_TRUE(cut.junctions.empty());
  EXPECT_EQ(bodies_at(cut.topology, 0, 0), Names({"disc"}));
}



TEST(FaultCutting, DippingFaultInSpace)
{
  const auto cut =
    cut_at_faults(read<3>("dipping.msh", {"footwall", "hanging_wall"}),
                  {{"main", "fault", {}}});
  const auto normals = check_cut(cut, {4., 4.});
  expect_near(normals[0],
              Tensor<1, 3>({2., 0., 2. / std::tan(numbers::PI / 3.)}));
  EXPECT_TRUE(cut.tips.empty());
  EXPECT_TRUE(cut.junctions.empty());
}



TEST(FaultCutting, PatchInSpace)
{
  const auto mesh    = read<3>("patch.msh", {"block"});
  const auto cut     = cut_at_faults(mesh, {{"main", "patch", {}}});
  const auto normals = check_cut(cut, {8.});

  // The edge of the patch, and faces with all vertices there, from the file.
  const auto is_at_edge = [&](const unsigned int v) {
    return std::abs(std::max(std::abs(mesh.points[v][0]),
                             std::abs(mesh.points[v][1])) -
                    0.5) < 1e-12;
  };
  std::set<unsigned int> edge, all;
  unsigned int           n_faces = 0, n_closed = 0;
  double                 closed_area = 0.;
  for (const auto &face : mesh.faces)
    if (mesh.group_names[face.group] == "patch")
      {
        bool is_closed = true;
        for (unsigned int v = 0; v < 3; ++v)
          {
            all.insert(face.vertices[v]);
            if (is_at_edge(face.vertices[v]))
              edge.insert(face.vertices[v]);
            else
              is_closed = false;
          }
        ++n_faces;
        n_closed += is_closed;
        if (is_closed)
          closed_area += 0.5 * cross_product_3d(mesh.points[face.vertices[1]] -
                                                  mesh.points[face.vertices[0]],
                                                mesh.points[face.vertices[2]] -
                                                  mesh.points[face.vertices[0]])
                                 .norm();
      }
  EXPECT_GT(n_faces, 20u);
  EXPECT_GT(all.size(), edge.size());
  EXPECT_EQ(cut.n_closed_faces, n_closed);
  EXPECT_EQ(cut.tips.size(), edge.size());
  EXPECT_TRUE(cut.junctions.empty());
  expect_near(normals[0], Tensor<1, 3>({0., 0., 1. - closed_area}));
}
