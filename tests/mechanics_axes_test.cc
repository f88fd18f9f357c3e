// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/mechanics/side_axes.h>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  template <int dim>
  Tensor<1, dim>
  unit(const Tensor<1, dim> &vector)
  {
    return vector / vector.norm();
  }



  /** Axes are orthonormal, with the last ones in the span of the directions. */
  template <int dim>
  void
  expect_axes(const NodeConstraint<dim>         &constraint,
              const std::vector<Tensor<1, dim>> &directions)
  {
    const Tensor<2, dim> axes     = constraint.axes();
    const Tensor<2, dim> products = transpose(axes) * axes;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        EXPECT_NEAR(products[c][d], c == d ? 1. : 0., 1e-15);
    for (const Tensor<1, dim> &direction : directions)
      for (unsigned int c = 0; c + constraint.size() < dim; ++c)
        EXPECT_NEAR((transpose(axes) * direction)[c], 0., 1e-15);
  }
} // namespace



TEST(NodeConstraint, KeepsWhatIsNotPrescribed)
{
  NodeConstraint<2>  constraint;
  const Tensor<1, 2> n = unit(Tensor<1, 2>({3., 4.}));
  EXPECT_TRUE(constraint.add(n));
  expect_axes(constraint, {n});
  const Tensor<1, 2> u({0.3, -2.}), t({4. / 5., -3. / 5.});
  const Tensor<1, 2> v = constraint.impose(u, {{7., 0.}});
  EXPECT_NEAR(v * n, 7., 1e-14);
  EXPECT_NEAR(v * t, u * t, 1e-14);
}



TEST(NodeConstraint, DirectionsNeedNotBeOrthogonal)
{
  const std::vector<Tensor<1, 3>> directions = {
    unit(Tensor<1, 3>({1., 2., -1.})),
    unit(Tensor<1, 3>({1., 1., 0.5})),
    unit(Tensor<1, 3>({0., 0.3, 1.}))};
  const std::array<double, 3> values = {{3., -1., 0.5}};
  const Tensor<1, 3>          u({0.1, 0.2, 0.3});
  NodeConstraint<3>           constraint;
  for (unsigned int n = 1; n <= 3; ++n)
    {
      EXPECT_TRUE(constraint.add(directions[n - 1]));
      EXPECT_EQ(constraint.size(), n);
      expect_axes(constraint, {directions.begin(), directions.begin() + n});
      const Tensor<1, 3> v = constraint.impose(u, values);
      for (unsigned int k = 0; k < n; ++k)
        EXPECT_NEAR(v * directions[k], values[k], 1e-13);
      if (n == 2)
        {
          const Tensor<1, 3> edge =
            cross_product_3d(directions[0], directions[1]);
          EXPECT_NEAR(v * edge, u * edge, 1e-14);
        }
    }
  // Nothing is left to prescribe.
  EXPECT_FALSE(constraint.add(unit(Tensor<1, 3>({1., 0., 0.}))));
}



TEST(NodeConstraint, NearlyTheSameDirectionCountsOnce)
{
  NodeConstraint<2> constraint;
  EXPECT_TRUE(constraint.add(Tensor<1, 2>({0., 1.})));
  EXPECT_FALSE(constraint.add(Tensor<1, 2>({0., -1.})));
  EXPECT_FALSE(constraint.add(unit(Tensor<1, 2>({9e-4, 1.}))));
  EXPECT_EQ(constraint.size(), 1u);
  EXPECT_TRUE(constraint.add(unit(Tensor<1, 2>({1e-2, 1.}))));
}



TEST(AxesOfSide, AreThoseOfSpaceOnUpperSides)
{
  Tensor<2, 2> identity;
  identity[0][0] = identity[1][1] = 1.;
  EXPECT_EQ(axes_of_side(Tensor<1, 2>({0., 1.})), identity);
  Tensor<2, 3> identity_3d;
  for (unsigned int c = 0; c < 3; ++c)
    identity_3d[c][c] = 1.;
  EXPECT_EQ(axes_of_side(Tensor<1, 3>({0., 0., 1.})), identity_3d);
}



TEST(AxesOfSide, AreRightHandedWithTheNormalLast)
{
  const Tensor<1, 2> n    = unit(Tensor<1, 2>({-1., 3.}));
  const Tensor<2, 2> axes = axes_of_side(n);
  EXPECT_NEAR(determinant(axes), 1., 1e-15);
  for (unsigned int d = 0; d < 2; ++d)
    EXPECT_EQ(axes[d][1], n[d]);
  for (const Tensor<1, 3> &direction : {Tensor<1, 3>({1., 2., 3.}),
                                        Tensor<1, 3>({1., 0.1, 0.}),
                                        Tensor<1, 3>({-1., 0., 0.}),
                                        Tensor<1, 3>({0., -1., 0.})})
    {
      const Tensor<1, 3> n_3d = unit(direction);
      const Tensor<2, 3> R    = axes_of_side(n_3d);
      EXPECT_NEAR(determinant(R), 1., 1e-15);
      EXPECT_LT((transpose(R) * n_3d - Tensor<1, 3>({0., 0., 1.})).norm(),
                1e-15);
      // The first tangential axis is level towards x, or y.
      EXPECT_GT(std::max(R[0][0], R[1][0]), 0.25);
    }
}



TEST(AxesOfSide, BelongToPlaneSides)
{
  FaultSurface<2> side;
  side.points = {Point<2>(0., 0.), Point<2>(1., 3.), Point<2>(2., 6.)};
  side.normal = unit(Tensor<1, 2>({3., -1.}));
  EXPECT_TRUE(is_plane(side));
  side.points[1][0] += 1e-6;
  EXPECT_FALSE(is_plane(side));
}



TEST(BoundaryAxes, MaskIsAlongTheAxesOnEveryLevel)
{
  const MeshHierarchy<2> meshes(nonmatching_bodies(), MPI_COMM_WORLD);
  const auto             roller = [](const unsigned int side) {
    BoundaryCondition<2> condition;
    condition.body = "middle";
    condition.side = side;
    condition.type = {{BoundaryType::free, BoundaryType::fixed}};
    condition.axes = BoundaryAxes::side;
    return condition;
  };
  const BoundaryValues<2> boundary(meshes,
                                   {roller(0), roller(3)},
                                   {"lower", "middle", "upper"});
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    {
      const NodeMask      mask   = boundary.dirichlet_mask(l);
      const NodeFrames<2> frames = boundary.frames(l);
      for_each_node(meshes.level(l),
                    [&](const unsigned int b,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2>    &x,
                        const bool) {
                      const bool left  = (b == 1 && x[0] == -2.5);
                      const bool upper = (b == 1 && x[1] == 1.5);
                      EXPECT_EQ(mask.is_active(node, 0), !(left && upper));
                      EXPECT_EQ(mask.is_active(node, 1), !left && !upper);
                      // Components y and -x; all or none in the corner.
                      ASSERT_EQ(frames.find(node) != nullptr, left && !upper);
                      if (left && !upper)
                        {
                          const Tensor<2, 2> &R = *frames.find(node);
                          EXPECT_NEAR(R[1][0], 1., 1e-15);
                          EXPECT_NEAR(R[0][1], -1., 1e-15);
                        }
                    });
    }
}
