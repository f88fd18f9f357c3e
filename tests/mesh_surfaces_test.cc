// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/smooth_surface.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include "curved_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A part of the unit sphere over the square of [-0.5, 0.5]^2, with points of
   * no order: n by n quadrilaterals, or two triangles for each. */
  SmoothSurface
  surface_of_cap(const unsigned int n, const bool of_triangles)
  {
    std::vector<Point<3>>                  points;
    std::vector<std::vector<unsigned int>> faces;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const bool   is_inner_x = i % n != 0, is_inner_y = j % n != 0;
          const double x =
                         (i + 0.2 * is_inner_x * std::sin(7. * i + 3. * j)) / n,
                       y =
                         (j + 0.2 * is_inner_y * std::cos(5. * i + 4. * j)) / n;
          const Point<3> flat(x - 0.5, y - 0.5, 0.);
          points.emplace_back(flat[0],
                              flat[1],
                              std::sqrt(1. - flat.norm_square()));
        }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int a = j * (n + 1) + i, b = a + 1, c = a + n + 1,
                             d = c + 1;
          if (of_triangles)
            {
              faces.push_back({a, b, d});
              faces.push_back({a, d, c});
            }
          else
            faces.push_back({a, b, c, d});
        }
    return SmoothSurface(points, faces, {});
  }



  /** Largest distance from the sphere, and angle between the normals, rad. */
  std::array<double, 2>
  cap_errors(const unsigned int n, const bool of_triangles)
  {
    const SmoothSurface   surface  = surface_of_cap(n, of_triangles);
    std::array<double, 2> errors   = {};
    const unsigned int    n_points = 31;
    const double          step     = 1e-4;
    for (unsigned int i = 1; i < n_points; ++i)
      for (unsigned int j = 1; j < n_points; ++j)
        {
          const auto place = [&](const double by_x, const double by_y) {
            const double x = 1. * i / n_points - 0.5 + by_x,
                         y = 1. * j / n_points - 0.5 + by_y;
            // Off it as points in faces are.
            const double off = 0.2 / (n * n);
            return surface.place(
              Point<3>(x, y, std::sqrt(1. - x * x - y * y) - off));
          };
          const Point<3>     at = place(0., 0.);
          const Tensor<1, 3> normal =
            cross_product_3d(place(step, 0.) - place(-step, 0.),
                             place(0., step) - place(0., -step));
          errors[0] = std::max(errors[0], std::abs(at.norm() - 1.));
          errors[1] = std::max(
            errors[1],
            cross_product_3d(normal / normal.norm(), Tensor<1, 3>(at)).norm());
        }
    return errors;
  }



  /** A layer of the unit square between two surfaces, n by n by n_high
   * hexahedra, or six tetrahedra for each; sides are numbered as those of
   * bricks. */
  BodyCells<3>
  layer_in_space(
    const std::function<double(const double, const double)> &bottom,
    const std::function<double(const double, const double)> &top,
    const unsigned int                                       n,
    const unsigned int                                       n_high,
    const bool                                               of_tetrahedra)
  {
    const std::array<unsigned int, 3>        cells = {{n, n, n_high}};
    BodyCells<3>                             body;
    std::vector<std::array<unsigned int, 3>> index;
    for (unsigned int k = 0; k <= n_high; ++k)
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          {
            const double x = double(i) / n, y = double(j) / n,
                         s = double(k) / n_high;
            body.vertices.emplace_back(x,
                                       y,
                                       (1. - s) * bottom(x, y) + s * top(x, y));
            index.push_back({{i, j, k}});
          }
    const auto add = [&](const std::vector<unsigned int> &vertices) {
      CellData<3> cell(vertices.size());
      cell.vertices = vertices;
      body.cells.push_back(cell);
    };
    // A face with all its vertices on one side is of that side.
    const auto add_face = [&](const std::vector<unsigned int> &vertices) {
      for (unsigned int d = 0; d < 3; ++d)
        for (const unsigned int end : {0u, 1u})
          if (std::all_of(vertices.begin(), vertices.end(), [&](const auto v) {
                return index[v][d] == end * cells[d];
              }))
            {
              CellData<2> face(vertices.size());
              face.vertices    = vertices;
              face.boundary_id = 2 * d + end;
              body.boundary.boundary_quads.push_back(face);
            }
    };
    for (unsigned int k = 0; k < n_high; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            std::array<unsigned int, 8> v;
            for (unsigned int c = 0; c < 8; ++c)
              v[c] = ((k + (c >> 2)) * (n + 1) + j + ((c >> 1) & 1)) * (n + 1) +
                     i + (c & 1);
            if (!of_tetrahedra)
              {
                add({v.begin(), v.end()});
                for (const auto &f : {std::array<unsigned int, 4>{{0, 2, 4, 6}},
                                      {{1, 3, 5, 7}},
                                      {{0, 1, 4, 5}},
                                      {{2, 3, 6, 7}},
                                      {{0, 1, 2, 3}},
                                      {{4, 5, 6, 7}}})
                  add_face({v[f[0]], v[f[1]], v[f[2]], v[f[3]]});
                continue;
              }
            // Around the diagonal from 0 to 7.
            for (const auto &around : {std::array<unsigned int, 2>{{1, 3}},
                                       {{3, 2}},
                                       {{2, 6}},
                                       {{6, 4}},
                                       {{4, 5}},
                                       {{5, 1}}})
              {
                const std::array<unsigned int, 4> t = {
                  {v[0], v[around[0]], v[around[1]], v[7]}};
                add({t.begin(), t.end()});
                for (unsigned int f = 0; f < 4; ++f)
                  add_face({t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]});
              }
          }
    return body;
  }



  /** Two such layers of height one half about a surface. */
  ShapedBodies<3>
  two_layers_in_space(
    const std::function<double(const double, const double)> &f,
    const unsigned int                                       n,
    const unsigned int                                       n_high,
    const bool                                               of_tetrahedra)
  {
    const auto level = [](const double z) {
      return [z](const double, const double) { return z; };
    };
    ShapedBodies<3> result;
    result.cells    = {layer_in_space(level(-0.5), f, n, n_high, of_tetrahedra),
                       layer_in_space(f, level(0.7), n, n_high, of_tetrahedra)};
    result.topology = stack_topology<3>({"lower", "upper"}, {"main"});
    return result;
  }
} // namespace



TEST(SmoothSurface, IsOfFourthOrderUpToTheEdges)
{
  for (const bool of_triangles : {false, true})
    {
      const auto coarse = cap_errors(4, of_triangles),
                 fine   = cap_errors(32, of_triangles);
      const auto order  = [&](const unsigned int i) {
        return std::log2(coarse[i] / fine[i]) / 3.;
      };
      std::cout << (of_triangles ? "triangles" : "quadrilaterals")
                << ": distance " << coarse[0] << ", " << fine[0] << ", order "
                << order(0) << "; normals " << coarse[1] << ", " << fine[1]
                << ", order " << order(1) << '\n';
      EXPECT_LT(fine[0], 6e-7);
      EXPECT_LT(fine[1], 1.5e-4);
      EXPECT_GT(order(0), 3.5);
      EXPECT_GT(order(1), 2.2);
    }
}



TEST(SmoothSurface, PlanesStayPlane)
{
  const Tensor<1, 3>    slope({0.3, -0.7, 0.});
  std::vector<Point<3>> points;
  for (unsigned int i = 0; i < 9; ++i)
    {
      const Tensor<1, 3> flat({1. * (i % 3), 1. * (i / 3), 0.});
      points.emplace_back(flat[0], flat[1], slope * flat);
    }
  const SmoothSurface surface(
    points, {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}, {4, 5, 7, 8}}, {});
  for (const double x : {0., 0.3, 1.5})
    for (const double y : {0.2, 1., 2.})
      {
        const Point<3> at = surface.place(Point<3>(x, y, 0.3 * x - 0.7 * y));
        EXPECT_NEAR(at[2], 0.3 * at[0] - 0.7 * at[1], 1e-15);
      }
}



// Two planes and the right angle between them.
TEST(SmoothSurface, EdgesStay)
{
  std::vector<Point<3>> points;
  for (const unsigned int y : {0, 1, 2})
    for (const auto &[x, z] : {std::pair<double, double>{-2., 0.},
                               {-1., 0.},
                               {0., 0.},
                               {0., 1.},
                               {0., 2.}})
      points.emplace_back(x, 1. * y, z);
  std::vector<std::vector<unsigned int>> faces;
  for (const unsigned int first : {0, 1, 2, 3, 5, 6, 7, 8})
    faces.push_back({first, first + 1, first + 5, first + 6});
  const SmoothSurface surface(points, faces, {});
  for (const Point<3> &point : {Point<3>(-0.5, 0.5, 0.),
                                Point<3>(0., 0.3, 0.7),
                                Point<3>(0., 1.5, 0.),
                                Point<3>(-2., 0.2, 0.)})
    EXPECT_LT(surface.place(point).distance(point), 1e-15) << point;
}



// Tetrahedra and hexahedra below and above a cylinder's part and a cap.
TEST(FaultShapes, SmoothSurfacesOfBodies)
{
  const auto cylinder = [](const double, const double y) {
    return std::sqrt(2. - (y - 0.3) * (y - 0.3)) - 1.3;
  };
  const auto cap = [](const double x, const double y) {
    return std::sqrt(2. - (x - 0.4) * (x - 0.4) - (y - 0.3) * (y - 0.3)) - 1.3;
  };
  for (const bool of_tetrahedra : {false, true})
    for (const bool is_cap : {false, true})
      {
        const auto distance = [&](const Point<3> &x) {
          const Tensor<1, 3> from(
            {is_cap ? x[0] - 0.4 : 0., x[1] - 0.3, x[2] + 1.3});
          return std::abs(from.norm() - std::sqrt(2.));
        };
        std::vector<double> errors;
        for (const unsigned int n : {4, 8})
          {
            const ShapedBodies<3> bodies =
              two_layers_in_space(is_cap ? cap : cylinder, n, 2, of_tetrahedra);
            const MeshHierarchy<3> meshes(bodies.smooth(2),
                                          bodies.topology,
                                          MPI_COMM_WORLD);
            EXPECT_EQ(meshes.n_levels(), 3u);
            const auto &first  = meshes.finest().surface(0, 0).points,
                       &second = meshes.finest().surface(0, 1).points;
            EXPECT_EQ(first, second);
            errors.push_back(0.);
            unsigned int n_on_sides = 0;
            for (const Point<3> &point : first)
              {
                errors.back() = std::max(errors.back(), distance(point));
                for (const unsigned int d : {0, 1})
                  {
                    EXPECT_GE(point[d], -1e-15);
                    EXPECT_LE(point[d], 1. + 1e-15);
                    n_on_sides += std::abs(point[d] - 0.5) > 0.5 - 1e-14;
                  }
              }
            // Points of edges stay on the sides of the bodies.
            EXPECT_EQ(n_on_sides, 4 * (4 * n + 1));
          }
        std::cout << (of_tetrahedra ? "tetrahedra" : "hexahedra") << ", "
                  << (is_cap ? "cap" : "cylinder") << ": off by " << errors[0]
                  << " and " << errors[1] << '\n';
        // Straight faces are 4e-3 off the cap.
        EXPECT_LT(errors[1], 9e-5);
        EXPECT_GT(errors[0] / errors[1], 2.5);
      }
}
