// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <stickslip/mechanics/boundary_values.h>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  const std::vector<std::string> names_2d = {"lower", "middle", "upper"};
  const std::vector<std::string> names_3d = {"lower", "upper"};



  template <int dim>
  BoundaryCondition<dim>
  make_condition(const std::string                   &body,
                 const unsigned int                   side,
                 const std::array<BoundaryType, dim> &type,
                 const std::array<std::string, dim>  &expression,
                 const double                         ramp_length = 0.)
  {
    BoundaryCondition<dim> condition;
    condition.body        = body;
    condition.side        = side;
    condition.type        = type;
    condition.expression  = expression;
    condition.ramp_length = ramp_length;
    return condition;
  }



  constexpr auto free_side = BoundaryType::free;
  constexpr auto fixed     = BoundaryType::fixed;
  constexpr auto velocity  = BoundaryType::velocity;
  constexpr auto traction  = BoundaryType::traction;

  constexpr unsigned int left = 0, right = 1, bottom_2d = 2, top_2d = 3;



  /** Integrals of a load and of its first moments. */
  template <int dim>
  double
  total(const MeshHierarchy<dim> &meshes,
        const NodalVector        &load,
        const unsigned int        body,
        const unsigned int        component,
        const int                 moment_axis = -1)
  {
    return load * interpolate(meshes.finest(),
                              [&](const unsigned int b, const Point<dim> &x) {
                                Tensor<1, dim> value;
                                if (b == body)
                                  value[component] =
                                    moment_axis < 0 ? 1. : x[moment_axis];
                                return value;
                              });
  }
} // namespace



TEST(SmoothRamp, IsHalfACosine)
{
  EXPECT_EQ(smooth_ramp(-1., 2.), 0.);
  EXPECT_EQ(smooth_ramp(0., 2.), 0.);
  EXPECT_NEAR(smooth_ramp(0.5, 2.), 0.5 - std::sqrt(0.125), 1e-15);
  EXPECT_NEAR(smooth_ramp(1., 2.), 0.5, 1e-15);
  EXPECT_NEAR(smooth_ramp(1.5, 2.), 0.5 + std::sqrt(0.125), 1e-15);
  EXPECT_EQ(smooth_ramp(2., 2.), 1.);
  EXPECT_EQ(smooth_ramp(100., 2.), 1.);
  // Its slope has no jump at the ends.
  EXPECT_NEAR(smooth_ramp(1e-4, 2.), 0., 1e-8);
  EXPECT_NEAR(smooth_ramp(2. - 1e-4, 2.), 1., 1e-8);
}



TEST(SmoothRamp, OfNoLengthIsOneFromTheStart)
{
  EXPECT_EQ(smooth_ramp(0., 0.), 1.);
  EXPECT_EQ(smooth_ramp(1e-9, 0.), 1.);
}



TEST(BoundaryValues, MaskIsThatOfTheSideOnEveryLevel)
{
  const MeshHierarchy<2>  meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  const BoundaryValues<2> boundary(
    meshes,
    {make_condition<2>("lower", bottom_2d, {{fixed, fixed}}, {{"0", "0"}}),
     make_condition<2>("upper", top_2d, {{velocity, free_side}}, {{"1", "0"}}),
     make_condition<2>("middle", left, {{traction, fixed}}, {{"1", "0"}}),
     make_condition<2>("lower", right, {{fixed, traction}}, {{"0", "1"}})},
    names_2d);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    {
      const NodeMask mask = boundary.dirichlet_mask(l);
      for_each_node(meshes.level(l),
                    [&](const unsigned int b,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2>    &x,
                        const bool) {
                      bool fixed_x = false, fixed_y = false;
                      if (b == 0)
                        {
                          fixed_x = x[1] == 0. || x[0] == 2.5;
                          fixed_y = x[1] == 0.;
                        }
                      else if (b == 1)
                        fixed_y = x[0] == -2.5;
                      else
                        fixed_x = std::abs(x[1] - 2.5) < 1e-12;
                      EXPECT_EQ(mask.is_active(node, 0), !fixed_x) << x;
                      EXPECT_EQ(mask.is_active(node, 1), !fixed_y) << x;
                    });
    }
}



TEST(BoundaryValues, ErrorOfLoadsThatDependOnTime)
{
  const MeshHierarchy<2> meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  const auto             error_of = [&](const BoundaryType type,
                            const std::string &expression,
                            const double       time,
                            const double       tau) {
    BoundaryValues<2> boundary(meshes,
                               {make_condition<2>("upper",
                                                  top_2d,
                                                  {{type, free_side}},
                                                  {{expression, "0"}})},
                               names_2d);
    LargestLoads<2>   largest;
    return boundary.loading_error(time, tau, largest);
  };
  for (const BoundaryType type : {velocity, traction})
    {
      // By Simpson's rule, which is exact here, over the largest value.
      const double t = 3., h = 0.5;
      EXPECT_NEAR(error_of(type, "7 * t^2", t, h),
                  (h * h / 6.) / ((t + h) * (t + h)),
                  1e-14);
      const double omega = 2.;
      EXPECT_NEAR(error_of(type, "3 * (1 + x) * cos(2 * t)", 0., 1e-3),
                  std::pow(omega * 1e-3, 2) / 12.,
                  1e-12);
      EXPECT_NEAR(error_of(type, "1 + t", t, h), 0., 1e-15);
      EXPECT_EQ(error_of(type, "tanh(x)", t, h), 0.);
      EXPECT_EQ(error_of(type, "0 * t", t, h), 0.);
    }
  EXPECT_EQ(error_of(free_side, "t^2", 1., 1.), 0.);

  // The largest value so far, so that zeros of the load cost nothing.
  BoundaryValues<2> boundary(meshes,
                             {make_condition<2>("upper",
                                                top_2d,
                                                {{velocity, free_side}},
                                                {{"cos(2 * pi * t)", "0"}})},
                             names_2d);
  LargestLoads<2>   largest;
  boundary.loading_error(0., 0.01, largest);
  EXPECT_LT(boundary.loading_error(0.245, 0.01, largest),
            std::pow(2. * numbers::PI * 0.01, 2) / 12.);
}



TEST(BoundaryValues, VelocitiesFollowRampPlaceAndTime)
{
  const MeshHierarchy<2> meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  BoundaryValues<2>      boundary(
    meshes,
    {make_condition<2>("lower", bottom_2d, {{fixed, fixed}}, {{"0", "0"}}),
          make_condition<2>("upper",
                       top_2d,
                       {{velocity, free_side}},
                       {{"2e-4 * (1 + x) * cos(t)", "7"}},
                       4.),
          make_condition<2>(
       "middle", left, {{free_side, velocity}}, {{"7", "y*t"}})},
    names_2d);
  EXPECT_EQ(boundary.longest_ramp(), 4.);

  NodalVector velocities = meshes.finest().nodes.make_vector();
  for (const double time : {0., 1., 2.5, 4., 50.})
    {
      for (unsigned int i = 0; i < velocities.locally_owned_size(); ++i)
        velocities.local_element(i) = 3.;
      boundary.set_velocities(time, velocities);
      const double ramp =
        time < 4. ? 0.5 * (1. - std::cos(numbers::PI * time / 4.)) : 1.;
      for_each_node(meshes.finest(),
                    [&](const unsigned int b,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2>    &x,
                        const bool) {
                      // What is not prescribed keeps its value.
                      Tensor<1, 2> expected({3., 3.});
                      if (b == 0 && x[1] == 0.)
                        expected = 0.;
                      if (b == 1 && x[0] == -2.5)
                        expected[1] = x[1] * time;
                      if (b == 2 && std::abs(x[1] - 2.5) < 1e-12)
                        expected[0] =
                          ramp * 2e-4 * (1. + x[0]) * std::cos(time);
                      for (unsigned int c = 0; c < 2; ++c)
                        EXPECT_NEAR(velocities.local_element(node * 2 + c),
                                    expected[c],
                                    1e-15 * (1. + std::abs(expected[c])))
                          << x;
                    });
    }
}



TEST(BoundaryValues, TractionsAddUpToTheirIntegral)
{
  const MeshHierarchy<2> meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  BoundaryValues<2>      boundary(
    meshes,
    {make_condition<2>("upper",
                       top_2d,
                       {{traction, traction}},
                       {{"1e3 * x^2", "-5e2 * t"}},
                       3.),
          make_condition<2>("middle", right, {{traction, free_side}}, {{"40", "9"}}),
          make_condition<2>("lower", bottom_2d, {{fixed, fixed}}, {{"9", "9"}})},
    names_2d);
  EXPECT_EQ(boundary.longest_ramp(), 3.);

  for (const double time : {0., 1.5, 3., 7.})
    {
      NodalVector load = meshes.finest().nodes.make_vector();
      // Adds to what is there.
      load.local_element(0) = 11.;
      boundary.add_tractions(time, load);
      EXPECT_EQ(load.local_element(0), 11.);
      load.local_element(0) = 0.;

      const double ramp =
        time < 3. ? 0.5 * (1. - std::cos(numbers::PI * time / 3.)) : 1.;
      const double x_force = ramp * 1e3 * 2. * std::pow(2.5, 3) / 3.;
      const double y_force = ramp * -5e2 * time * 5.;
      EXPECT_NEAR(total(meshes, load, 2, 0), x_force, 1e-11 * 1e4);
      EXPECT_NEAR(total(meshes, load, 2, 1), y_force, 1e-11 * 1e4);
      EXPECT_NEAR(total(meshes, load, 2, 0, 0), 0., 1e-11 * 1e4);
      EXPECT_NEAR(total(meshes, load, 2, 0, 1), 2.5 * x_force, 1e-11 * 1e4);
      // A thickness of 0.5 m between the heights 1 m and 1.5 m.
      EXPECT_NEAR(total(meshes, load, 1, 0), 20., 1e-12 * 20.);
      EXPECT_NEAR(total(meshes, load, 1, 0, 1), 20. * 1.25, 1e-12 * 20.);
      EXPECT_EQ(total(meshes, load, 1, 1), 0.);
      EXPECT_EQ(total(meshes, load, 0, 0), 0.);
      EXPECT_EQ(total(meshes, load, 0, 1), 0.);
    }
}



TEST(BoundaryValues, TractionsInThreeDimensionsPassHangingNodes)
{
  const MeshHierarchy<3> meshes(nonmatching_blocks(), MPI_COMM_WORLD);
  constexpr auto         front = 2u;
  BoundaryValues<3>      boundary(
    meshes,
    {make_condition<3>("lower",
                       front,
                       {{traction, free_side, traction}},
                       {{"8 * x * z", "0", "5"}})},
    names_3d);
  NodalVector load = meshes.finest().nodes.make_vector();
  boundary.add_tractions(0., load);

  unsigned int n_hanging = 0;
  for_each_node(meshes.finest(),
                [&](const unsigned int b,
                    const unsigned int,
                    const unsigned int node,
                    const Point<3>    &x,
                    const bool         hanging) {
                  if (hanging && b == 0 && x[1] == -2.5)
                    {
                      ++n_hanging;
                      for (unsigned int c = 0; c < 3; ++c)
                        EXPECT_EQ(load.local_element(node * 3 + c), 0.);
                    }
                });
  EXPECT_GT(n_hanging, 0u);

  // The side is 5 m wide and 3 m high, at y = -2.5 m.
  const double x2 = 2. * std::pow(2.5, 3) / 3.;
  EXPECT_NEAR(total(meshes, load, 0, 0), 0., 1e-11);
  EXPECT_NEAR(total(meshes, load, 0, 0, 0), 8. * x2 * 4.5, 1e-12 * 400.);
  EXPECT_NEAR(total(meshes, load, 0, 0, 2), 0., 1e-11);
  EXPECT_EQ(total(meshes, load, 0, 1), 0.);
  EXPECT_NEAR(total(meshes, load, 0, 2), 75., 1e-12 * 75.);
  EXPECT_NEAR(total(meshes, load, 0, 2, 0), 0., 1e-11);
  EXPECT_NEAR(total(meshes, load, 0, 2, 1), -2.5 * 75., 1e-12 * 200.);
  EXPECT_NEAR(total(meshes, load, 0, 2, 2), 1.5 * 75., 1e-12 * 200.);
}
