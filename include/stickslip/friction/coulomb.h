// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_coulomb_h
#define stickslip_friction_coulomb_h

#include <stickslip/friction/law_registry.h>

#include <algorithm>

namespace StickSlip
{
  /**
   * Friction with a coefficient that does not depend on the slip rate: a
   * threshold below which nothing slips, Phi(V) = mu V. With a coefficient of
   * zero there is no friction.
   */
  class CoulombLaw : public FrictionLaw
  {
  public:
    /**
     * Constructor. Throws unless the coefficient is finite and not negative.
     */
    explicit CoulombLaw(const double coefficient);

    explicit CoulombLaw(const LawValues &values);

    static LawKind
    kind();

    /** No friction, as a kind of its own. */
    static LawKind
    frictionless_kind();

    double
    coefficient(const double, const double) const override
    {
      return mu;
    }

    double
    derivative(const double, const double) const override
    {
      return 0.;
    }

    double
    potential(const double V, const double) const override
    {
      return mu * V;
    }

    double
    minimiser(const double c,
              const double r,
              const double k,
              const double) const override
    {
      return std::max(0., (r - k * mu) / c);
    }

  private:
    const double mu;
  };
} // namespace StickSlip

#endif
