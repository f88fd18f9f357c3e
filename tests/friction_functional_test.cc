// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/fault_friction.h>
#include <stickslip/friction/rate_and_state.h>

#include <cmath>

#include "friction_newton.h"

using namespace StickSlip;
using Reference::epsilon;
using Reference::LogUniform;
using Reference::Real;

namespace
{
  std::vector<std::shared_ptr<const FrictionLaw>>
  two_laws()
  {
    RateAndStateParameters strong;
    strong.a                  = 0.02;
    strong.reference_friction = 0.7;
    return {std::make_shared<RateAndStateLaw>(RateAndStateParameters(),
                                              Regularisation::truncated),
            std::make_shared<RateAndStateLaw>(strong, Regularisation::arcsinh)};
  }

  const std::vector<double> weights{0.1, 0.2, 0.1, 0.05, 0.3, 1.};
  const std::vector<double> normal_stresses{5e4, 4e4, 1e3, 0., 1e6, 3e4};

  /**
   * Six nodes of two faults with different laws, theta over sixteen decades.
   */
  template <int dim>
  FaultFriction<dim>
  example()
  {
    FaultFriction<dim> friction({2, 3, 7, 8, 11, 20},
                                weights,
                                normal_stresses,
                                two_laws(),
                                {0, 1, 1, 0, 0, 1});
    friction.set_state({-18., 0., 18., 1., 4., -3.});
    return friction;
  }

  template <int dim>
  Tensor<1, dim>
  random_vector(std::mt19937 &engine, const double size)
  {
    std::normal_distribution<double> normal;
    Tensor<1, dim>                   v;
    for (unsigned int i = 0; i < dim; ++i)
      v[i] = normal(engine);
    return size / v.norm() * v;
  }

  template <typename Dim>
  class FaultFrictionTest : public ::testing::Test
  {};

  using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                      std::integral_constant<int, 3>>;
  TYPED_TEST_SUITE(FaultFrictionTest, Dimensions);
} // namespace



TYPED_TEST(FaultFrictionTest, ActsOnTangentialComponentsOnly)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>();
  EXPECT_EQ(friction.nodes(), (std::vector<unsigned int>{2, 3, 7, 8, 11, 20}));
  for (unsigned int i = 0; i < dim; ++i)
    EXPECT_EQ(friction.acts_on(0, i), i < dim - 1);

  Tensor<1, dim> v;
  v[dim - 1] = 3.;
  for (unsigned int k = 0; k < friction.nodes().size(); ++k)
    {
      EXPECT_EQ(friction.value(k, v), 0.);
      EXPECT_EQ(friction.gradient(k, v).norm(), 0.);
      EXPECT_EQ(friction.directional_derivative(k, v, v), 0.);
    }
  v[0] = -4.;
  EXPECT_EQ(FaultFriction<dim>::slip_rate(v), 4.);
}



TYPED_TEST(FaultFrictionTest, ValueIsLoadTimesPotential)
{
  constexpr int      dim      = TypeParam::value;
  FaultFriction<dim> friction = example<dim>();
  const auto         laws     = two_laws();
  Tensor<1, dim>     v;
  v[0] = -1e-5;
  EXPECT_EQ(friction.value(0, v),
            0.1 * 5e4 * laws[0]->potential(1e-5, laws[0]->node_data(-18.)));
  EXPECT_EQ(friction.value(2, v),
            0.1 * 1e3 * laws[1]->potential(1e-5, laws[1]->node_data(18.)));
  EXPECT_EQ(friction.law_data(5), laws[1]->node_data(-3.));

  // The stress may be lagged: the functional follows.
  friction.set_normal_stresses({1e5, 4e4, 1e3, 0., 1e6, 3e4});
  EXPECT_EQ(friction.value(0, v),
            0.1 * 1e5 * laws[0]->potential(1e-5, laws[0]->node_data(-18.)));
  EXPECT_ANY_THROW(friction.set_normal_stresses({-1., 4e4, 1e3, 0., 1e6, 3e4}));
}



TYPED_TEST(FaultFrictionTest, DerivativesAgreeWithDifferences)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>();
  std::mt19937             engine(5);
  LogUniform               random_rate(1e-30, 10.);
  unsigned int             n_smooth = 0;
  for (unsigned int i = 0; i < 300; ++i)
    for (unsigned int k = 0; k < friction.nodes().size(); ++k)
      {
        const double         V         = random_rate(engine);
        const Tensor<1, dim> v         = random_vector<dim>(engine, V);
        const double         slip_rate = FaultFriction<dim>::slip_rate(v);
        const double         h         = 1e-5 * slip_rate;
        if (!friction.is_smooth(k, v) ||
            friction.law(k).coefficient(slip_rate * (1. - 1e-4),
                                        friction.law_data(k)) == 0.)
          continue;
        ++n_smooth;

        const Tensor<1, dim> gradient  = friction.gradient(k, v);
        const Tensor<2, dim> hessian   = friction.hessian(k, v);
        const Tensor<1, dim> direction = random_vector<dim>(engine, 1.);
        EXPECT_NEAR(friction.directional_derivative(k, v, direction),
                    gradient * direction,
                    1e-14 * gradient.norm());
        const double difference = (friction.value(k, v + h * direction) -
                                   friction.value(k, v - h * direction)) /
                                  (2. * h);
        EXPECT_NEAR(difference,
                    gradient * direction,
                    1e-8 * gradient.norm() +
                      4e-11 * hessian.norm() * slip_rate);
        const Tensor<1, dim> second =
          (friction.gradient(k, v + h * direction) -
           friction.gradient(k, v - h * direction)) /
          (2. * h);
        EXPECT_LE((second - hessian * direction).norm(),
                  1e-8 * hessian.norm() + 1e-8 * gradient.norm() / slip_rate);
        EXPECT_GE(direction * (hessian * direction), 0.);
        EXPECT_LE((hessian - transpose(hessian)).norm(),
                  1e-15 * hessian.norm());
      }
  EXPECT_GT(n_smooth, 500u);
}



TYPED_TEST(FaultFrictionTest, SecantTakesUpTheForceAlongSlip)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>();
  std::mt19937             engine(7);
  LogUniform               random_rate(1e-12, 1.);
  unsigned int             n_compared = 0;
  for (unsigned int i = 0; i < 300; ++i)
    for (unsigned int k = 0; k < friction.nodes().size(); ++k)
      {
        Tensor<1, dim> v = random_vector<dim>(engine, random_rate(engine));
        v[dim - 1]       = 0.;
        const Tensor<1, dim> gradient = friction.gradient(k, v);
        const Tensor<2, dim> hessian  = friction.hessian(k, v);
        EXPECT_EQ(friction.secant_hessian(k, v, Tensor<1, dim>()), hessian);
        if (gradient.norm() == 0.)
          continue;

        // A force along the slip and some across it, which does not matter.
        const double         fraction = (i % 2) ? 0.1 : -0.1;
        const Tensor<1, dim> aside    = random_vector<dim>(engine, 1.);
        const Tensor<1, dim> slip     = v / v.norm();
        const Tensor<1, dim> force =
          fraction * gradient +
          gradient.norm() * (aside - (aside * slip) * slip);
        const Tensor<2, dim> secant = friction.secant_hessian(k, v, force);
        const Tensor<1, dim> change =
          (fraction * gradient.norm() / (slip * (secant * slip))) * slip;
        // Near Vmin the logarithm does not go on.
        if (friction.gradient(k, v + change).norm() == 0.)
          continue;
        ++n_compared;
        EXPECT_LE((friction.gradient(k, v + change) -
                   (1. + fraction) * gradient)
                    .norm(),
                  1e-9 * gradient.norm());
        EXPECT_LE((secant - hessian -
                   (slip * ((secant - hessian) * slip)) *
                     outer_product(slip, slip))
                    .norm(),
                  1e-12 * hessian.norm());
      }
  EXPECT_GT(n_compared, 300u);
}



TYPED_TEST(FaultFrictionTest, IsConvexAlongLines)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>();
  std::mt19937             engine(6);
  LogUniform               random_rate(1e-20, 10.);
  for (unsigned int i = 0; i < 300; ++i)
    for (unsigned int k = 0; k < friction.nodes().size(); ++k)
      {
        const Tensor<1, dim> v0 =
          random_vector<dim>(engine, random_rate(engine));
        const Tensor<1, dim> v1 =
          random_vector<dim>(engine, random_rate(engine));
        const double f0 = friction.value(k, v0), f1 = friction.value(k, v1);
        const double rounding = 1e-12 * (f0 + f1);
        EXPECT_LE(friction.value(k, 0.5 * (v0 + v1)),
                  0.5 * (f0 + f1) + rounding);
        EXPECT_GE(f1,
                  f0 + friction.directional_derivative(k, v0, v1 - v0) -
                    rounding);
      }
}



TYPED_TEST(FaultFrictionTest, SmoothnessFollowsTheLaw)
{
  constexpr int            dim      = TypeParam::value;
  const FaultFriction<dim> friction = example<dim>();
  Tensor<1, dim>           v;
  v[dim - 1] = 1.;
  // Node 0 has the truncated law, node 1 the other.
  EXPECT_FALSE(friction.is_smooth(0, v));
  EXPECT_TRUE(friction.is_smooth(1, v));
  const double vmin = std::exp(friction.law_data(0));
  v[0]              = 0.999 * vmin;
  EXPECT_FALSE(friction.is_smooth(0, v));
  v[0] = -1.001 * vmin;
  EXPECT_TRUE(friction.is_smooth(0, v));
}



TYPED_TEST(FaultFrictionTest, MinimiserAgreesWithHighPrecisionForAnyMask)
{
  constexpr int                    dim      = TypeParam::value;
  const FaultFriction<dim>         friction = example<dim>();
  std::mt19937                     engine(7);
  LogUniform                       random_rate(1e-30, 10.);
  LogUniform                       random_size(1e2, 1e12);
  std::normal_distribution<double> normal;
  double                           largest = 0.;
  for (unsigned int i = 0; i < 40; ++i)
    for (unsigned int k = 0; k < friction.nodes().size(); ++k)
      for (unsigned int mask = 0; mask < (1u << dim); ++mask)
        {
          std::array<bool, dim> active;
          for (unsigned int c = 0; c < dim; ++c)
            active[c] = (mask >> c) & 1u;

          Tensor<2, dim> factor, A;
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = 0; b < dim; ++b)
              factor[a][b] = normal(engine);
          A = factor * transpose(factor);
          for (unsigned int a = 0; a < dim; ++a)
            A[a][a] += 1.;
          A *= random_size(engine);

          // A right hand side that belongs to a slip rate of any size.
          const auto &law =
            dynamic_cast<const RateAndStateLaw &>(friction.law(k));
          const Tensor<1, dim> start =
            random_vector<dim>(engine, random_rate(engine));
          Tensor<1, dim> target =
            random_vector<dim>(engine, random_rate(engine));
          for (unsigned int c = 0; c < dim; ++c)
            if (!active[c])
              target[c] = start[c];
          Tensor<1, dim> r = friction.gradient(k, target);
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = 0; b < dim; ++b)
              if (active[b])
                r[a] += A[a][b] * target[b];

          const Tensor<1, dim> v = friction.minimise(k, A, r, active, start);
          for (unsigned int c = 0; c < dim; ++c)
            if (!active[c])
              {
                EXPECT_EQ(v[c], start[c]);
              }
          if (mask == 0)
            continue;

          Reference::Vector<dim> exact;
          for (unsigned int c = 0; c < dim; ++c)
            exact[c] = v[c];
          const Real load = Real(weights[k] * normal_stresses[k]);
          ASSERT_LT(Reference::polish<dim>(law.get_regularisation(),
                                           A,
                                           r,
                                           load * law.get_parameters().a,
                                           friction.law_data(k),
                                           dim - 1,
                                           active,
                                           exact),
                    1e-35);

          // Forming the problem of the tangential part and solving it rounds
          // the forces; what that does to v is the inverse of the Hessian.
          Tensor<2, dim> hessian = A + friction.hessian(k, v);
          double         forces  = 0.;
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = 0; b < dim; ++b)
              {
                if (active[a] && active[b])
                  forces += std::abs(A[a][b] * v[b]);
                else
                  hessian[a][b] = (a == b) ? 1. : 0.;
              }
          forces += r.norm();
          // The tangential part alone is often many decades smaller than the
          // normal one, so look at both.
          const Tensor<2, dim> inverse = invert(hessian);
          for (const unsigned int first : {0, dim - 1})
            {
              const unsigned int last  = (first == 0) ? dim - 1 : dim;
              Real               error = 0;
              double             bound = 0.;
              for (unsigned int c = first; c < last; ++c)
                {
                  error += (exact[c] - v[c]) * (exact[c] - v[c]);
                  bound += std::abs(v[c]);
                  for (unsigned int d = 0; d < dim; ++d)
                    if (active[c] && active[d])
                      bound += std::abs(inverse[c][d]) * forces;
                }
              const double scaled = static_cast<double>(sqrt(error)) / bound;
              EXPECT_LT(scaled, 100. * epsilon)
                << "mask " << mask << ", node " << k << ", component " << first;
              largest = std::max(largest, scaled);
            }
        }
  this->RecordProperty("largest_error_in_epsilon",
                       std::to_string(largest / epsilon));
}



TYPED_TEST(FaultFrictionTest, DampingIsAMatrixMore)
{
  constexpr int                    dim    = TypeParam::value;
  const FaultFriction<dim>         plain  = example<dim>();
  FaultFriction<dim>               damped = example<dim>();
  const std::vector<double>        damping{0., 2e5, 3e4, 1e5, 7., 4e6};
  std::mt19937                     engine(9);
  LogUniform                       random_rate(1e-12, 10.);
  std::normal_distribution<double> normal;
  damped.set_damping(damping);
  for (unsigned int i = 0; i < 50; ++i)
    for (unsigned int k = 0; k < plain.nodes().size(); ++k)
      {
        Tensor<2, dim> D, A;
        for (unsigned int c = 0; c < dim - 1; ++c)
          D[c][c] = weights[k] * damping[k];
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            A[a][b] = A[b][a] = a == b ? 1e6 : 1e5 * std::tanh(normal(engine));

        const Tensor<1, dim> v =
                               random_vector<dim>(engine, random_rate(engine)),
                             direction = random_vector<dim>(engine, 1.),
                             force     = random_vector<dim>(engine, 1e3);
        const auto close = [](const double ours, const double theirs) {
          EXPECT_NEAR(ours, theirs, 1e-12 * std::abs(theirs));
        };
        close(damped.value(k, v), plain.value(k, v) + 0.5 * (v * (D * v)));
        EXPECT_LE((damped.gradient(k, v) - plain.gradient(k, v) - D * v).norm(),
                  1e-12 * damped.gradient(k, v).norm());
        EXPECT_NEAR(damped.directional_derivative(k, v, direction),
                    damped.gradient(k, v) * direction,
                    1e-12 * damped.gradient(k, v).norm());
        EXPECT_LE((damped.hessian(k, v) - plain.hessian(k, v) - D).norm(),
                  1e-12 * damped.hessian(k, v).norm());
        EXPECT_LE((damped.secant_hessian(k, v, force) -
                   plain.secant_hessian(k, v, force) - D)
                    .norm(),
                  1e-12 * damped.secant_hessian(k, v, force).norm());
        for (unsigned int mask = 1; mask < (1u << dim); ++mask)
          {
            std::array<bool, dim> active;
            for (unsigned int c = 0; c < dim; ++c)
              active[c] = (mask >> c) & 1u;
            // The force of other nodes is already in the right hand side.
            const Tensor<1, dim> expected =
              plain.minimise(k, A + D, force, active, v);
            EXPECT_LE(
              (damped.minimise(k, A, force, active, v) - expected).norm(),
              1e-10 * expected.norm());
          }
      }
}



TYPED_TEST(FaultFrictionTest, ExtremeValuesAreHarmless)
{
  constexpr int      dim      = TypeParam::value;
  FaultFriction<dim> friction = example<dim>();
  friction.set_state({-700., -700., 700., 700., -40., 40.});
  for (unsigned int k = 0; k < friction.nodes().size(); ++k)
    for (const double size : {0., 1e-300, 1e-160, 1e-30, 1., 1e3})
      {
        Tensor<1, dim> v, direction;
        v[0]               = size;
        direction[0]       = 1.;
        direction[dim - 2] = -0.5;
        EXPECT_TRUE(std::isfinite(friction.value(k, v)));
        EXPECT_TRUE(std::isfinite(friction.gradient(k, v).norm()));
        EXPECT_TRUE(
          std::isfinite(friction.directional_derivative(k, v, direction)));
        const Tensor<2, dim> hessian = friction.hessian(k, v);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            EXPECT_TRUE(std::isfinite(hessian[i][j]));
      }
}
