// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// The law that doc/adding_a_law.md adds to the program, and its tests as shown
// there.

#include <gtest/gtest.h>
#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/law_registry.h>
#include <stickslip/friction/local_problem.h>

namespace StickSlip
{
  /**
   * Bingham's law: a threshold mu0, and above it a friction coefficient that
   * grows in proportion to the slip rate, mu = mu0 + V/V1.
   */
  class BinghamLaw : public FrictionLaw
  {
  public:
    explicit BinghamLaw(const LawValues &values)
      : threshold(values[CommonParameters::reference_friction()])
      , slip_rate(values[viscous_slip_rate()])
    {}

    static LawKind
    kind()
    {
      return {"Bingham",
              "mu0 + V/V1",
              {CommonParameters::reference_friction(), viscous_slip_rate()}};
    }

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
    static LawParameter
    viscous_slip_rate()
    {
      return LawParameter::field("Viscous slip rate",
                                 "Slip rate V1 at which viscosity adds 1 to "
                                 "the coefficient of Bingham's law",
                                 "m/s",
                                 NumberRange().above(0),
                                 1e-3);
    }

    const double threshold, slip_rate;
  };
} // namespace StickSlip

using namespace StickSlip;



TEST(Bingham, IsTheSlopeOfItsPotential)
{
  const BinghamLaw law({BinghamLaw::kind().parameters, {0.3, 1e-3}});
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
  const BinghamLaw law({BinghamLaw::kind().parameters, {0.3, 1e-3}});
  // 1/2 c V^2 - r V + k Phi(V) has its minimum where c V + k mu(V) = r.
  const double c = 10., k = 100.;
  EXPECT_EQ(minimise_local(law, 0., c, 29.9, k), 0.);
  EXPECT_NEAR(minimise_local(law, 0., c, 50., k), 20. / (c + k / 1e-3), 1e-18);
  EXPECT_NEAR(minimise_local(law, 0., c, -50., k),
              -20. / (c + k / 1e-3),
              1e-18);
}



TEST(Bingham, CanBeRegistered)
{
  const LawRegistry registry({kind_of_law<BinghamLaw>()});
  EXPECT_EQ(registry.kind("Bingham").parameters.size(), 3u);
}
