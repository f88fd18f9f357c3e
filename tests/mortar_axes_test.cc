// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/mortar/fault_axes.h>

#include "mortar_curves.h"

using namespace StickSlip;

namespace
{
  template <int dim>
  void
  expect_frame(const FaultAxes<dim> &axes, const unsigned int k)
  {
    const Tensor<2, dim> R = axes.at(k);
    EXPECT_NEAR(determinant(R), 1., 1e-14);
    EXPECT_LT((transpose(R) * R - unit_symmetric_tensor<dim>()).norm(), 1e-14);
    for (unsigned int d = 0; d < dim; ++d)
      EXPECT_EQ(R[d][dim - 1], axes.normal(k)[d]);
  }
} // namespace



TEST(FaultAxes, OfALevelFaultAreThoseOfSpace)
{
  for (const double sign : {-1., 1.})
    {
      const FaultAxes<2> two({Tensor<1, 2>({0., sign})});
      const FaultAxes<3> three({Tensor<1, 3>({0., 0., sign})});
      EXPECT_TRUE(two.are_those_of_space());
      EXPECT_TRUE(three.are_those_of_space());
      EXPECT_EQ(two.at(5), (Tensor<2, 2>(unit_symmetric_tensor<2>())));
      EXPECT_EQ(two.normal(5)[1], sign);
      EXPECT_EQ(two.normal_part(5, Tensor<1, 2>({7., 3.})), 3. * sign);
      EXPECT_EQ(three.normal_part(5, Tensor<1, 3>({7., 5., 3.})), 3. * sign);
    }
}



TEST(FaultAxes, InTwoDimensionsTheTangentIsRightOfTheNormal)
{
  std::vector<Tensor<1, 2>> normals;
  for (unsigned int i = 0; i < 12; ++i)
    normals.push_back(Tensor<1, 2>({std::cos(0.5 * i), std::sin(0.5 * i)}));
  const FaultAxes<2> axes(normals);
  EXPECT_FALSE(axes.are_those_of_space());
  for (unsigned int k = 0; k < 12; ++k)
    {
      expect_frame(axes, k);
      EXPECT_EQ(axes.at(k)[0][0], normals[k][1]);
      EXPECT_EQ(axes.at(k)[1][0], -normals[k][0]);
      EXPECT_EQ(axes.normal_part(k, Tensor<1, 2>({7., 3.})), 3.);
    }

  const FaultAxes<2> some = axes.at_places({7, 2});
  EXPECT_EQ(some.at(0), axes.at(7));
  EXPECT_EQ(some.at(1), axes.at(2));
}



TEST(FaultAxes, InThreeDimensionsTheFirstOneFollowsTheReference)
{
  const Tensor<1, 3> n({0.48, -0.6, 0.64}), strike({0., 2., 0.});
  const FaultAxes<3> along_x({n}), along_strike({n}, strike);
  for (const FaultAxes<3> &axes : {along_x, along_strike})
    expect_frame(axes, 4);
  // No component along the second axis.
  double across_x = 0., across_strike = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    {
      across_x += (d == 0) * along_x.at(0)[d][1];
      across_strike += (d == 1) * along_strike.at(0)[d][1];
    }
  EXPECT_NEAR(across_x, 0., 1e-16);
  EXPECT_NEAR(across_strike, 0., 1e-16);
  EXPECT_GT(along_x.at(0)[0][0], 0.);
  EXPECT_GT(along_strike.at(0)[1][0], 0.);
  // Nearly level: as on a level fault.
  Tensor<1, 3> up({1e-6, 0., 1.});
  up /= up.norm();
  EXPECT_LT((FaultAxes<3>({up}).at(0) - unit_symmetric_tensor<3>()).norm(),
            2e-6);
}



TEST(FaultAxes, ReferencesThatAreNearlyNormalAreRefused)
{
  for (const double degrees : {0., 14.9, 15.1, 164.9, 165.1, 180.})
    {
      const double       angle = degrees * numbers::PI / 180.;
      const Tensor<1, 3> n({std::cos(angle), 0., std::sin(angle)});
      if (degrees > 15. && degrees < 165.)
        EXPECT_NO_THROW(FaultAxes<3>({n}));
      else
        EXPECT_THROW(FaultAxes<3>({n}), InputError);
    }
}



TEST(NodalNormals, AreExactOnCircles)
{
  std::mt19937        random(3);
  std::vector<double> angles =
    random_breakpoints(23, 0., 2. * numbers::PI, random);
  angles.pop_back();
  const Side<2> side = curve(
    angles,
    [](const double s) { return Point<2>(3. * std::cos(s), 3. * std::sin(s)); },
    true);
  const auto normals = nodal_normals(side.surface);
  ASSERT_EQ(normals.size(), angles.size());
  for (unsigned int p = 0; p < angles.size(); ++p)
    EXPECT_LT((normals[p] + side.positions[p] / 3.).norm(), 1e-13);
}



TEST(NodalNormals, OfASineAreOfSecondOrder)
{
  constexpr double    A = 0.05, k = 2. * numbers::PI;
  std::vector<double> inside, at_ends;
  for (const unsigned int n : {32, 64, 128, 256})
    {
      std::vector<double> x = uniform_breakpoints(n, 0.1, 1.3);
      // Faces of different sizes next to each other.
      for (unsigned int i = 1; i < n; i += 2)
        x[i] += 0.25 * 1.2 / n;
      const auto side    = curve(x, [](const double s) {
        return Point<2>(s, A * std::sin(k * s));
      });
      const auto normals = nodal_normals(side.surface);
      inside.push_back(0.);
      at_ends.push_back(0.);
      for (unsigned int p = 0; p <= n; ++p)
        {
          Tensor<1, 2> exact({-A * k * std::cos(k * x[p]), 1.});
          exact /= exact.norm();
          double &error = p == 0 || p == n ? at_ends.back() : inside.back();
          error         = std::max(error, (normals[p] - exact).norm());
        }
    }
  EXPECT_GT(std::log2(inside[2] / inside[3]), 1.95);
  EXPECT_GT(std::log2(at_ends[2] / at_ends[3]), 1.9);
  EXPECT_LT(inside[1], 1e-3);
  EXPECT_LT(at_ends[1], 3e-3);
}



TEST(NodalNormals, OfACurvedSurfaceAreOfSecondOrder)
{
  for (const bool of_triangles : {false, true})
    {
      std::vector<double> errors;
      for (const unsigned int n : {16, 32, 64})
        {
          std::vector<double> a = uniform_breakpoints(n, 0., 2.), b = a;
          for (unsigned int i = 1; i < n; i += 2)
            {
              a[i] += 0.25 * 2. / n;
              b[i] -= 0.2 * 2. / n;
            }
          const Side<3> side = curved_grid(
            a,
            b,
            [](const double x, const double y) {
              return Point<3>(x, y, 0.1 * std::sin(2. * x + y));
            },
            of_triangles);
          const auto normals = nodal_normals(side.surface);
          errors.push_back(0.);
          for (unsigned int p = 0; p < normals.size(); ++p)
            {
              const Point<3> &x     = side.positions[p];
              const double    slope = 0.1 * std::cos(2. * x[0] + x[1]);
              Tensor<1, 3>    exact({-2. * slope, -slope, 1.});
              exact /= exact.norm();
              errors.back() =
                std::max(errors.back(), (normals[p] - exact).norm());
            }
        }
      // Nodes at edges and corners as well.
      EXPECT_GT(std::log2(errors[1] / errors[2]), 1.85);
      EXPECT_LT(errors[1], 5e-3);
    }
}



TEST(NodalNormals, OfARowOfFacesFollowItsBend)
{
  const Side<3> side =
    curved_grid(uniform_breakpoints(20, 0., 1.),
                {0., 0.3},
                [](const double angle, const double y) {
                  return Point<3>(std::sin(angle), y, std::cos(angle));
                });
  const auto normals = nodal_normals(side.surface);
  for (unsigned int p = 0; p < normals.size(); ++p)
    EXPECT_LT((normals[p] -
               Tensor<1, 3>({side.positions[p][0], 0., side.positions[p][2]}))
                .norm(),
              p % 21 == 0 || p % 21 == 20 ? 2e-3 : 1e-13);
}
