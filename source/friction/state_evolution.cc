// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/friction/state_evolution.h>
#include <stickslip/friction/wright_omega.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    /**
     * ln(exp(p) + exp(q)), where one of them may be -infinity.
     */
    double
    log_of_sum(const double p, const double q)
    {
      return std::max(p, q) + std::log1p(std::exp(-std::abs(p - q)));
    }

    /**
     * (1 - exp(-g)) / g for g >= 0.
     */
    double
    mean_decay(const double g)
    {
      return (g == 0.) ? 1. : -std::expm1(-g) / g;
    }

    double
    exponential_aging(const double alpha, const double g, const double tau)
    {
      return log_of_sum(alpha - g, std::log(tau) + std::log(mean_decay(g)));
    }

    /**
     * tau exp(-alpha1), the healing in an implicit Euler step of the aging law.
     */
    double
    implicit_aging_increment(const double alpha,
                             const double g,
                             const double tau)
    {
      return wright_omega(std::log(tau) - (alpha - g));
    }

    double
    implicit_aging(const double alpha, const double g, const double tau)
    {
      const double increment = implicit_aging_increment(alpha, g, tau);
      return (increment < 1.) ? (alpha - g) + increment :
                                std::log(tau) - std::log(increment);
    }

    double
    exponential_slip(const double alpha, const double g, const double log_rate)
    {
      // Two forms of the same, each for the side where it does not cancel.
      if (g < 1.)
        return alpha + (alpha + log_rate) * std::expm1(-g);
      else
        return (alpha + log_rate) * std::exp(-g) - log_rate;
    }

    double
    implicit_slip(const double alpha, const double g, const double log_rate)
    {
      if (g < 1.)
        return alpha - (alpha + log_rate) * (g / (1. + g));
      else
        return (alpha + log_rate) / (1. + g) - log_rate;
    }



    class AgingLaw : public StateLaw
    {
    public:
      double
      rate(const double alpha, const double V, const double L) const override
      {
        return std::exp(-alpha) - V / L;
      }

      double
      updated(const StateUpdate update,
              const double      alpha,
              const double      V,
              const double      L,
              const double      tau) const override
      {
        Assert(V >= 0. && L > 0. && tau >= 0., dealii::ExcInternalError());
        const double g = V / L * tau;
        return update == StateUpdate::exponential ?
                 exponential_aging(alpha, g, tau) :
                 implicit_aging(alpha, g, tau);
      }
    };



    class SlipLaw : public StateLaw
    {
    public:
      double
      rate(const double alpha, const double V, const double L) const override
      {
        return (V == 0.) ? 0. : -V / L * (alpha + std::log(V / L));
      }

      double
      updated(const StateUpdate update,
              const double      alpha,
              const double      V,
              const double      L,
              const double      tau) const override
      {
        Assert(V >= 0. && L > 0. && tau >= 0., dealii::ExcInternalError());
        const double rate = V / L;
        // The state stands still, also if V/L underflows.
        if (rate == 0.)
          return alpha;
        const double g = rate * tau;
        return update == StateUpdate::exponential ?
                 exponential_slip(alpha, g, std::log(rate)) :
                 implicit_slip(alpha, g, std::log(rate));
      }
    };
  } // namespace



  const std::vector<StateLawKind> &
  state_laws()
  {
    static const std::vector<StateLawKind> laws = {
      {"aging", "Dieterich", std::make_shared<const AgingLaw>()},
      {"slip", "Ruina", std::make_shared<const SlipLaw>()}};
    return laws;
  }
} // namespace StickSlip
