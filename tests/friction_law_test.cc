// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <gtest/gtest.h>
#include <stickslip/friction/rate_and_state.h>
#include <stickslip/friction/wright_omega.h>

#include <cmath>

#include "friction_reference.h"

using namespace StickSlip;
using Reference::epsilon;
using Reference::LogUniform;
using Reference::Real;

namespace
{
  class RateAndState : public ::testing::TestWithParam<Regularisation>
  {
  protected:
    const RateAndStateParameters parameters;
    const RateAndStateLaw        law{parameters, GetParam()};
    std::mt19937                 engine{1};

    /**
     * States theta over sixteen decades.
     */
    double
    random_log_vmin()
    {
      return law.node_data(std::log(LogUniform(1e-8, 1e8)(engine)));
    }
  };

  INSTANTIATE_TEST_SUITE_P(Regularisations,
                           RateAndState,
                           ::testing::Values(Regularisation::truncated,
                                             Regularisation::arcsinh));

  const std::vector<double>
    extreme_rates{0., 1e-300, 1e-100, 1e-30, 1e-9, 1., 1e3};
  const std::vector<double>
    extreme_log_vmin{-1500., -700., -300., -70., 0., 50., 720.};
} // namespace



TEST(WrightOmega, SolvesItsEquation)
{
  double largest = 0.;
  for (double s = -700.; s < 1e6; s += std::max(1e-2 * std::abs(s), 0.0131))
    {
      // Bisection for z = ln(y).
      Real lower = -701, upper = 15;
      while (upper - lower > 1e-18)
        {
          const Real z                     = (lower + upper) / 2;
          (z + exp(z) < s ? lower : upper) = z;
        }
      const double error =
        Reference::relative_error(wright_omega(s), exp(lower)) /
        (1. + std::max(-s, 0.));
      largest = std::max(largest, error);
    }
  RecordProperty("largest_error_in_epsilon", std::to_string(largest / epsilon));
  EXPECT_LT(largest, 2. * epsilon);
  EXPECT_EQ(wright_omega(-std::numeric_limits<double>::infinity()), 0.);
  EXPECT_EQ(wright_omega(1e300), 1e300);
}



TEST_P(RateAndState, LogMinimalSlipRateMeansZeroFriction)
{
  // mu0 + a ln(V/V0) + b ln(V0 theta/L) vanishes at Vmin.
  for (const double alpha : {-700., -20., 0., 3., 700.})
    {
      const Real log_V = law.node_data(alpha);
      const Real log_v0(log(Real(parameters.reference_slip_rate)));
      const Real log_l(log(Real(parameters.characteristic_slip)));
      const Real mu = parameters.reference_friction +
                      parameters.a * (log_V - log_v0) +
                      parameters.b * (log_v0 + alpha - log_l);
      EXPECT_LT(abs(mu), 4 * epsilon * (1. + 1.5e-2 * std::abs(alpha)));
    }
}



TEST_P(RateAndState, CoefficientAndDerivativesAgreeWithHighPrecision)
{
  LogUniform random_rate(1e-30, 10.);
  double     largest = 0.;
  for (unsigned int i = 0; i < 5000; ++i)
    {
      const double log_vmin = random_log_vmin();
      const double V        = random_rate(engine);
      // Change of z by one rounding of the logarithms.
      const double rounding =
        epsilon * (1. + std::abs(std::log(V)) + std::abs(log_vmin));

      const Real   z = Reference::scaled_coefficient(GetParam(), V, log_vmin);
      const double error =
        std::abs(static_cast<double>(law.scaled_coefficient(V, log_vmin) - z));
      largest = std::max(largest, error);
      EXPECT_LE(error, rounding);
      // Below Vmin, the arcsinh form is linear.
      if (GetParam() == Regularisation::arcsinh)
        {
          EXPECT_LE(error, rounding * static_cast<double>(z));
        }
      EXPECT_NEAR(law.coefficient(V, log_vmin),
                  static_cast<double>(parameters.a * z),
                  rounding * parameters.a);

      // Too near Vmin it is open on which side V is.
      if (GetParam() == Regularisation::arcsinh || z == 0 || z > 1e-10)
        {
          const Real derivative =
            parameters.a *
            Reference::scaled_derivative(GetParam(), V, log_vmin);
          if (derivative == 0)
            EXPECT_EQ(law.derivative(V, log_vmin), 0.);
          else
            EXPECT_LT(Reference::relative_error(law.derivative(V, log_vmin),
                                                derivative),
                      rounding);
        }
    }
  RecordProperty("largest_error_of_z", std::to_string(largest * 1e15) + "e-15");
}



TEST_P(RateAndState, ChordLeadsToTheChangedCoefficient)
{
  LogUniform random_rate(1e-30, 10.), random_size(1e-9, 1.);
  for (unsigned int i = 0; i < 5000; ++i)
    {
      const double log_vmin = random_log_vmin();
      const double V        = random_rate(engine);
      const double mu       = law.coefficient(V, log_vmin);
      if (!law.is_smooth(V, log_vmin))
        {
          EXPECT_EQ(law.chord(V, 0.1, log_vmin), 0.);
          continue;
        }
      // Friction cannot fall below zero.
      const double change =
        std::max((i % 2 ? 1. : -1.) * random_size(engine), -mu);
      if (std::abs(change) < 1e-9 * mu)
        continue;
      const Real old_z = Reference::scaled_coefficient(GetParam(), V, log_vmin);
      const Real z     = std::max(Real(0), old_z + change / parameters.a);
      const Real factor =
        (GetParam() == Regularisation::truncated) ? exp(z) : 2 * sinh(z);
      const Real chord =
        parameters.a * (z - old_z) / (exp(Real(log_vmin)) * factor - V);
      // Change of that in V by one rounding of the logarithms.
      const double rounding =
        epsilon * (1. + std::abs(std::log(V)) + std::abs(log_vmin)) *
        (1. + parameters.a / std::abs(change) +
         1. / static_cast<double>(old_z));
      if (chord > std::numeric_limits<double>::min())
        EXPECT_LT(Reference::relative_error(law.chord(V, change, log_vmin),
                                            chord),
                  4. * rounding);
      else
        EXPECT_LE(law.chord(V, change, log_vmin),
                  std::numeric_limits<double>::min());

      EXPECT_EQ(law.chord(V, 0., log_vmin), law.derivative(V, log_vmin));
      // From there on it is the same.
      EXPECT_EQ(law.chord(V, -2. * mu, log_vmin),
                law.chord(V, -3. * mu, log_vmin));
    }
}



TEST_P(RateAndState, PotentialIsTheIntegralOfTheCoefficient)
{
  boost::math::quadrature::gauss_kronrod<long double, 61> quadrature;
  LogUniform random_rate(1e-30, 10.);
  for (unsigned int i = 0; i < 500; ++i)
    {
      const double log_vmin = random_log_vmin();
      const double V        = random_rate(engine);
      const double z        = law.scaled_coefficient(V, log_vmin);
      if (z == 0.)
        {
          EXPECT_EQ(law.potential(V, log_vmin), 0.);
          continue;
        }
      // Phi = V int_0^inf z(V exp(-u)) exp(-u) du.
      const bool        truncated = (GetParam() == Regularisation::truncated);
      const long double log_ratio =
        std::log(static_cast<long double>(V)) - log_vmin;
      const long double integral = quadrature.integrate(
        [&](const long double u) -> long double {
          const long double x = log_ratio - u;
          return std::exp(-u) *
                 (truncated ? x : std::asinh(0.5L * std::exp(x)));
        },
        0.L,
        truncated ? std::min(log_ratio, 60.L) : 60.L,
        12,
        1e-16L);
      const double exact = parameters.a * V * static_cast<double>(integral);
      const double rounding =
        epsilon * (1. + std::abs(std::log(V)) + std::abs(log_vmin));
      EXPECT_NEAR(law.potential(V, log_vmin) / exact,
                  1.,
                  4. * (rounding / std::min(z, 1.) + epsilon));
    }
}



TEST_P(RateAndState, IsMonotoneAndConvex)
{
  for (const double log_vmin : {-100., -60., -20., 3.})
    {
      double last_coefficient = 0., last_potential = 0., last_slope = 0.,
             last_V = 0.;
      for (double V = 1e-32; V < 10.; V *= 1.3)
        {
          const double mu    = law.coefficient(V, log_vmin);
          const double phi   = law.potential(V, log_vmin);
          const double slope = (phi - last_potential) / (V - last_V);
          EXPECT_GE(mu, last_coefficient);
          // The slope of a chord lies between those of the tangents.
          EXPECT_GE(phi, last_potential);
          EXPECT_GE(slope, last_slope * (1. - 1e-12));
          EXPECT_GE(slope, last_coefficient * (1. - 1e-12));
          EXPECT_LE(slope, mu * (1. + 1e-12));
          EXPECT_GE(law.derivative(V, log_vmin), 0.);
          last_coefficient = mu;
          last_potential   = phi;
          last_slope       = slope;
          last_V           = V;
        }
    }
}



TEST_P(RateAndState, MinimiserAgreesWithHighPrecision)
{
  LogUniform random_rate(1e-30, 10.);
  LogUniform random_ratio(1e-9, 1e9);
  double     largest = 0.;
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const double log_vmin = random_log_vmin();
      const double V        = random_rate(engine);
      const double c        = random_ratio(engine);
      const double k        = random_ratio(engine);
      const double r        = c * V + k * law.coefficient(V, log_vmin);

      const Real exact = Reference::local_minimiser(
        GetParam(), c, r, Real(k) * parameters.a, log_vmin);
      const double error =
        Reference::relative_error(law.minimiser(c, r, k, log_vmin), exact);
      largest = std::max(largest, error);
    }
  RecordProperty("largest_relative_error",
                 std::to_string(largest * 1e15) + "e-15");
  EXPECT_LT(largest, 1e-13);
}



TEST_P(RateAndState, MinimiserIsExactUpToRoundingOfTheDataFarOut)
{
  LogUniform                             random(1e-20, 1e20);
  std::uniform_real_distribution<double> random_log(-700., 50.);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double log_vmin = random_log(engine);
      const double c        = random(engine);
      const double k        = random(engine);
      const double r        = random(engine);
      const Real   exact    = Reference::local_minimiser(
        GetParam(), c, r, Real(k) * parameters.a, log_vmin);
      // Slip rates that are the exponential of what friction has to carry:
      // that quantity's rounding is in the result.
      const Real carried =
        Reference::scaled_coefficient(GetParam(), exact, log_vmin);
      // Subnormal numbers have fewer digits.
      const Real scale = (exact > 1e-300) ? exact : Real(1e-300);
      EXPECT_LT(static_cast<double>(
                  abs(law.minimiser(c, r, k, log_vmin) - exact) / scale),
                4. * epsilon *
                  (1. + std::abs(log_vmin) + static_cast<double>(carried)))
        << "c = " << c << ", k = " << k << ", r = " << r
        << ", ln Vmin = " << log_vmin;
    }
}



TEST_P(RateAndState, ExtremeValuesAreHarmless)
{
  for (const double log_vmin : extreme_log_vmin)
    {
      for (const double V : extreme_rates)
        {
          const double z = law.scaled_coefficient(V, log_vmin);
          EXPECT_TRUE(std::isfinite(z) && z >= 0.);
          const double phi = law.potential(V, log_vmin);
          EXPECT_TRUE(std::isfinite(phi) && phi >= 0.);
          EXPECT_GE(law.derivative(V, log_vmin), 0.);
        }
      EXPECT_EQ(law.coefficient(0., log_vmin), 0.);

      for (const double c : {1e-10, 1., 1e12})
        for (const double k : {0., 1e-300, 1e-12, 1., 1e9})
          {
            double last = 0.;
            for (const double r : {0., 1e-300, 1e-100, 1e-10, 1., 1e8})
              {
                const double V = law.minimiser(c, r, k, log_vmin);
                EXPECT_GE(V, last);
                EXPECT_LE(V, r / c * (1. + 4. * epsilon) + 1e-320)
                  << "c = " << c << ", k = " << k << ", r = " << r
                  << ", ln Vmin = " << log_vmin;
                last = V;
              }
          }
    }
}



TEST(RateAndStateParameters, WrongOnesAreRefused)
{
  RateAndStateParameters parameters;
  parameters.a = 0.;
  EXPECT_ANY_THROW(RateAndStateLaw(parameters, Regularisation::arcsinh));
  parameters.a                   = 0.01;
  parameters.characteristic_slip = -1.;
  EXPECT_ANY_THROW(RateAndStateLaw(parameters, Regularisation::arcsinh));
  parameters.characteristic_slip = 2e-5;
  parameters.reference_friction  = std::nan("");
  EXPECT_ANY_THROW(RateAndStateLaw(parameters, Regularisation::arcsinh));
}
