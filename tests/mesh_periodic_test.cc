// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mesh/refined_cells.h>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  template <int dim>
  BodyGeometry<dim>
  endless_body()
  {
    BodyGeometry<dim> body;
    body.lateral_lower.fill(-1.);
    body.lateral_upper.fill(1.);
    body.coarse_cells.fill(2);
    body.refinement_passes = 2;
    body.periodic.fill(true);
    return body;
  }



  template <int dim>
  Point<dim>
  image(Point<dim> x)
  {
    for (unsigned int d = 0; d + 1 < dim; ++d)
      if (x[d] == 1.)
        x[d] = -1.;
    return x;
  }



  /** Bound nodes that are no hanging ones have the value at their image. */
  template <int dim>
  void
  expect_images(const BodyMesh<dim> &body)
  {
    const std::vector<Point<dim>> points = body.node_positions();
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const auto *entries = body.bound_nodes().get_constraint_entries(i);
        if (image(points[i]) == points[i])
          continue;
        ASSERT_NE(entries, nullptr) << points[i];
        // A node and its hanging image: both hang on the same nodes.
        if (entries->size() == 1)
          {
            EXPECT_EQ(points[entries->front().first], image(points[i]));
            EXPECT_EQ(entries->front().second, 1.);
          }
        for (const auto &entry : *entries)
          EXPECT_FALSE(body.bound_nodes().is_constrained(entry.first));
      }
  }



  template <int dim>
  void
  expect_endless_sides(const BodyMesh<dim> &body, const types::boundary_id side)
  {
    const FaultSurface<dim> surface = body.surface(side);
    ASSERT_EQ(surface.wraps.size(), surface.faces.size());
    for (const Point<dim> &point : surface.points)
      EXPECT_EQ(image(point), point);
    double area = 0;
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      {
        const auto vertices = surface.face_vertices(surface.points, f);
        double     size     = 1.;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          size *= vertices.back()[d] - vertices.front()[d];
        EXPECT_GT(size, 0.);
        area += size;
      }
    EXPECT_NEAR(area, dim == 2 ? 2. : 4., 1e-12);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      EXPECT_EQ(surface.period[d], 2.);
  }



  template <int dim>
  void
  expect_endless_hierarchy()
  {
    const MeshHierarchy<dim> meshes(
      stack<dim>({endless_body<dim>(), endless_body<dim>()}), MPI_COMM_SELF);
    EXPECT_EQ(meshes.n_levels(), 3u);
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      for (unsigned int b = 0; b < 2; ++b)
        {
          expect_images(*meshes.level(l).bodies[b]);
          expect_endless_sides(*meshes.level(l).bodies[b],
                               b == 0 ? BodyMesh<dim>::upper_side :
                                        BodyMesh<dim>::lower_side);
        }

    // Constants are prolongated to constants, and bound nodes stay out.
    for (unsigned int l = 1; l < meshes.n_levels(); ++l)
      for (unsigned int b = 0; b < 2; ++b)
        {
          const BodyMesh<dim> &body = *meshes.level(l).bodies[b];
          for (unsigned int i = 0; i < body.dof_handler().n_dofs(); ++i)
            {
              double sum = 0;
              for (const auto &entry : meshes.prolongation(l).row(
                     meshes.level(l).global_node(b, i)))
                sum += entry.second;
              EXPECT_NEAR(sum,
                          body.bound_nodes().is_constrained(i) ? 0. : 1.,
                          1e-14);
            }
        }
  }
} // namespace



TEST(PeriodicMesh, SidesAreOne)
{
  expect_endless_hierarchy<2>();
}



TEST(PeriodicMesh, SidesAreOneInThreeDimensions)
{
  expect_endless_hierarchy<3>();
}



namespace
{
  /** Cells at one end of a body are refined again and again. */
  template <int dim>
  void
  expect_images_of_refined_end(const double end)
  {
    BodyGeometry<dim> geometry   = endless_body<dim>();
    geometry.refinement_passes   = 0;
    geometry.uniform_refinements = 1;
    CoarseBody<dim> body         = coarse_brick(geometry);
    for (unsigned int pass = 0; pass < 3; ++pass)
      {
        const BodyMesh<dim> mesh(body, {});
        body.refined_cells = refined_cells(mesh.triangulation());
        for (const auto &cell : mesh.triangulation().active_cell_iterators())
          for (const auto v : cell->vertex_indices())
            if (cell->vertex(v)[0] == end && cell->vertex(v)[dim - 1] == 0.)
              body.refined_cells.insert(cell->id());
      }
    auto mesh =
      std::make_shared<const BodyMesh<dim>>(body,
                                            std::set<types::boundary_id>());
    while (true)
      {
        expect_images(*mesh);
        expect_endless_sides(*mesh, BodyMesh<dim>::upper_side);
        if (!mesh->can_be_coarsened())
          break;
        mesh = BodyMesh<dim>::coarsened(*mesh);
      }
  }
} // namespace



TEST(PeriodicMesh, EitherEndMayBeRefined)
{
  for (const double end : {-1., 1.})
    {
      expect_images_of_refined_end<2>(end);
      expect_images_of_refined_end<3>(end);
    }
}



TEST(PeriodicMesh, AColumnOfSingleCells)
{
  BodyGeometry<2> column   = endless_body<2>();
  column.coarse_cells      = {{1, 5}};
  column.refinement_passes = 0;
  const BodyMesh<2> body(column, {BodyMesh<2>::upper_side});
  expect_images(body);
  const FaultSurface<2> fault = body.surface(BodyMesh<2>::upper_side);
  ASSERT_EQ(fault.faces.size(), 1u);
  EXPECT_EQ(fault.nodes.size(), 1u);
  EXPECT_EQ(fault.face_size(0), 2.);
}
