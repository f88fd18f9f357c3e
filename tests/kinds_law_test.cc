// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/coulomb.h>
#include <stickslip/friction/rate_and_state.h>

#include <cmath>

using namespace StickSlip;

namespace
{
  /** A law that says only what every law has to. */
  class MinimalLaw : public FrictionLaw
  {
  public:
    explicit MinimalLaw(const FrictionLaw &law, const double data = 0.)
      : law(law)
      , data(data)
    {}

    double
    coefficient(const double V, const double) const override
    {
      return law.coefficient(V, data);
    }

    double
    derivative(const double V, const double) const override
    {
      return law.derivative(V, data);
    }

    double
    potential(const double V, const double) const override
    {
      return law.potential(V, data);
    }

  private:
    const FrictionLaw &law;
    const double       data;
  };



  /** mu = threshold + (V/V0)^2. */
  class QuadraticLaw : public FrictionLaw
  {
  public:
    double
    coefficient(const double V, const double) const override
    {
      return threshold + V * V / (V0 * V0);
    }

    double
    derivative(const double V, const double) const override
    {
      return 2. * V / (V0 * V0);
    }

    double
    potential(const double V, const double) const override
    {
      return threshold * V + V * V * V / (3. * V0 * V0);
    }

    const double threshold = 0.3, V0 = 1e-3;
  };
} // namespace



TEST(FrictionLaw, IsWithoutStateUnlessItSaysOtherwise)
{
  const QuadraticLaw law;
  EXPECT_EQ(law.node_data(3.), 0.);
  EXPECT_EQ(law.rate_scale(), 0.);
  // A threshold has a kink at rest, and nowhere else.
  EXPECT_FALSE(law.is_smooth(0., 0.));
  EXPECT_TRUE(law.is_smooth(1e-30, 0.));
  EXPECT_TRUE(CoulombLaw(0.).is_smooth(0., 0.));
}



TEST(FrictionLaw, IsMinimisedByBoundsThatCloseIn)
{
  // Against the root of a quadratic equation.
  const QuadraticLaw law;
  for (const double c : {1e-3, 1., 1e6})
    for (const double k : {1e-6, 1., 1e5})
      for (const double excess : {1e-12, 1e-3, 1., 1e4})
        {
          // c V + p + q V^2 = r
          const double p = k * law.threshold, q = k / (law.V0 * law.V0);
          const double r = p + excess;
          if (r - p < 1e-6 * p)
            continue;
          const double V =
            2. * (r - p) / (c + std::sqrt(c * c + 4. * q * (r - p)));
          EXPECT_NEAR(law.minimiser(c, r, k, 0.) / V, 1., 1e-9)
            << c << ' ' << k << ' ' << excess;
        }
  EXPECT_EQ(law.minimiser(1., 0.29, 1., 0.), 0.);
  EXPECT_EQ(law.minimiser(1., 0., 1., 0.), 0.);
}



TEST(FrictionLaw, IsMinimisedAsByItsOwnFunctionOverManyDecades)
{
  for (const Regularisation regularisation :
       {Regularisation::truncated, Regularisation::arcsinh})
    {
      const RateAndStateLaw law(RateAndStateParameters(), regularisation);
      for (const double alpha : {-5., 0., 10.})
        {
          const double     data = law.node_data(alpha);
          const MinimalLaw minimal(law, data);
          for (const double c : {1e-3, 1e3, 1e9})
            for (const double r : {1e-3, 1., 1e3})
              for (const double k : {1., 1e3})
                {
                  const double V = law.minimiser(c, r, k, data);
                  EXPECT_NEAR(minimal.minimiser(c, r, k, 0.),
                              V,
                              // The logarithm of V has 1e-16 mu / a of it.
                              1e-13 * V)
                    << alpha << ' ' << c << ' ' << r << ' ' << k;
                }
        }
    }
}



TEST(Coulomb, IsMinimisedByWhatItsBoundsFind)
{
  const CoulombLaw law(0.6);
  const MinimalLaw minimal(law);
  for (const double r : {0., 1., 5.999, 6., 6.001, 100.})
    {
      const double V = std::max(0., (r - 6.) / 2.);
      EXPECT_NEAR(law.minimiser(2., r, 10., 0.), V, 1e-14);
      EXPECT_NEAR(minimal.minimiser(2., r, 10., 0.), V, 1e-14);
    }
  EXPECT_EQ(law.potential(3., 0.), 0.6 * 3.);
  EXPECT_EQ(law.derivative(3., 0.), 0.);
  EXPECT_THROW(CoulombLaw(-0.1), std::exception);
  EXPECT_THROW(CoulombLaw(NAN), std::exception);
}
