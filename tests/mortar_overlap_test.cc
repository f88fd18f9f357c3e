// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <stickslip/mortar/face_overlap.h>
#include <stickslip/mortar/face_shape.h>
#include <stickslip/mortar/polygon_clipping.h>

#include <set>

#include "mortar_surfaces.h"

using namespace StickSlip;

namespace
{
  Polygon
  rectangle(const double x0, const double x1, const double y0, const double y1)
  {
    return {Point<2>(x0, y0),
            Point<2>(x1, y0),
            Point<2>(x1, y1),
            Point<2>(x0, y1)};
  }



  Polygon
  rotated(const Polygon &polygon, const double angle)
  {
    Polygon result;
    for (const Point<2> &p : polygon)
      result.push_back(
        Point<2>(std::cos(angle) * p[0] - std::sin(angle) * p[1],
                 std::sin(angle) * p[0] + std::cos(angle) * p[1]));
    return result;
  }



  template <int dim>
  std::vector<OverlapCell<dim>>
  overlap(const Side<dim> &slave, const Side<dim> &master)
  {
    return compute_face_overlap<dim>(slave.surface,
                                     slave.positions,
                                     reversed(master.surface),
                                     master.positions);
  }



  template <int dim>
  double
  total_measure(const std::vector<OverlapCell<dim>> &cells)
  {
    double total = 0.;
    for (const auto &cell : cells)
      total += cell.measure();
    return total;
  }



  /** Integrals of 1, x, y, x^2, x y, y^2 by the rule of edge midpoints. */
  std::array<double, 6>
  moments(const std::vector<OverlapCell<3>> &cells)
  {
    std::array<double, 6> result = {};
    for (const auto &cell : cells)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<2> x =
            cell.vertices[i] +
            0.5 * (cell.vertices[(i + 1) % 3] - cell.vertices[i]);
          const double weight = cell.measure() / 3.;
          result[0] += weight;
          result[1] += weight * x[0];
          result[2] += weight * x[1];
          result[3] += weight * x[0] * x[0];
          result[4] += weight * x[0] * x[1];
          result[5] += weight * x[1] * x[1];
        }
    return result;
  }
} // namespace



TEST(PolygonClipping, AreasOfKnownIntersections)
{
  const Polygon square = rectangle(-0.5, 0.5, -0.5, 0.5);

  // A square and itself turned by 45 degrees share a regular octagon.
  EXPECT_NEAR(signed_area(
                clip_convex_polygon(square, rotated(square, numbers::PI / 4.))),
              2. * (std::sqrt(2.) - 1.),
              1e-15);
  // One inside the other, both ways.
  const Polygon small = rotated(rectangle(-.1, .2, -.1, .1), 0.3);
  EXPECT_NEAR(signed_area(clip_convex_polygon(square, small)), 0.06, 1e-16);
  EXPECT_NEAR(signed_area(clip_convex_polygon(small, square)), 0.06, 1e-16);
  // One polygon twice, shifted along an edge, touching, and apart.
  EXPECT_DOUBLE_EQ(signed_area(clip_convex_polygon(square, square)), 1.);
  EXPECT_NEAR(signed_area(
                clip_convex_polygon(square, rectangle(-.2, .8, -.5, .5))),
              0.7,
              1e-15);
  EXPECT_EQ(
    signed_area(clip_convex_polygon(square, rectangle(.5, 1.5, -.5, .5))), 0.);
  EXPECT_EQ(signed_area(clip_convex_polygon(square, rectangle(2, 3, 2, 3))),
            0.);
  // A corner cut off.
  EXPECT_NEAR(signed_area(clip_convex_polygon(
                square,
                {Point<2>(0.5, 0.), Point<2>(0.5, 2.), Point<2>(-1.5, 2.)})),
              0.125,
              1e-15);
}



TEST(PolygonClipping, RandomPairsKeepTheAreaOfAllPieces)
{
  // The four quarters of the plane about a random point cut a polygon into
  // pieces that add up to it, and clipping is symmetric.
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const Polygon quad =
        rotated(rectangle(-1., 0.3 + number(random) / 4., -0.7, 0.9),
                4. * number(random));
      const double x = number(random), y = number(random);
      const double angle = 4. * number(random);
      double       sum   = 0.;
      for (const auto &quarter : {rectangle(-9., x, -9., y),
                                  rectangle(x, 9., -9., y),
                                  rectangle(x, 9., y, 9.),
                                  rectangle(-9., x, y, 9.)})
        {
          const Polygon window = rotated(quarter, angle);
          const double  area   = signed_area(clip_convex_polygon(quad, window));
          EXPECT_NEAR(area,
                      signed_area(clip_convex_polygon(window, quad)),
                      1e-14);
          sum += area;
        }
      EXPECT_NEAR(sum, signed_area(quad), 1e-14);
    }
}



namespace
{
  std::array<Point<2>, 4>
  pick(const std::vector<Point<2>>       &positions,
       const std::array<unsigned int, 4> &face)
  {
    std::array<Point<2>, 4> vertices;
    for (unsigned int v = 0; v < 4; ++v)
      vertices[v] = positions[face[v]];
    return vertices;
  }
} // namespace



TEST(FaceShape, InverseOfTheBilinearMap)
{
  const std::vector<Point<2>> positions = {Point<2>(0.1, 0.),
                                           Point<2>(1., -0.2),
                                           Point<2>(0., 0.8),
                                           Point<2>(1.4, 1.3)};
  for (const auto &face : {std::array<unsigned int, 4>{{0, 1, 2, 3}},
                           std::array<unsigned int, 4>{{1, 0, 3, 2}}})
    {
      const FaceShape<3> shape(pick(positions, face));
      double             total = 0.;
      for (const double integral : shape.shape_integrals())
        total += integral;
      EXPECT_NEAR(total, shape.measure(), 1e-15);

      for (const double s : {0., 0.3, 1.})
        for (const double t : {0., 0.8, 1.})
          {
            const std::array<double, 4> phi = {
              {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
            Point<2> x;
            for (unsigned int i = 0; i < 4; ++i)
              x += phi[i] * shape.vertices()[i];
            const auto values = shape.shape_values(x);
            for (unsigned int i = 0; i < 4; ++i)
              EXPECT_NEAR(values[i], phi[i], 2e-15);
          }
    }
}



TEST(FaceShape, FacesInsideOutAreRefused)
{
  const std::vector<Point<2>> positions = {Point<2>(0., 0.),
                                           Point<2>(1., 0.),
                                           Point<2>(0., 1.),
                                           Point<2>(0.2, 0.2)};
  for (const std::array<unsigned int, 4> &face :
       {std::array<unsigned int, 4>{{0, 1, 2, 3}},
        std::array<unsigned int, 4>{{0, 1, 3, 2}},
        std::array<unsigned int, 4>{{0, 1, 0, 1}}})
    EXPECT_THROW(FaceShape<3>(pick(positions, face)), ExcMessage);
  for (const double end : {1., std::nan("")})
    EXPECT_THROW(FaceShape<2>(
                   std::array<Point<1>, 2>{{Point<1>(1.), Point<1>(end)}}),
                 ExcMessage);
}



TEST(FaceOverlap, SegmentsOnALine)
{
  const auto cells = overlap(line({0., 1., 3.}), line({-1., 0.5, 2., 2.5}));
  ASSERT_EQ(cells.size(), 4u);
  const std::vector<std::array<double, 4>> expected = {{{0, 0, 0., 0.5}},
                                                       {{0, 1, 0.5, 1.}},
                                                       {{1, 1, 1., 2.}},
                                                       {{1, 2, 2., 2.5}}};
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(cells[i].slave_face, expected[i][0]);
      EXPECT_EQ(cells[i].master_face, expected[i][1]);
      EXPECT_EQ(cells[i].vertices[0][0], expected[i][2]);
      EXPECT_EQ(cells[i].vertices[1][0], expected[i][3]);
    }
}



TEST(FaceOverlap, NumberingDoesNotMatter)
{
  std::mt19937 random(2);
  const auto   slave  = line(random_breakpoints(23, -2.5, 2.5, random));
  const auto   master = line(random_breakpoints(7, -2.1, 2.9, random));
  const auto   cells  = overlap(slave, master);
  EXPECT_NEAR(total_measure(cells), 4.6, 1e-14);

  const auto shuffled =
    overlap(shuffle(slave, random), shuffle(master, random));
  ASSERT_EQ(cells.size(), shuffled.size());
  std::set<unsigned int> finished;
  auto                   sorted = shuffled;
  std::sort(sorted.begin(), sorted.end(), [](const auto &a, const auto &b) {
    return a.vertices[0][0] < b.vertices[0][0];
  });
  for (unsigned int i = 0; i < cells.size(); ++i)
    {
      EXPECT_EQ(cells[i].vertices[0], sorted[i].vertices[0]);
      EXPECT_EQ(cells[i].vertices[1], sorted[i].vertices[1]);
      // The cells of a slave face follow each other.
      if (i > 0 && shuffled[i].slave_face != shuffled[i - 1].slave_face)
        {
          EXPECT_TRUE(finished.insert(shuffled[i - 1].slave_face).second);
        }
      EXPECT_EQ(finished.count(shuffled[i].slave_face), 0u);
    }
}



TEST(FaceOverlap, SliversAreDropped)
{
  EXPECT_EQ(overlap(line({0., 1.}), line({1., 2.})).size(), 0u);
  EXPECT_EQ(overlap(line({0., 1.}), line({1. - 5e-15, 2.})).size(), 0u);
  EXPECT_EQ(overlap(line({0., 1.}), line({1. - 5e-14, 2.})).size(), 1u);
  EXPECT_EQ(overlap(line({0., 1.}), line({3., 4.})).size(), 0u);

  const std::vector<double> unit = {0., 1.};
  EXPECT_EQ(overlap(grid(unit, unit), grid({1., 2.}, unit)).size(), 0u);
  EXPECT_EQ(overlap(grid(unit, unit), grid({1. - 5e-15, 2.}, unit)).size(), 0u);
  EXPECT_NEAR(total_measure(
                overlap(grid(unit, unit), grid({1. - 5e-14, 2.}, unit))),
              5e-14,
              1e-16);
}



TEST(FaceOverlap, FacesTurnedAroundAreRefused)
{
  Side<2> folded         = line({0., 1., 2.});
  folded.positions[2][0] = 0.5;
  EXPECT_THROW(overlap(folded, line({0., 1.})), ExcMessage);
  EXPECT_THROW(overlap(line({0., 1.}), folded), ExcMessage);
}



TEST(FaceOverlap, FacesOfTheSameOrientationDoNotCouple)
{
  const Side<2> side  = line({0., 1., 2.});
  const auto    cells = [&](const FaultSurface<2> &master) {
    return compute_face_overlap<2>(side.surface,
                                   side.positions,
                                   master,
                                   side.positions);
  };
  EXPECT_EQ(cells(reversed(side.surface)).size(), 2u);
  EXPECT_EQ(cells(side.surface).size(), 0u);
}



TEST(FaceOverlap, MomentsOfARotatedGrid)
{
  // The rotated grid lies inside the other one, so the overlap is the grid.
  std::mt19937 random(3);
  const auto   outer = grid(random_breakpoints(13, -2., 2., random),
                          random_breakpoints(9, -2., 2., random));
  for (const double angle : {0., 0.2, numbers::PI / 4., 1.3, numbers::PI / 2.})
    {
      const double x0 = -0.8, x1 = 1., y0 = -0.5, y1 = 0.9;
      const auto   inner = grid(random_breakpoints(8, x0, x1, random),
                              random_breakpoints(11, y0, y1, random),
                              angle);

      const double                area = (x1 - x0) * (y1 - y0);
      const double                a = (x0 + x1) / 2., b = (y0 + y1) / 2.;
      const double                aa = (x0 * x0 + x0 * x1 + x1 * x1) / 3.;
      const double                bb = (y0 * y0 + y0 * y1 + y1 * y1) / 3.;
      const double                c = std::cos(angle), s = std::sin(angle);
      const std::array<double, 6> expected = {
        {area,
         area * (c * a - s * b),
         area * (s * a + c * b),
         area * (c * c * aa - 2. * c * s * a * b + s * s * bb),
         area * (c * s * aa + (c * c - s * s) * a * b - c * s * bb),
         area * (s * s * aa + 2. * c * s * a * b + c * c * bb)}};

      for (const auto &cells :
           {overlap(outer, inner),
            overlap(inner, outer),
            overlap(shuffle(inner, random), shuffle(outer, random))})
        {
          const auto computed = moments(cells);
          for (unsigned int i = 0; i < 6; ++i)
            EXPECT_NEAR(computed[i], expected[i], 1e-13)
              << "moment " << i << ", angle " << angle;
        }
    }
}



TEST(FaceOverlap, MomentsOfShiftedGrids)
{
  std::mt19937 random(4);
  const auto   x = uniform_breakpoints(8, -2.5, 2.5);
  const auto   y = uniform_breakpoints(3, -0.5, 0.5);
  for (const double shift : {0., 1e-13, 1e-9, 1e-4, 0.1, 0.625, 1., 4.9})
    {
      std::vector<double> shifted = x;
      for (double &value : shifted)
        value += shift;
      const auto   computed = moments(overlap(shuffle(grid(x, y), random),
                                            shuffle(grid(shifted, y), random)));
      const double length = 5. - shift, middle = shift / 2.;
      EXPECT_NEAR(computed[0], length, 1e-13);
      EXPECT_NEAR(computed[1], length * middle, 1e-13);
      EXPECT_NEAR(computed[2], 0., 1e-13);
      EXPECT_NEAR(computed[3],
                  length * (middle * middle + length * length / 12.),
                  1e-13);
      EXPECT_NEAR(computed[4], 0., 1e-13);
      EXPECT_NEAR(computed[5], length / 12., 1e-13);
    }
}
