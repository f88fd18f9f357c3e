// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/fault_cutting.h>
#include <stickslip/mechanics/elastic_assembly.h>

#include <cmath>
#include <map>

#include "error_message.h"
#include "mesh_volume.h"
#include "project_directories.h"
#include "serial_matrices.h"
#include "simplex_bodies.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The quality of a tetrahedron: 12 (3 V)^(2/3) over the sum of the squares
   * of its edges (Liu and Joe 1994), one for a regular one. */
  double
  quality(const Triangulation<3>::active_cell_iterator &cell)
  {
    double squares = 0.;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int b = 0; b < a; ++b)
        squares += cell->vertex(a).distance_square(cell->vertex(b));
    return 12. * std::pow(3. * cell->measure(), 2. / 3.) / squares;
  }



  double
  least_quality(const Triangulation<3> &mesh)
  {
    double least = 1.;
    for (const auto &cell : mesh.active_cell_iterators())
      least = std::min(least, quality(cell));
    return least;
  }



  /** Areas of the sides of a body: lengths, or areas of triangles. */
  template <int dim>
  std::map<types::boundary_id, double>
  areas(const Triangulation<dim> &mesh)
  {
    std::map<types::boundary_id, double> result;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto side = face->vertex(1) - face->vertex(0);
            if constexpr (dim == 2)
              result[face->boundary_id()] += side.norm();
            else
              result[face->boundary_id()] +=
                0.5 * cross_product_3d(side, face->vertex(2) - face->vertex(0))
                        .norm();
          }
    return result;
  }



  /** A cube with a fault in it, of tetrahedra. */
  CoarseBody<3>
  cut_block()
  {
    const CutMesh<3> cut =
      cut_at_faults(GroupedCells<3>({GmshFile(STICKSLIP_SOURCE_DIR
                                              "/tests/meshes/patch.msh")},
                                    {"block"}),
                    {{"main", "patch", {}}});
    CoarseBody<3> body;
    body.cells      = cut.bodies[0].triangulation();
    body.side_names = cut.bodies[0].side_names;
    return body;
  }



  /** Coarse functions are the same on the finer level: the energy of any
   * displacement is. */
  template <int dim>
  void
  expect_functions_kept(const MeshHierarchy<dim> &meshes)
  {
    const std::vector<MaterialFields> materials(meshes.finest().bodies.size(),
                                                Material());
    std::mt19937                      random(3);
    const auto energy = [&](const unsigned int l, const NodalVector &u) {
      NodalVector force = u;
      assemble_elastic_matrices(meshes.level(l), materials, false)
        .stiffness.vmult(force, u);
      return force * u;
    };
    for (unsigned int l = 1; l < meshes.n_levels(); ++l)
      {
        const NodalVector coarse = random_values(meshes.level(l - 1), random);
        NodalVector       fine   = meshes.level(l).nodes.make_vector();
        prolongation_matrix(meshes, l).prolongate(fine, coarse, dim);
        EXPECT_GT(energy(l, fine), 0.);
        EXPECT_NEAR(energy(l, fine) / energy(l - 1, coarse), 1., 1e-12)
          << "on level " << l;
      }
  }



  template <int dim>
  void
  expect_same_volume_and_sides(const MeshHierarchy<dim> &meshes)
  {
    for (unsigned int b = 0; b < meshes.finest().bodies.size(); ++b)
      {
        const auto &coarse = meshes.level(0).bodies[b]->triangulation();
        for (unsigned int l = 1; l < meshes.n_levels(); ++l)
          {
            const auto &fine = meshes.level(l).bodies[b]->triangulation();
            EXPECT_NEAR(volume(fine) / volume(coarse), 1., 1e-12);
            const auto expected = areas(coarse), found = areas(fine);
            ASSERT_EQ(found.size(), expected.size());
            for (const auto &side : expected)
              EXPECT_NEAR(found.at(side.first) / side.second, 1., 1e-12);
          }
      }
  }
} // namespace



TEST(SimplexMesh, GradedTriangles)
{
  const auto bodies = simplex_bricks(
    stack<2>({make_body<2>(1., {{5, 2}}, 3), make_body<2>(0.7, {{7, 2}}, 2)}));
  const MeshHierarchy<2> meshes(bodies, numbered_stack<2>(2), MPI_COMM_WORLD);
  ASSERT_EQ(meshes.n_levels(), 4u);
  unsigned int n_hanging = 0;
  for (const auto &body : meshes.finest().bodies)
    n_hanging += body->bound_nodes().n_constraints();
  EXPECT_GT(n_hanging, 10u);
  // Eight triangles a square, five squares at the fault, halved three times.
  EXPECT_EQ(meshes.finest().surface(0, 0).faces.size(), 80u);
  for (unsigned int l = 1; l < 4; ++l)
    EXPECT_GT(meshes.level(l).n_nodes(), meshes.level(l - 1).n_nodes());
  expect_same_volume_and_sides(meshes);
  expect_functions_kept(meshes);
}



TEST(SimplexMesh, RefinedTetrahedra)
{
  CoarseBody<3> body       = cut_block();
  body.uniform_refinements = 2;
  const MeshHierarchy<3> meshes({body},
                                FaultTopology({"block"}, {}),
                                MPI_COMM_WORLD);
  ASSERT_EQ(meshes.n_levels(), 3u);
  for (unsigned int l = 1; l < 3; ++l)
    EXPECT_EQ(
      meshes.level(l).bodies[0]->triangulation().n_active_cells(),
      8 * meshes.level(l - 1).bodies[0]->triangulation().n_active_cells());
  expect_same_volume_and_sides(meshes);
  expect_functions_kept(meshes);
}



// With a fixed diagonal, the quality falls with each refinement.
TEST(SimplexMesh, RefinementKeepsTheShapeOfTetrahedra)
{
  std::vector<double>                     qualities;
  std::shared_ptr<const Triangulation<3>> mesh  = cut_block().cells;
  const double                            given = least_quality(*mesh);
  for (unsigned int r = 0; r < 3; ++r)
    {
      mesh = RedRefinement(*mesh).mesh;
      qualities.push_back(least_quality(*mesh));
    }
  EXPECT_GT(given, 0.3);
  for (const double kept : qualities)
    EXPECT_NEAR(kept, given, 1e-10);
}



// Vertices of a fault stay doubled, its edge is shared.
TEST(SimplexMesh, RefinedFaultStaysOpen)
{
  CoarseBody<3> body       = cut_block();
  body.uniform_refinements = 1;
  const BodyMesh<3> mesh(body, {});
  const auto        side_called = [&](const std::string &name) {
    for (const auto &side : body.side_names)
      if (side.second == name)
        return side.first;
    return numbers::invalid_boundary_id;
  };
  const auto first  = mesh.surface(side_called("main first"));
  const auto second = mesh.surface(side_called("main second"));
  EXPECT_EQ(first.points.size(), second.points.size());
  EXPECT_EQ(first.faces.size(), second.faces.size());
  std::set<types::global_dof_index> of_first(first.nodes.begin(),
                                             first.nodes.end());
  unsigned int                      n_shared = 0;
  for (unsigned int k = 0; k < second.nodes.size(); ++k)
    if (of_first.count(second.nodes[k]) > 0)
      {
        ++n_shared;
        const Point<3> &x = second.points[k];
        EXPECT_GT(std::max(std::abs(x[0]), std::abs(x[1])), 0.3);
      }
  EXPECT_GT(n_shared, 0u);
  EXPECT_LT(n_shared, first.nodes.size());
  for (const auto &face : first.faces)
    {
      EXPECT_LT(face[2], first.nodes.size());
      EXPECT_EQ(face[3], numbers::invalid_unsigned_int);
    }
}



TEST(SimplexMesh, TetrahedraAreNotRefinedAtFaultsOnly)
{
  CoarseBody<3> body     = cut_block();
  body.refinement_passes = 1;
  expect_one_sentence_with(message_of([&]() { BodyMesh<3>(body, {0}); }),
                           {"Tetrahedra", "mesh file"});
}
