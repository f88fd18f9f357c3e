// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/spline_curve.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include "curved_bodies.h"
#include "error_message.h"
#include "simplex_bodies.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A wave of length one. Straight faces of 1/22 are 1.3e-3 off it. */
  double
  sine(const double x)
  {
    return 0.127 * std::sin(2. * numbers::PI * x);
  }



  /** Distance from the wave, by Newton's method along it. */
  double
  distance_from_sine(const Point<2> &point)
  {
    const double k = 2. * numbers::PI, A = 0.127;
    double       x = point[0];
    for (unsigned int i = 0; i < 50; ++i)
      {
        const double y     = A * std::sin(k * x) - point[1],
                     slope = A * k * std::cos(k * x);
        x -= (x - point[0] + slope * y) /
             (1. + slope * slope - A * k * k * std::sin(k * x) * y);
      }
    return point.distance(Point<2>(x, sine(x)));
  }



  SplineCurve
  spline_of_sine(const unsigned int n_a_wave, const double n_waves)
  {
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= n_a_wave * n_waves; ++i)
      points.emplace_back(double(i) / n_a_wave, sine(double(i) / n_a_wave));
    return SplineCurve(points, false);
  }



  double
  spline_error(const unsigned int n_a_wave)
  {
    const double      n_waves = 2.25;
    const SplineCurve spline  = spline_of_sine(n_a_wave, n_waves);
    double            error   = 0.;
    for (unsigned int i = 0; i <= 2000; ++i)
      {
        const double x = n_waves * i / 2000.;
        error          = std::max(error,
                         distance_from_sine(
                           spline.nearest(Point<2>(x, sine(x) - 1e-3))));
      }
    return error;
  }



  /** Fault nodes of both sides on all levels are on the curve, and in the same
   * places where faces are equally many. */
  template <int dim>
  void
  expect_on_curve(const MeshHierarchy<dim>                        &meshes,
                  const std::function<double(const Point<dim> &)> &distance,
                  const double                                     most)
  {
    EXPECT_GT(meshes.n_levels(), 2u);
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      {
        const auto &first  = meshes.level(l).surface(0, 0).points,
                   &second = meshes.level(l).surface(0, 1).points;
        for (const auto *points : {&first, &second})
          for (const Point<dim> &point : *points)
            EXPECT_LE(distance(point), most) << point << " on level " << l;
        if (first.size() == second.size())
          {
            EXPECT_EQ(first, second) << "on level " << l;
          }
        // Nodes of a level are those of the next one.
        if (l > 0)
          for (const unsigned int side : {0, 1})
            {
              const auto &coarse = meshes.level(l - 1).surface(0, side).points,
                         &fine   = meshes.level(l).surface(0, side).points;
              for (const Point<dim> &point : coarse)
                EXPECT_NE(std::find(fine.begin(), fine.end(), point),
                          fine.end());
            }
      }
  }



  template <int dim>
  BodyGeometry<dim>
  bent_brick(const double base, const unsigned int cells)
  {
    BodyGeometry<dim> body;
    body.lateral_lower.fill(0.);
    body.lateral_upper.fill(1.);
    body.thickness = 0.5;
    body.base      = base;
    body.coarse_cells.fill(cells);
    body.coarse_cells[dim - 1] = 2;
    body.refinement_passes     = 0;
    return body;
  }



  /** Two bricks with a fault of this elevation between them, and no other side
   * that is not level. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  bent_stack(const std::function<double(const Point<dim> &)> &elevation,
             const unsigned int                               cells_below,
             const unsigned int                               cells_above)
  {
    std::vector<BodyGeometry<dim>> bodies = {bent_brick<dim>(-0.5, cells_below),
                                             bent_brick<dim>(0., cells_above)};
    bodies[0].upper_elevation = bodies[1].lower_elevation = elevation;
    return bodies;
  }



  double
  hills(const Point<3> &point)
  {
    return 0.1 * std::sin(2. * point[0]) * std::cos(3. * point[1]);
  }
} // namespace



TEST(SplineCurve, IsOfFourthOrderUpToTheEnds)
{
  const double error = spline_error(22);
  std::cout << "off a sine of 22 points: " << error << '\n';
  EXPECT_LT(error, 1.6e-5);
  EXPECT_GT(spline_error(44) / spline_error(88), 13.);
}



TEST(SplineCurve, OfAClosedCurve)
{
  std::vector<double> errors;
  for (const unsigned int n : {12, 24})
    {
      std::vector<Point<2>> points;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double angle = (2. * numbers::PI * i + 1.2 * (i % 2)) / n;
          points.emplace_back(3. * std::cos(angle), 3. * std::sin(angle));
        }
      const SplineCurve spline(points, true);
      errors.push_back(0.);
      for (unsigned int i = 0; i < 1000; ++i)
        {
          const double   angle = 2. * numbers::PI * i / 1000;
          const Point<2> near(2.9 * std::cos(angle), 2.9 * std::sin(angle));
          errors.back() =
            std::max(errors.back(), std::abs(spline.nearest(near).norm() - 3.));
        }
      for (const Point<2> &point : points)
        EXPECT_EQ(spline.nearest(point), point);
    }
  EXPECT_LT(errors[0], 6e-3);
  EXPECT_GT(errors[0] / errors[1], 13.);
}



TEST(FaultShapes, SmoothCurvesOfQuadrilateralsAndTriangles)
{
  for (const bool of_triangles : {false, true})
    {
      const ShapedBodies<2> bodies =
        two_layers_at(sine, 22, 22, 5, of_triangles);
      const MeshHierarchy<2> meshes(bodies.smooth(1, 3),
                                    bodies.topology,
                                    MPI_COMM_WORLD);
      EXPECT_EQ(meshes.n_levels(), 5u);
      expect_on_curve<2>(meshes, distance_from_sine, 1.6e-5);
      const MeshHierarchy<2> straight(bodies.coarse({nullptr}, 1, 3),
                                      bodies.topology,
                                      MPI_COMM_WORLD);
      double                 off = 0.;
      for (const Point<2> &point : straight.finest().surface(0, 0).points)
        off = std::max(off, distance_from_sine(point));
      EXPECT_NEAR(off, 1.3e-3, 5e-5);
    }
}



TEST(FaultShapes, GivenCurvesOfMeshesThatDoNotMatch)
{
  const auto curve =
    std::make_shared<const GraphShape<2>>(1, [](const Point<2> &x) {
      return sine(x[0]);
    });
  for (const bool of_triangles : {false, true})
    {
      const ShapedBodies<2> bodies =
        two_layers_at(sine, 16, 12, 4, of_triangles);
      const MeshHierarchy<2> meshes(bodies.coarse({curve}, 1, 2),
                                    bodies.topology,
                                    MPI_COMM_WORLD);
      expect_on_curve<2>(
        meshes,
        [](const Point<2> &x) { return std::abs(x[1] - sine(x[0])); },
        0.);
      // The smooth curve is that of the finer side, and the other is on it.
      const MeshHierarchy<2> smooth(bodies.smooth(1, 2),
                                    bodies.topology,
                                    MPI_COMM_WORLD);
      expect_on_curve<2>(smooth, distance_from_sine, 8e-5);
    }
}



TEST(FaultShapes, SteepFaultsGiveAnotherCoordinate)
{
  // The layers above stood on end.
  ShapedBodies<2> bodies = two_layers_at(sine, 16, 16, 4);
  for (auto &body : bodies.cells)
    for (Point<2> &vertex : body.vertices)
      vertex = Point<2>(vertex[1], -vertex[0]);
  const auto curve =
    std::make_shared<const GraphShape<2>>(0, [](const Point<2> &x) {
      return sine(-x[1]);
    });
  const MeshHierarchy<2> meshes(bodies.coarse({curve}, 2),
                                bodies.topology,
                                MPI_COMM_WORLD);
  expect_on_curve<2>(
    meshes, [](const Point<2> &x) { return std::abs(x[0] - sine(-x[1])); }, 0.);
}



TEST(FaultShapes, RingsAreRound)
{
  for (const bool of_triangles : {false, true})
    {
      const ShapedBodies<2> bodies =
        two_rings({{0.5, 1., 2.}}, 20, 20, 3, of_triangles);
      const MeshHierarchy<2> meshes(bodies.smooth(1, 2),
                                    bodies.topology,
                                    MPI_COMM_WORLD);
      expect_on_curve<2>(
        meshes,
        [](const Point<2> &x) { return std::abs(x.norm() - 1.); },
        3e-5);
      const auto &points = meshes.finest().surface(0, 0).points;
      EXPECT_EQ(points.size(), 160u);
    }
}



// A bend by 60 degrees stays one, and both of its sides stay straight.
TEST(FaultShapes, CornersStay)
{
  const auto bend = [](const double x) {
    return x < 0.5 ? 0.4 * x : 0.2 - 0.8 * (x - 0.5);
  };
  const ShapedBodies<2>  bodies = two_layers_at(bend, 8, 8, 4);
  const MeshHierarchy<2> meshes(bodies.smooth(2),
                                bodies.topology,
                                MPI_COMM_WORLD);
  expect_on_curve<2>(
    meshes,
    [&](const Point<2> &x) { return std::abs(x[1] - bend(x[0])); },
    1e-15);
}



TEST(FaultShapes, BricksFollowInProportion)
{
  const auto elevation = [](const Point<2> &x) { return sine(x[0]); };
  for (const unsigned int above : {8u, 6u})
    {
      auto bodies              = bent_stack<2>(elevation, 8, above);
      bodies[1].upper_slope[0] = 0.3;
      for (auto &body : bodies)
        {
          body.uniform_refinements = 1;
          body.refinement_passes   = 2;
        }
      const MeshHierarchy<2> meshes(bodies, MPI_COMM_WORLD);
      expect_on_curve<2>(
        meshes,
        [](const Point<2> &x) { return std::abs(x[1] - sine(x[0])); },
        0.);
      for (unsigned int b = 0; b < 2; ++b)
        {
          const auto positions  = meshes.finest().bodies[b]->node_positions();
          BodyGeometry<2> brick = bodies[b];
          brick.lower_elevation = brick.upper_elevation = {};
          brick.upper_slope.fill(0.);
          const BodyMesh<2> level(brick, meshes.topology().sides_at_faults(b));
          const auto        in_brick = level.node_positions();
          ASSERT_EQ(positions.size(), in_brick.size());
          unsigned int n_hanging = 0;
          for (unsigned int i = 0; i < positions.size(); ++i)
            if (const auto *masters = meshes.finest()
                                        .bodies[b]
                                        ->bound_nodes()
                                        .get_constraint_entries(i))
              {
                // In the middle, where functions are continuous.
                Tensor<1, 2> mean;
                for (const auto &master : *masters)
                  mean += master.second * positions[master.first];
                EXPECT_LT(positions[i].distance(Point<2>(mean)), 1e-15);
                ++n_hanging;
              }
            else
              EXPECT_LT(positions[i].distance(bodies[b].placed(in_brick[i])),
                        1e-14);
          EXPECT_GT(n_hanging, 10u);
        }
    }
}



TEST(FaultShapes, PeriodicBricksAreJoined)
{
  const auto elevation = [](const Point<2> &x) {
    return sine(x[0] == 1. ? 0. : x[0]);
  };
  auto bodies = bent_stack<2>(elevation, 8, 8);
  for (auto &body : bodies)
    {
      body.periodic            = {{true}};
      body.uniform_refinements = 2;
    }
  const MeshHierarchy<2> meshes(bodies, MPI_COMM_WORLD);
  EXPECT_EQ(meshes.finest().surface(0, 0).points.size(), 32u);
  expect_on_curve<2>(
    meshes, [](const Point<2> &x) { return std::abs(x[1] - sine(x[0])); }, 0.);
}



TEST(FaultShapes, SurfacesOfHexahedra)
{
  auto bodies = bent_stack<3>(hills, 4, 4);
  for (auto &body : bodies)
    {
      body.uniform_refinements = 1;
      body.refinement_passes   = 1;
    }
  const MeshHierarchy<3> meshes(bodies, MPI_COMM_WORLD);
  expect_on_curve<3>(
    meshes, [](const Point<3> &x) { return std::abs(x[2] - hills(x)); }, 0.);
}



TEST(FaultShapes, SurfacesOfTetrahedra)
{
  const auto surface = std::make_shared<const GraphShape<3>>(2, hills);
  const auto bricks  = bent_stack<3>(hills, 2, 2);
  std::vector<CoarseBody<3>> bodies;
  for (unsigned int b = 0; b < 2; ++b)
    {
      bodies.push_back(simplex_brick(bricks[b]));
      const auto cells = std::make_shared<Triangulation<3>>();
      cells->copy_triangulation(*bodies[b].cells);
      cells->set_all_manifold_ids(numbers::flat_manifold_id);
      const types::boundary_id side = b == 0 ? 5 : 4;
      for (const auto &face : cells->active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == side)
          for (const unsigned int v : face->vertex_indices())
            face->vertex(v) = surface->place(face->vertex(v));
      set_shapes<3>(*cells, {{side, surface}});
      bodies[b].cells               = cells;
      bodies[b].uniform_refinements = 2;
    }
  const MeshHierarchy<3> meshes(bodies, numbered_stack<3>(2), MPI_COMM_WORLD);
  EXPECT_EQ(meshes.n_levels(), 3u);
  expect_on_curve<3>(
    meshes, [](const Point<3> &x) { return std::abs(x[2] - hills(x)); }, 0.);
}



TEST(FaultShapes, VerticesOffTheCurveAreRefused)
{
  const ShapedBodies<2> bodies = two_layers_at(sine, 16, 16, 4);
  const auto            higher = [](const double by) {
    return std::make_shared<const GraphShape<2>>(1, [by](const Point<2> &x) {
      return sine(x[0]) + by;
    });
  };
  EXPECT_EQ(bodies.coarse({higher(0.005)}, 0).size(), 2u);
  expect_one_sentence_with(message_of(
                             [&]() { bodies.coarse({higher(0.01)}, 0); }),
                           {"'main'", "0.01 m off", "a tenth"});
}



TEST(FaultShapes, InvertedCellsAreRefused)
{
  // A wave that the coarse cells do not see, and that is higher than they are.
  const auto needles =
    std::make_shared<const GraphShape<2>>(1, [](const Point<2> &x) {
      return std::sin(16. * numbers::PI * x[0]);
    });
  const auto level = [](const double) { return 0.; };
  for (const bool of_triangles : {false, true})
    {
      const ShapedBodies<2> bodies =
        two_layers_at(level, 16, 16, 2, of_triangles);
      const auto coarse = bodies.coarse({needles}, 1);
      expect_one_sentence_with(message_of([&]() {
                                 MeshHierarchy<2>(coarse,
                                                  bodies.topology,
                                                  MPI_COMM_WORLD);
                               }),
                               {"inverted", "smaller"});
    }
}
