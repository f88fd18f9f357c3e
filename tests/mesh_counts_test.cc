// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <map>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  const double root2 = std::sqrt(2.);



  template <int dim>
  unsigned int
  n_vertices(const MeshLevel<dim> &level)
  {
    unsigned int n = 0;
    for (const auto &body : level.bodies)
      n += body->triangulation().n_used_vertices();
    return n;
  }



  template <int dim>
  std::pair<double, double>
  cell_diameters(const MeshLevel<dim> &level)
  {
    std::pair<double, double> result = {1e30, 0.};
    for (const auto &body : level.bodies)
      {
        const MeshFigures figures = body->figures();
        result.first              = std::min(result.first, figures.smallest);
        result.second             = std::max(result.second, figures.largest);
      }
    return result;
  }



  /** Number of cells in each row, from the height @p from away. */
  std::vector<unsigned int>
  cells_by_row(const BodyMesh<2> &body, const double from)
  {
    std::map<int, unsigned int> rows;
    for (const auto &cell : body.triangulation().active_cell_iterators())
      ++rows[std::lround(1e6 * std::abs(cell->center()[1] - from))];
    std::vector<unsigned int> result;
    for (const auto &row : rows)
      result.push_back(row.second);
    return result;
  }



  /** Each level is one refinement coarser, until nothing is left to coarsen,
   * but for bodies that wait for deeper ones. */
  template <int dim>
  void
  expect_levels_down_to_the_coarse_cells(
    const std::vector<BodyGeometry<dim>> &bodies)
  {
    const MeshHierarchy<dim> meshes(bodies, MPI_COMM_WORLD);
    const auto               n_refinements = [&](const unsigned int b) {
      return bodies[b].uniform_refinements + bodies[b].refinement_passes;
    };
    unsigned int most = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const BodyMesh<dim> &coarsest = *meshes.level(0).bodies[b];
        EXPECT_FALSE(coarsest.can_be_coarsened());
        unsigned int n_coarse_cells = 1;
        for (const unsigned int n : bodies[b].coarse_cells)
          n_coarse_cells *= n;
        EXPECT_EQ(coarsest.triangulation().n_active_cells(), n_coarse_cells);

        EXPECT_EQ(meshes.finest().bodies[b]->triangulation().n_levels(),
                  1 + n_refinements(b));
        most = std::max(most, n_refinements(b));
        for (unsigned int l = 1; l < meshes.n_levels(); ++l)
          {
            const auto n_levels_of = [&](const unsigned int body) {
              return meshes.level(l).bodies[body]->triangulation().n_levels();
            };
            const unsigned int n        = n_levels_of(b);
            bool               may_wait = n == 1;
            for (unsigned int other = 0; other < bodies.size(); ++other)
              may_wait = may_wait || n_levels_of(other) > n;
            const unsigned int coarser =
              meshes.level(l - 1).bodies[b]->triangulation().n_levels();
            EXPECT_TRUE(coarser + 1 == n || (coarser == n && may_wait));
          }
      }
    EXPECT_EQ(meshes.n_levels(), 1 + most);
  }



  /** Halving all cells first gives the mesh of so many more coarse cells. */
  template <int dim>
  void
  expect_mesh_of_more_coarse_cells(
    const std::vector<BodyGeometry<dim>> &uniformly_refined)
  {
    auto of_more_cells = uniformly_refined;
    for (BodyGeometry<dim> &body : of_more_cells)
      {
        for (unsigned int &n : body.coarse_cells)
          n <<= body.uniform_refinements;
        body.uniform_refinements = 0;
      }
    const MeshHierarchy<dim> ours(uniformly_refined, MPI_COMM_WORLD);
    const MeshHierarchy<dim> others(of_more_cells, MPI_COMM_WORLD);
    for (unsigned int b = 0; b < of_more_cells.size(); ++b)
      {
        const BodyMesh<dim> &one   = *ours.finest().bodies[b];
        const BodyMesh<dim> &other = *others.finest().bodies[b];
        EXPECT_EQ(one.triangulation().n_active_cells(),
                  other.triangulation().n_active_cells());
        EXPECT_EQ(one.dof_handler().n_dofs(), other.dof_handler().n_dofs());
        EXPECT_EQ(one.bound_nodes().n_constraints(),
                  other.bound_nodes().n_constraints());
        EXPECT_NEAR(one.figures().smallest, other.figures().smallest, 1e-12);
        EXPECT_NEAR(one.figures().largest, other.figures().largest, 1e-12);
      }
  }



  /** The scenes with all cells halved, with and without passes after that. */
  template <int dim>
  std::vector<std::vector<BodyGeometry<dim>>>
  uniformly_refined_scenes()
  {
    std::vector<std::vector<BodyGeometry<dim>>> result;
    for (const auto &bodies : scenes<dim>())
      for (const unsigned int times : {1, 2})
        {
          result.push_back(halved(bodies, times));
          // One body refined otherwise than the rest.
          result.back().front().uniform_refinements = times - 1;
          result.push_back(halved(bodies, times));
          for (BodyGeometry<dim> &body : result.back())
            body.refinement_passes = 0;
        }
    return result;
  }
} // namespace



TEST(MeshCounts, SpringSliderIsThePublishedMesh)
{
  const MeshHierarchy<2> meshes(spring_slider_bodies(), MPI_COMM_WORLD);
  const MeshLevel<2>    &finest = meshes.finest();
  EXPECT_EQ(n_vertices(finest), 1274u);
  EXPECT_EQ(finest.nodes.n_global(), 1274u);
  EXPECT_EQ(meshes.n_levels(), 5u);

  const std::vector<unsigned int> rows = {160, 160, 80, 40, 20, 10};
  for (const auto &body : finest.bodies)
    {
      EXPECT_EQ(body->dof_handler().n_dofs(), 637u);
      EXPECT_EQ(cells_by_row(*body, 1.), rows);
    }
  EXPECT_EQ(finest.bodies[0]->surface(BodyMesh<2>::upper_side).nodes.size(),
            161u);
  EXPECT_EQ(finest.bodies[1]->surface(BodyMesh<2>::lower_side).nodes.size(),
            161u);
  EXPECT_EQ(finest.bodies[1]->surface(BodyMesh<2>::lower_side).faces.size(),
            160u);

  // Published: 4.4 cm to 70.8 cm.
  const auto diameters = cell_diameters(finest);
  EXPECT_NEAR(diameters.first, 0.03125 * root2, 1e-12);
  EXPECT_NEAR(diameters.second, 0.5 * root2, 1e-12);
  EXPECT_NEAR(diameters.first, 0.044, 0.001);
  EXPECT_NEAR(diameters.second, 0.708, 0.001);
}



TEST(MeshCounts, LayeredBodiesAreThePublishedMesh)
{
  const MeshHierarchy<2> meshes(layered_bodies(), MPI_COMM_WORLD);
  const MeshLevel<2>    &finest = meshes.finest();
  EXPECT_EQ(n_vertices(finest), 4057u);
  EXPECT_EQ(meshes.n_levels(), 5u);
  const std::vector<unsigned int> published = {637, 839, 1105, 839, 637};
  for (unsigned int b = 0; b < 5; ++b)
    EXPECT_EQ(finest.bodies[b]->dof_handler().n_dofs(), published[b]);

  // Published: 3.2 cm to 70.8 cm.
  const auto diameters = cell_diameters(finest);
  EXPECT_NEAR(diameters.first, std::hypot(5. / 220, 0.09 / 4), 1e-12);
  EXPECT_NEAR(diameters.second, 0.5 * root2, 1e-12);
  EXPECT_NEAR(diameters.first, 0.032, 0.0005);
  EXPECT_NEAR(diameters.second, 0.708, 0.001);
}



TEST(MeshCounts, HierarchiesEndAtTheCoarseMesh)
{
  for (const auto &bodies : scenes<2>())
    expect_levels_down_to_the_coarse_cells<2>(bodies);
  for (const auto &bodies : scenes<3>())
    expect_levels_down_to_the_coarse_cells<3>(bodies);
}



TEST(MeshCounts, BodiesWithFewRefinementsWaitForTheirNeighbours)
{
  // Faces of 0.5 m at first, halved four times and once: the coarser body waits
  // until the finer one's are half of its own.
  const MeshHierarchy<2> meshes(stack<2>({make_body<2>(1., {{10, 2}}, 4),
                                          make_body<2>(1., {{10, 2}}, 1)}),
                                MPI_COMM_WORLD);
  ASSERT_EQ(meshes.n_levels(), 5u);
  for (unsigned int l = 0; l < 5; ++l)
    {
      EXPECT_EQ(meshes.level(l).bodies[0]->triangulation().n_levels(), l + 1);
      EXPECT_EQ(meshes.level(l).bodies[1]->triangulation().n_levels(),
                l <= 1 ? 1u : 2u);
    }
  // A layer of fine cells is coarsened before its neighbours, for a level more.
  const MeshHierarchy<2> layer(stack<2>({make_body<2>(1., {{10, 2}}, 4),
                                         make_body<2>(0.003, {{333, 1}}, 1)}),
                               MPI_COMM_WORLD);
  ASSERT_EQ(layer.n_levels(), 6u);
  for (unsigned int l = 0; l < 6; ++l)
    {
      EXPECT_EQ(layer.level(l).bodies[0]->triangulation().n_levels(),
                std::min(l + 1, 5u));
      EXPECT_EQ(layer.level(l).bodies[1]->triangulation().n_levels(),
                l == 5 ? 2u : 1u);
    }
  // A body that is twice as fine makes nobody wait.
  const MeshHierarchy<2> alike(stack<2>({make_body<2>(1., {{10, 2}}, 4),
                                         make_body<2>(1., {{10, 2}}, 3)}),
                               MPI_COMM_WORLD);
  EXPECT_EQ(alike.level(3).bodies[1]->triangulation().n_levels(), 3u);
}



TEST(MeshCounts, UniformRefinementsAreLevelsToo)
{
  for (const auto &bodies : uniformly_refined_scenes<2>())
    expect_levels_down_to_the_coarse_cells<2>(bodies);
  for (const auto &bodies : uniformly_refined_scenes<3>())
    expect_levels_down_to_the_coarse_cells<3>(bodies);
}



TEST(MeshCounts, UniformRefinementsComeBeforeThePasses)
{
  for (const auto &bodies : uniformly_refined_scenes<2>())
    expect_mesh_of_more_coarse_cells<2>(bodies);
  for (const auto &bodies : uniformly_refined_scenes<3>())
    expect_mesh_of_more_coarse_cells<3>(bodies);
}



TEST(MeshCounts, NodesOfTheBodiesFollowEachOther)
{
  const MeshHierarchy<2> meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    {
      const MeshLevel<2> &level = meshes.level(l);
      unsigned int        n     = 0;
      for_each_node(level,
                    [&](const unsigned int,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2> &,
                        const bool) { EXPECT_EQ(node, n++); });
      EXPECT_EQ(n, level.nodes.n_local());
    }
}



TEST(MeshCounts, SurfacesCoverTheWholeSideInThreeDimensions)
{
  const MeshHierarchy<3> meshes(nonmatching_blocks(), MPI_COMM_WORLD);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    for (unsigned int b = 0; b < 2; ++b)
      {
        const BodyMesh<3> &body = *meshes.level(l).bodies[b];
        const auto surface = body.surface(b == 0 ? BodyMesh<3>::upper_side :
                                                   BodyMesh<3>::lower_side);
        // Equal squares: no hanging nodes on the fault.
        const double n = std::sqrt(surface.faces.size());
        EXPECT_EQ(surface.nodes.size(), std::lround((n + 1) * (n + 1)));
        for (const auto dof : surface.nodes)
          EXPECT_FALSE(body.bound_nodes().is_constrained(dof));
        for (const auto &point : surface.points)
          EXPECT_EQ(point[2], 3.);
        double area = 0.;
        for (const auto &face : surface.faces)
          {
            const Tensor<1, 3> x =
              surface.points[face[1]] - surface.points[face[0]];
            const Tensor<1, 3> y =
              surface.points[face[2]] - surface.points[face[0]];
            area += cross_product_3d(x, y).norm();
          }
        EXPECT_NEAR(area, 25., 1e-12);
      }
}



namespace
{
  /** A wedge is the same body on all levels, level below, sloped above. */
  template <int dim>
  void
  expect_wedge()
  {
    std::array<unsigned int, dim> cells;
    cells.fill(3);
    BodyGeometry<dim> wedge = make_body<dim>(0.5, cells, 2);
    BodyGeometry<dim> below = make_body<dim>(1., cells, 1);
    wedge.upper_slope[0]    = 0.25;
    if (dim == 3)
      wedge.upper_slope[dim - 2] = -0.125;
    const auto               bodies = stack<dim>({below, wedge});
    const MeshHierarchy<dim> meshes(bodies, MPI_COMM_WORLD);
    // The mean thickness times the extent.
    const double volume = (0.5 + 0.25 * 2.5 - (dim == 3 ? 0.125 * 2.5 : 0.)) *
                          std::pow(5., dim - 1);
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      {
        const BodyMesh<dim> &body = *meshes.level(l).bodies[1];
        double               sum  = 0;
        for (const auto &cell : body.triangulation().active_cell_iterators())
          sum += cell->measure();
        EXPECT_NEAR(sum, volume, 1e-12 * volume);
        for (const auto &point : body.surface(BodyMesh<dim>::lower_side).points)
          EXPECT_EQ(point[dim - 1], 1.);
        for (const auto &point : body.surface(BodyMesh<dim>::upper_side).points)
          EXPECT_NEAR(point[dim - 1],
                      1. + bodies[1].thickness_at(point),
                      1e-12);
      }
  }
} // namespace



TEST(MeshCounts, WedgesHaveALevelAndASlopingSide)
{
  expect_wedge<2>();
  expect_wedge<3>();
}



TEST(MeshCounts, RigidBodiesAreOneCell)
{
  auto bodies     = spring_slider_bodies();
  bodies[0].rigid = true;
  const MeshHierarchy<2> meshes(bodies, MPI_COMM_WORLD);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    EXPECT_EQ(meshes.level(l).bodies[0]->triangulation().n_active_cells(), 1u);
  EXPECT_EQ(meshes.finest().n_nodes(), 637u + 4u);
}
