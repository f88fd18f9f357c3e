// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// The law that doc/adding_a_law.md adds to the program, and its tests as shown
// there.

#include <gtest/gtest.h>
#include <stickslip/friction/friction_law.h>
#include <stickslip/friction/local_problem.h>

#include <cmath>

namespace StickSlip
{
  /**
   * Bingham's law: a threshold mu0, and above it a friction coefficient that
   * grows in proportion to the slip rate, mu = mu0 + V/V0.
   */
  class BinghamLaw : public FrictionLaw
  {
  public:
    /** @p threshold: mu0, without unit; @p slip_rate: V0, m/s. */
    BinghamLaw(const double threshold, const double slip_rate)
      : threshold(threshold)
      , slip_rate(slip_rate)
    {}

    double
    coefficient(const double V, const double) const override
    {
      return threshold + V / slip_rate;
    }

    double
    derivative(const double, const double) const override
    {
      return 1. / slip_rate;
    }

    double
    potential(const double V, const double) const override
    {
      return threshold * V + V * V / (2. * slip_rate);
    }

  private:
    const double threshold, slip_rate;
  };
} // namespace StickSlip

using namespace StickSlip;



TEST(Bingham, IsTheSlopeOfItsPotential)
{
  const BinghamLaw law(0.3, 1e-3);
  const double     h = 1e-9;
  for (const double V : {1e-6, 1e-3, 1.})
    {
      EXPECT_NEAR((law.potential(V + h, 0.) - law.potential(V - h, 0.)) /
                    (2. * h),
                  law.coefficient(V, 0.),
                  1e-6 * law.coefficient(V, 0.));
      EXPECT_NEAR((law.coefficient(V + h, 0.) - law.coefficient(V - h, 0.)) /
                    (2. * h),
                  law.derivative(V, 0.),
                  1e-4 * law.derivative(V, 0.));
    }
  EXPECT_FALSE(law.is_smooth(0., 0.));
}



TEST(Bingham, StopsWhatIsBelowItsThreshold)
{
  const BinghamLaw law(0.3, 1e-3);
  // 1/2 c V^2 - r V + k Phi(V) has its minimum where c V + k mu(V) = r.
  const double c = 10., k = 100.;
  EXPECT_EQ(minimise_local(law, 0., c, 29.9, k), 0.);
  EXPECT_NEAR(minimise_local(law, 0., c, 50., k), 20. / (c + k / 1e-3), 1e-18);
  EXPECT_NEAR(minimise_local(law, 0., c, -50., k),
              -20. / (c + k / 1e-3),
              1e-18);
}
