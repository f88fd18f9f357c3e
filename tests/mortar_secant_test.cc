// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mortar/moved_surface.h>
#include <stickslip/mortar/secant_axes.h>
#include <stickslip/mortar/side_gaps.h>

#include "mortar_curves.h"

using namespace StickSlip;

namespace
{
  constexpr double radius = 2.;



  /** An arc of a circle, by angles from its top; the normal is outwards. */
  Side<2>
  arc(const std::vector<double> &angles, const double r = radius)
  {
    return curve(angles, [r](const double angle) {
      return Point<2>(r * std::sin(angle), r * std::cos(angle));
    });
  }



  std::vector<double>
  angles(const unsigned int n, const double reach = 0.6)
  {
    std::vector<double> result;
    for (unsigned int i = 0; i <= n; ++i)
      // Faces of different sizes next to each other.
      result.push_back(reach * (2. * i / n - 1.) +
                       (i > 0 && i < n ? 0.1 * reach / n * (i % 2) : 0.));
    return result;
  }



  template <int dim>
  FaultDisplacement<dim>
  no_displacement(const Side<dim> &slave, const Side<dim> &master)
  {
    return {std::vector<Tensor<1, dim>>(slave.positions.size()),
            std::vector<Tensor<1, dim>>(master.positions.size())};
  }



  /** The nodes that are not next to an end. */
  bool
  is_inside(const Point<2> &x)
  {
    return std::abs(std::atan2(x[0], x[1])) < 0.45;
  }



  template <int dim>
  double
  largest_gap_error(const Side<dim> &slave,
                    const Side<dim> &master,
                    const double     expected)
  {
    const std::vector<double> gaps  = side_gaps(slave.surface,
                                               slave.positions,
                                               master.surface,
                                               master.positions);
    double                    error = 0.;
    for (unsigned int k = 0; k < gaps.size(); ++k)
      if (std::isnan(gaps[k]))
        ADD_FAILURE() << "node " << k << " has no gap";
      else
        error = std::max(error, std::abs(gaps[k] - expected));
    return error;
  }
} // namespace



TEST(SideGaps, AreThoseOfTheCurvesNotOfTheirChords)
{
  // The chords are up to h^2/8R = 2.3e-3 and 9e-4 m off the circle.
  std::vector<double> errors;
  for (const unsigned int refinement : {1, 2, 4})
    {
      Side<2>       master = arc(angles(8 * refinement, 0.7));
      const Side<2> slave  = arc(angles(13 * refinement));
      master.surface       = reversed(master.surface);
      errors.push_back(largest_gap_error(slave, master, 0.));
    }
  EXPECT_LT(errors[0], 3e-5);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 2.8);
}



TEST(SideGaps, ArePositiveWhereTheSlaveReachesIntoTheMaster)
{
  Side<2> master = arc(angles(32, 0.7), radius - 0.01);
  master.surface = reversed(master.surface);
  EXPECT_LT(largest_gap_error(arc(angles(52)), master, 0.01), 1e-5);
}



TEST(SecantAxes, AreAlongTheChordOfACircle)
{
  Side<2> master      = arc(angles(40, 0.7));
  master.surface      = reversed(master.surface);
  const Side<2> slave = arc(angles(52));
  for (const bool slave_is_second : {true, false})
    for (const double slip : {0.02, -0.01})
      {
        const FaultSides sides = {slave_is_second ? 1u : 0u,
                                  slave_is_second ? 0u : 1u};
        const auto displacement = no_displacement(slave, master);
        const std::vector<Tensor<1, 1>> slips(slave.positions.size(),
                                              Tensor<1, 1>({slip}));
        const auto                      still = secant_coupling(
          slave.surface, master.surface, sides, displacement, {}, 0.);
        const auto moving = secant_coupling(slave.surface,
                                            master.surface,
                                            sides,
                                            displacement,
                                            slips,
                                            std::abs(slip));
        EXPECT_LT(still.gap.absolute, 2e-6);
        EXPECT_EQ(moving.gap.absolute, still.gap.absolute);
        for (unsigned int k = 0; k < slave.positions.size(); ++k)
          if (is_inside(slave.positions[k]))
            {
              const Tensor<1, 2> n    = slave.positions[k] / radius;
              const double       sign = slave_is_second ? -1. : 1.;
              EXPECT_LT((still.axes.normal(k) - sign * n).norm(), 2e-4);
              // The end is where the other side is, on the circle: slid along
              // the tangent, and back to the circle along the normal.
              const Tensor<2, 2> axes = still.axes.at(k);
              const Tensor<1, 2> tangent({axes[0][0], axes[1][0]});
              Point<2>           end = slave.positions[k] + slip * tangent;
              end *= radius / end.norm();
              Tensor<1, 2> chord = (end - slave.positions[k]) / slip;
              chord /= chord.norm();
              const Tensor<2, 2> turned = moving.axes.at(k);
              EXPECT_LT(
                (Tensor<1, 2>({turned[0][0], turned[1][0]}) - chord).norm(),
                1e-3 * std::abs(slip) / 0.02);
              // The tangent has turned by half of the angle slid over.
              EXPECT_NEAR((tangent - chord).norm(),
                          0.5 * std::abs(slip) / radius,
                          2e-5);
              EXPECT_LT(
                (moving.displacement.slave[k] - 0.5 * slip * tangent).norm(),
                1e-15);
            }
      }
}



TEST(SecantAxes, TiltAlongTheSlipOnACylinder)
{
  // Slip along the axis of the cylinder meets no curvature, oblique slip that
  // of its direction.
  const auto position = [](const double angle, const double y) {
    return Point<3>(radius * std::sin(angle), y, radius * std::cos(angle));
  };
  for (const bool of_triangles : {false, true})
    for (const double direction : {0., 40., 90., 200.})
      {
        const double beta      = direction * numbers::PI / 180.;
        Side<3>      master    = curved_grid(uniform_breakpoints(28, -0.7, 0.7),
                                     uniform_breakpoints(14, -0.7, 0.7),
                                     position,
                                     of_triangles);
        master.surface         = reversed(master.surface);
        const Side<3>    slave = curved_grid(uniform_breakpoints(30, -0.6, 0.6),
                                          uniform_breakpoints(17, -0.6, 0.6),
                                          position,
                                          of_triangles);
        const FaultSides sides = {0, 1};
        const auto       displacement = no_displacement(slave, master);
        constexpr double slip         = 0.02;
        // The second axis, normal times x, is against y.
        const std::vector<Tensor<1, 2>> slips(
          slave.positions.size(),
          slip * Tensor<1, 2>({std::cos(beta), std::sin(beta)}));
        const auto still = secant_coupling(
          slave.surface, master.surface, sides, displacement, {}, 0.);
        const auto moving = secant_coupling(
          slave.surface, master.surface, sides, displacement, slips, slip);
        const double curvature = std::cos(beta) * std::cos(beta) / radius;
        EXPECT_LT(still.gap.absolute, 3e-5);
        for (unsigned int k = 0; k < slave.positions.size(); ++k)
          if (std::abs(slave.positions[k][0]) < 0.8 &&
              std::abs(slave.positions[k][1]) < 0.45)
            {
              const Tensor<2, 3> axes = still.axes.at(k);
              Tensor<1, 3>       along, across;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  along[d] =
                    std::cos(beta) * axes[d][0] + std::sin(beta) * axes[d][1];
                  across[d] =
                    std::cos(beta) * axes[d][1] - std::sin(beta) * axes[d][0];
                }
              const Tensor<1, 3> tilt =
                moving.axes.normal(k) - still.axes.normal(k);
              EXPECT_NEAR(tilt * along, 0.5 * curvature * slip, 4e-4);
              EXPECT_NEAR(tilt * across, 0., 1e-10);
            }
      }
}



TEST(SecantAxes, KeepTheAxisOfReference)
{
  const auto position = [](const double angle, const double y) {
    return Point<3>(radius * std::cos(angle), y, radius * std::sin(angle));
  };
  // Normal to x in the middle.
  const std::vector<double> angles = uniform_breakpoints(20, -0.4, 0.4),
                            ways   = uniform_breakpoints(8, -0.5, 0.5);
  const Side<3> slave              = curved_grid(angles, ways, position);
  Side<3>       master             = slave;
  master.surface                   = reversed(master.surface);
  const Tensor<1, 3> y({0., 1., 0.});
  for (const double slip : {0., 0.02})
    {
      const FaultAxes<3> axes =
        secant_coupling(slave.surface,
                        master.surface,
                        {0, 1},
                        no_displacement(slave, master),
                        std::vector<Tensor<1, 2>>(slave.positions.size(),
                                                  Tensor<1, 2>({0., slip})),
                        slip,
                        y)
          .axes;
      for (unsigned int k = 0; k < slave.positions.size(); ++k)
        {
          const Tensor<2, 3> at = axes.at(k);
          EXPECT_LT((Tensor<1, 3>({at[0][0], at[1][0], at[2][0]}) - y).norm(),
                    1e-12);
        }
    }
}



TEST(SecantAxes, OfStuckNodesDoNotTilt)
{
  Side<2> master                = arc(angles(40, 0.7), radius - 0.001);
  master.surface                = reversed(master.surface);
  const Side<2>    slave        = arc(angles(52));
  const auto       displacement = no_displacement(slave, master);
  constexpr double slip         = 0.02;
  // From stuck at the left to sliding at the right.
  std::vector<Tensor<1, 1>> slips;
  for (const Point<2> &x : slave.positions)
    slips.push_back(Tensor<1, 1>({x[0] < 0. ? 0. : slip * std::min(1., x[0])}));
  const auto still = secant_coupling(
    slave.surface, master.surface, {1, 0}, displacement, {}, 0.);
  const auto moving = secant_coupling(
    slave.surface, master.surface, {1, 0}, displacement, slips, slip);
  EXPECT_NEAR(moving.gap.absolute, 0.001, 3e-6);
  for (unsigned int k = 0; k < slave.positions.size(); ++k)
    if (const Point<2> &x = slave.positions[k]; is_inside(x))
      {
        const double tilt =
          (moving.axes.normal(k) - still.axes.normal(k)).norm();
        // The gap of 1 mm closes over 0.02 m where nodes slide so far, and by
        // the square of the part that they slide elsewhere.
        const double part = slips[k][0] / slip;
        EXPECT_NEAR(tilt,
                    part == 0. ?
                      0. :
                      part * 0.001 / slip + 0.5 * slips[k][0] / radius,
                    2e-3 * part + 1e-15)
          << x[0];
      }
}



TEST(SecantAxes, DoNotTiltMoreThanATenth)
{
  Side<2> master      = arc(angles(40, 0.7), radius - 0.01);
  master.surface      = reversed(master.surface);
  const Side<2> slave = arc(angles(52));
  const auto    axes =
    secant_coupling(slave.surface,
                    master.surface,
                    {1, 0},
                    no_displacement(slave, master),
                    std::vector<Tensor<1, 1>>(slave.positions.size(),
                                              Tensor<1, 1>({0.01})),
                    0.01)
      .axes;
  for (unsigned int k = 0; k < slave.positions.size(); ++k)
    if (is_inside(slave.positions[k]))
      {
        EXPECT_NEAR(std::tan(std::acos(
                      std::abs(axes.normal(k) * slave.positions[k]) / radius)),
                    largest_tilt,
                    1e-3);
      }
}



TEST(MovedSurface, HasTheNormalsWhereItIs)
{
  const Side<2>         side    = arc(angles(7));
  const Tensor<2, 2>    R       = rotation_by(0.8);
  const Side<2>         there   = moved(side, R, Tensor<1, 2>({3., -1.}));
  const FaultSurface<2> surface = moved_surface(side.surface, there.positions);
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    EXPECT_LT((surface.normal_of(f) - there.surface.normal_of(f)).norm(),
              1e-15);
  EXPECT_LT((surface.points.back() - there.positions.back()).norm(), 1e-15);

  // One that was plane can bend.
  Side<2> straight = line({0., 1., 2.});
  straight.positions[1][1] += 0.1;
  EXPECT_FALSE(moved_surface(straight.surface, straight.positions).is_plane());
  std::swap(straight.positions[0], straight.positions[1]);
  EXPECT_THROW(moved_surface(straight.surface, straight.positions),
               std::exception);
}
