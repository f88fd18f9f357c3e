// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/fault_friction.h>
#include <stickslip/friction/rate_and_state.h>

#include <cmath>
#include <limits>

#include "friction_newton.h"

using namespace StickSlip;
using Reference::LogUniform;
using Reference::Real;

namespace
{
  constexpr double      normal_stress = 4e4;
  const RateAndStateLaw law(RateAndStateParameters(),
                            Regularisation::truncated);

  /** Nodes that open along their axis, against it, and not at all. */
  template <int dim>
  FaultFriction<dim>
  example(const std::vector<double> &bounds)
  {
    FaultFriction<dim> friction({1, 4, 5},
                                {1., 1., 1.},
                                std::vector<double>(3, normal_stress),
                                {std::make_shared<RateAndStateLaw>(law)},
                                {0, 0, 0});
    friction.set_state({-3., 2., 0.});
    friction.set_opening({1, -1, 0});
    friction.set_opening_bounds(bounds);
    return friction;
  }

  template <typename Dim>
  class FaultOpeningTest : public ::testing::Test
  {};

  using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                      std::integral_constant<int, 3>>;
  TYPED_TEST_SUITE(FaultOpeningTest, Dimensions);
} // namespace



TYPED_TEST(FaultOpeningTest, DomainIsThatOfTheBounds)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>({-2., -3., 0.});
  EXPECT_TRUE(friction.has_bounds());
  // The least component, and the largest one.
  for (const double v_n : {-2.5, -2., -1.9, 0., 2.9, 3., 3.5})
    {
      Tensor<1, dim> v;
      v[0]       = 7.;
      v[dim - 1] = v_n;
      for (unsigned int k = 0; k < 3; ++k)
        {
          Tensor<1, dim> expected        = v;
          expected[dim - 1]              = k == 0 ? std::max(v_n, -2.) :
                                           k == 1 ? std::min(v_n, 3.) :
                                                    v_n;
          const Tensor<1, dim> projected = friction.project(k, v);
          EXPECT_EQ(projected, expected);
          const bool touches = (k == 0 && v_n <= -2.) || (k == 1 && v_n >= 3.);
          EXPECT_EQ(friction.is_at_bound(k, projected, dim - 1), touches);
          for (unsigned int c = 0; c < dim - 1; ++c)
            EXPECT_FALSE(friction.is_at_bound(k, projected, c));
        }
    }

  const FaultFriction<dim> bilateral(
    {1}, {1.}, {normal_stress}, {std::make_shared<RateAndStateLaw>(law)}, {0});
  EXPECT_FALSE(bilateral.has_bounds());
}



TYPED_TEST(FaultOpeningTest, MinimiserBalancesForcesInHighPrecision)
{
  constexpr int                    dim = TypeParam::value;
  constexpr unsigned int           n   = dim - 1;
  std::mt19937                     engine(8);
  LogUniform                       random_rate(1e-15, 10.);
  LogUniform                       random_size(1e4, 1e9);
  std::normal_distribution<double> normal;
  unsigned int                     n_open = 0, n_closed = 0;
  for (unsigned int i = 0; i < 200; ++i)
    {
      const double       gap_rate = (i % 3 == 0) ? 0. : -random_rate(engine);
      FaultFriction<dim> friction = example<dim>({gap_rate, gap_rate, 0.});
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int mask = 1u << n; mask < (1u << dim); ++mask)
          {
            const double          sign  = (k == 0 ? 1. : -1.);
            const double          bound = sign * gap_rate;
            std::array<bool, dim> active;
            Tensor<2, dim>        factor, A;
            Tensor<1, dim>        r, start;
            for (unsigned int a = 0; a < dim; ++a)
              {
                active[a] = (mask >> a) & 1u;
                start[a]  = (a + i) % 2 == 0 ? normal(engine) : 0.;
                for (unsigned int b = 0; b < dim; ++b)
                  factor[a][b] = normal(engine);
              }
            if (i % 2 == 0)
              start[n] = bound;
            A = factor * transpose(factor);
            for (unsigned int a = 0; a < dim; ++a)
              A[a][a] += 1.;
            A *= random_size(engine);
            for (unsigned int a = 0; a < dim; ++a)
              r[a] = 2. * normal_stress * normal(engine);

            const Tensor<1, dim> v = friction.minimise(k, A, r, active, start);
            EXPECT_GE(sign * (v[n] - bound), 0.);
            for (unsigned int c = 0; c < dim; ++c)
              if (!active[c])
                {
                  EXPECT_EQ(v[c], start[c]);
                }

            // Sides that touch have a given normal component.
            const bool            touches = friction.is_at_bound(k, v, n);
            std::array<bool, dim> free    = active;
            Tensor<1, dim>        load    = r;
            if (touches)
              {
                free[n] = false;
                for (unsigned int c = 0; c < dim; ++c)
                  load[c] -= A[c][n] * bound;
              }
            Reference::Vector<dim> exact;
            for (unsigned int c = 0; c < dim; ++c)
              exact[c] = v[c];
            Real exact_load_n = Real(r[n]) - Real(A[n][n]) * Real(bound);
            // Nothing is left to solve where all is given.
            if (std::any_of(free.begin(), free.end(), [](const bool f) {
                  return f;
                }))
              {
                ASSERT_LT(Reference::polish<dim>(law.get_regularisation(),
                                                 A,
                                                 load,
                                                 Real(normal_stress) *
                                                   law.get_parameters().a,
                                                 friction.law_data(k),
                                                 dim - 1,
                                                 free,
                                                 exact),
                          1e-35);
              }
            double size = 0.;
            for (unsigned int c = 0; c < dim; ++c)
              size += std::abs(v[c]);
            for (unsigned int c = 0; c < dim; ++c)
              EXPECT_LE(std::abs(double(exact[c]) - v[c]), 1e-11 * size);
            if (touches)
              {
                // The force that is left presses against the bound.
                Real force = exact_load_n;
                for (unsigned int c = 0; c < n; ++c)
                  if (active[c])
                    force -= A[n][c] * exact[c];
                EXPECT_LE(double(sign * force), 1e-11 * r.norm());
                ++n_closed;
              }
            else
              ++n_open;
          }
    }
  EXPECT_GT(n_open, 200u);
  EXPECT_GT(n_closed, 200u);
}



TYPED_TEST(FaultOpeningTest, NodesThatCannotOpenAreAsWithoutBounds)
{
  constexpr int      dim       = TypeParam::value;
  FaultFriction<dim> friction  = example<dim>({0., 0., 0.});
  FaultFriction<dim> bilateral = friction;
  bilateral.set_opening({0, 0, 0});
  std::mt19937                     engine(9);
  std::normal_distribution<double> normal;
  for (unsigned int i = 0; i < 100; ++i)
    {
      Tensor<2, dim>        factor;
      Tensor<1, dim>        r, start;
      std::array<bool, dim> active;
      for (unsigned int a = 0; a < dim; ++a)
        {
          active[a] = (i >> a) & 1u;
          r[a]      = 1e5 * normal(engine);
          start[a]  = normal(engine);
          for (unsigned int b = 0; b < dim; ++b)
            factor[a][b] = 1e3 * normal(engine);
        }
      const Tensor<2, dim> A =
        factor * transpose(factor) + 1e5 * unit_symmetric_tensor<dim>();
      EXPECT_EQ(friction.minimise(2, A, r, active, start),
                bilateral.minimise(2, A, r, active, start));
      // Nor does the bound matter to a node whose normal component is given.
      active[dim - 1] = false;
      EXPECT_EQ(friction.minimise(0, A, r, active, start),
                bilateral.minimise(0, A, r, active, start));
    }
}
