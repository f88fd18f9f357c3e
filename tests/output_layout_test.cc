// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/output/event_catalogue.h>
#include <stickslip/output/fault_layout.h>

#include <cmath>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Nodes and the faces between them; the tangent at each node is given by its
   * angle. */
  FaultLayout<2>
  shape_of(const std::vector<Point<2>>                    &points,
           const std::vector<std::array<unsigned int, 2>> &faces,
           const std::vector<double>                      &angles)
  {
    FaultLayout<2> shape;
    shape.surface.points = points;
    shape.surface.faces  = faces;
    // Not level.
    shape.surface.face_normals.resize(faces.size());
    for (const double angle : angles)
      shape.axes.push_back(Tensor<2, 2>({{std::cos(angle), -std::sin(angle)},
                                         {std::sin(angle), std::cos(angle)}}));
    return shape;
  }



  void
  expect_lengths(const FaultLayout<2>      &shape,
                 const std::vector<double> &expected)
  {
    const std::vector<double> lengths = arc_lengths(shape);
    ASSERT_EQ(lengths.size(), expected.size());
    for (unsigned int k = 0; k < lengths.size(); ++k)
      EXPECT_NEAR(lengths[k], expected[k], 1e-12) << k;
  }
} // namespace



TEST(ArcLength, GrowsAlongTheTangentsWhateverTheOrderOfNodesAndFaces)
{
  // Three edges of a staircase, of lengths 3, 5 and 4, from (0, 0) to (4, 8).
  const std::vector<Point<2>> points = {Point<2>(4, 8),
                                        Point<2>(0, 3),
                                        Point<2>(0, 0),
                                        Point<2>(4, 4)};
  const double                up     = numbers::PI / 2;
  expect_lengths(shape_of(points,
                          {{{0, 3}}, {{2, 1}}, {{3, 1}}},
                          {up, 0.7, up, 0.7}),
                 {3 + std::sqrt(17.) + 4, 3, 0, 3 + std::sqrt(17.)});
  // With the tangents the other way round, from the other end.
  const double down = up + numbers::PI;
  expect_lengths(shape_of(points,
                          {{{0, 3}}, {{2, 1}}, {{3, 1}}},
                          {down, 0.7 + numbers::PI, down, 0.7 + numbers::PI}),
                 {0, 4 + std::sqrt(17.), 7 + std::sqrt(17.), 4});
}



TEST(ArcLength, BeginsOnARingWhereXIsLeast)
{
  constexpr unsigned int                   n = 12;
  std::vector<Point<2>>                    points;
  std::vector<std::array<unsigned int, 2>> faces;
  std::vector<double>                      angles, expected;
  // The tangents run clockwise.
  for (unsigned int k = 0; k < n; ++k)
    {
      const double phi = 2 * numbers::PI * k / n;
      points.emplace_back(std::cos(phi), std::sin(phi));
      angles.push_back(phi - numbers::PI / 2);
      faces.push_back({{k, (k + 1) % n}});
      expected.push_back(2 * std::sin(numbers::PI / n) * ((n + n / 2 - k) % n));
    }
  expect_lengths(shape_of(points, faces, angles), expected);
}



TEST(ArcLength, GoesOnBeyondCrossingsAndGaps)
{
  // Two pieces that meet at (1, 0), whose node is there twice, and a third one
  // from (3, 1) on.
  expect_lengths(shape_of({Point<2>(3, 1),
                           Point<2>(4, 1),
                           Point<2>(1, 0),
                           Point<2>(3, 0),
                           Point<2>(0, 0),
                           Point<2>(1, 0)},
                          {{{0, 1}}, {{2, 3}}, {{4, 5}}},
                          std::vector<double>(6, 0.)),
                 {4, 5, 1, 3, 0, 1});
}



TEST(ArcLength, OfAPeriodicFaultIsTheWayFromItsFirstNode)
{
  FaultLayout<2> shape =
    shape_of({Point<2>(-1, 2), Point<2>(0, 2), Point<2>(2, 2)},
             {{{0, 1}}, {{1, 2}}, {{2, 0}}},
             {0, 0, 0});
  shape.surface.period[0] = 4;
  shape.surface.wraps = {{{{{0}}, {{0}}}}, {{{{0}}, {{0}}}}, {{{{0}}, {{1}}}}};
  expect_lengths(shape, {0, 1, 3});
}



TEST(EventCatalogue, SaysWhereOnABentFaultAnEventBegan)
{
  const TemporaryFolder folder;
  const FaultLayout<2>  bent =
    shape_of({Point<2>(-3, 4), Point<2>(0, 0)}, {{{0, 1}}}, {-0.9, -0.9});
  EventCatalogue<2> catalogue(
    folder.file("events.csv"), {"main"}, {bent}, 1e-3, 0.5);
  FaultSnapshot<2> fault;
  fault.points  = bent.surface.points;
  fault.weights = {1, 1};
  fault.state   = {1, 1};
  fault.slip.resize(2);
  fault.shear_traction.resize(2);
  for (const double rate : {0., 1., 0.})
    {
      fault.slip_rate = {Tensor<1, 1>({rate / 2}), Tensor<1, 1>({-rate})};
      catalogue.add(catalogue.state().faults[0].time + 1., {fault});
    }
  ASSERT_EQ(catalogue.entries().size(), 1u);
  EXPECT_EQ(catalogue.entries()[0].nucleation, (std::vector<double>{0, 0, 5}));
  const std::string text = content_of(folder.file("events.csv"));
  EXPECT_NE(text.find("mean_slip,nucleation_x,nucleation_y,"
                      "nucleation_arc_length,moment,peak_moment_rate,"
                      "stress_drop,ruptured_area\n"),
            std::string::npos);
  EXPECT_NE(text.find(",0,0,5,nan,nan,nan,2\n"), std::string::npos);
}
