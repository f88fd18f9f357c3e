// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/local_problem.h>
#include <stickslip/friction/rate_and_state.h>

#include <cmath>

#include "friction_newton.h"

using namespace StickSlip;
using Reference::epsilon;
using Reference::LogUniform;
using Reference::Real;

namespace
{
  /**
   * Coulomb's law, the smallest one with a threshold. The data is the
   * coefficient.
   */
  class CoulombLaw : public FrictionLaw
  {
  public:
    double
    node_data(const double) const override
    {
      return 0.6;
    }

    double
    coefficient(const double, const double data) const override
    {
      return data;
    }

    double
    derivative(const double, const double) const override
    {
      return 0.;
    }

    double
    potential(const double V, const double data) const override
    {
      return data * V;
    }

    bool
    is_smooth(const double V, const double) const override
    {
      return V > 0.;
    }

    double
    minimiser(const double c,
              const double r,
              const double k,
              const double data) const override
    {
      return std::max(0., (r - k * data) / c);
    }
  };

  /**
   * A symmetric positive definite matrix with eigenvalues @p large and
   * @p large / @p condition.
   */
  Tensor<2, 2>
  matrix(const double large, const double condition, const double angle)
  {
    const double small = large / condition;
    const double c = std::cos(angle), s = std::sin(angle);
    Tensor<2, 2> A;
    A[0][0] = large * c * c + small * s * s;
    A[1][1] = large * s * s + small * c * c;
    A[0][1] = A[1][0] = (large - small) * c * s;
    return A;
  }

  class LocalProblem : public ::testing::TestWithParam<Regularisation>
  {
  protected:
    const RateAndStateLaw                  law{{}, GetParam()};
    std::mt19937                           engine{3};
    LogUniform                             random_theta{1e-8, 1e8};
    LogUniform                             random_rate{1e-30, 10.};
    LogUniform                             random_ratio{1e-6, 1e6};
    std::uniform_real_distribution<double> random_angle{0., 6.28};
  };

  INSTANTIATE_TEST_SUITE_P(Regularisations,
                           LocalProblem,
                           ::testing::Values(Regularisation::truncated,
                                             Regularisation::arcsinh));
} // namespace



TEST_P(LocalProblem, ScalarMinimiserIsOdd)
{
  const double data = law.node_data(0.);
  for (const double r : {1e-20, 1., 1e4})
    EXPECT_EQ(minimise_local(law, data, 3., -r, 20.),
              -law.minimiser(3., r, 20., data));
  EXPECT_EQ(minimise_local(law, data, 3., 0., 20.), 0.);
}



TEST_P(LocalProblem, VectorMinimiserAgreesWithHighPrecision)
{
  double largest = 0.;
  for (const double condition : {1., 3., 1e2, 1e5})
    for (unsigned int i = 0; i < 400; ++i)
      {
        const double       data = law.node_data(std::log(random_theta(engine)));
        const Tensor<2, 2> A =
          matrix(random_ratio(engine), condition, random_angle(engine));
        const double k     = random_ratio(engine);
        const double V     = random_rate(engine);
        const double angle = random_angle(engine);
        Tensor<1, 2> n;
        n[0]                 = std::cos(angle);
        n[1]                 = std::sin(angle);
        const Tensor<1, 2> r = V * (A * n) + k * law.coefficient(V, data) * n;

        const Tensor<1, 2>   v = minimise_local(law, data, A, r, k);
        Reference::Vector<2> exact{{v[0], v[1]}};
        ASSERT_LT(Reference::polish<2>(GetParam(),
                                       A,
                                       r,
                                       Real(k) * law.get_parameters().a,
                                       data,
                                       2,
                                       {{true, true}},
                                       exact),
                  1e-35);
        const double error =
          static_cast<double>(sqrt((exact[0] - v[0]) * (exact[0] - v[0]) +
                                   (exact[1] - v[1]) * (exact[1] - v[1])) /
                              sqrt(exact[0] * exact[0] + exact[1] * exact[1]));
        EXPECT_LT(error, 1e-13 + 4. * condition * epsilon)
          << "condition " << condition << ", V = " << V << ", k = " << k
          << ", data = " << data;
        if (condition <= 3.)
          largest = std::max(largest, error);
      }
  RecordProperty("largest_relative_error",
                 std::to_string(largest * 1e15) + "e-15");
}



TEST_P(LocalProblem, VectorMinimiserReducesToTheScalarOne)
{
  // An eigenvector as the right hand side, and the isotropic matrix.
  const double data = law.node_data(0.);
  for (const double r : {1e-12, 1., 30.})
    {
      Tensor<2, 2> A;
      A[0][0] = 2.;
      A[1][1] = 500.;
      Tensor<1, 2> load;
      load[0]              = -r;
      const Tensor<1, 2> v = minimise_local(law, data, A, load, 40.);
      EXPECT_NEAR(v[0] / minimise_local(law, data, 2., -r, 40.), 1., 1e-13);
      EXPECT_EQ(v[1], 0.);
    }
}



TEST_P(LocalProblem, BesideAPrescribedComponent)
{
  for (unsigned int i = 0; i < 800; ++i)
    {
      const double data = law.node_data(std::log(random_theta(engine)));
      const double c    = random_ratio(engine);
      const double k    = random_ratio(engine);
      const double w    = random_rate(engine) * (i % 2 == 0 ? 1. : -1.);
      const double size = random_rate(engine);
      const double V    = std::hypot(size, w);
      const double r =
        (c + k * law.coefficient(V, data) / V) * size * (i % 3 == 0 ? 1. : -1.);

      const double v = minimise_local_beside(law, data, c, r, k, w);
      Tensor<2, 2> A;
      A[0][0] = c;
      A[1][1] = 1.;
      Tensor<1, 2> load;
      load[0] = r;
      Reference::Vector<2> exact{{v, w}};
      ASSERT_LT(Reference::polish<2>(GetParam(),
                                     A,
                                     load,
                                     Real(k) * law.get_parameters().a,
                                     data,
                                     2,
                                     {{true, false}},
                                     exact),
                1e-35);
      EXPECT_LT(Reference::relative_error(v, exact[0]), 1e-13);
      EXPECT_EQ(static_cast<double>(exact[1]), w);
    }
  // Without the other component it is the scalar problem.
  EXPECT_EQ(minimise_local_beside(law, -50., 2., 3., 40., 0.),
            minimise_local(law, -50., 2., 3., 40.));
}



TEST_P(LocalProblem, ExtremeValuesAreHarmless)
{
  for (const double data : {-1500., -700., -70., 50., 720.})
    for (const double size : {1e-10, 1., 1e12})
      for (const double condition : {1., 1e3, 1e8})
        for (const double k : {-0., 0., 1e-12, 1., 1e9})
          for (const double load : {0., 1e-300, 1e-10, 1., 1e8})
            {
              const Tensor<2, 2> A = matrix(size, condition, 0.7);
              Tensor<1, 2>       r;
              r[0]                 = load;
              r[1]                 = -0.3 * load;
              const Tensor<1, 2> v = minimise_local(law, data, A, r, k);
              EXPECT_TRUE(std::isfinite(v[0]) && std::isfinite(v[1]));
              EXPECT_LE(std::hypot(v[0], v[1]),
                        1.1 * load / (size / condition) * (1. + 1e-6) + 1e-320);
              if (k == 0.)
                {
                  EXPECT_EQ(minimise_local(law, data, size, load, k),
                            load / size);
                }
              for (const double w : {1e-300, 1e-30, 1e3})
                {
                  const double beside =
                    minimise_local_beside(law, data, size, load, k, w);
                  EXPECT_GE(beside, 0.);
                  EXPECT_LE(beside, load / size * (1. + 1e-14) + 1e-320);
                }
            }
}



TEST(LocalProblemWithThreshold, SticksAndSlides)
{
  const CoulombLaw   law;
  const double       mu = law.node_data(0.), k = 5.;
  const Tensor<2, 2> A = matrix(7., 30., 0.4);
  Tensor<1, 2>       n;
  n[0] = 0.6;
  n[1] = -0.8;

  EXPECT_EQ(minimise_local(law, mu, A, 0.999 * k * mu * n, k).norm(), 0.);
  EXPECT_EQ(minimise_local(law, mu, 7., -0.999 * k * mu, k), 0.);
  for (const double V : {1e-9, 1e-3, 1., 1e4})
    {
      const Tensor<1, 2> r = V * (A * n) + k * mu * n;
      // The threshold is subtracted from r, which costs digits of small V.
      EXPECT_LT((minimise_local(law, mu, A, r, k) - V * n).norm(),
                1e-13 * V + 100. * epsilon);
    }
}
