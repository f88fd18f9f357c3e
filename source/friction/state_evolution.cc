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

    /**
     * -d ln(mean_decay(g)) / d ln(g) = (exp(g) - 1 - g) / (exp(g) - 1).
     */
    double
    mean_decay_sensitivity(const double g)
    {
      if (g > 0.5)
        return 1. - g / std::expm1(g);

      // The terms of both series, divided by g.
      double term      = 0.5 * g;
      double numerator = term;
      for (unsigned int n = 3; n < 16; ++n)
        {
          term *= g / n;
          numerator += term;
        }
      return numerator / (1. + numerator);
    }

    double
    exponential_aging(const double alpha, const double g, const double tau)
    {
      return log_of_sum(alpha - g, std::log(tau) + std::log(mean_decay(g)));
    }

    double
    exponential_aging_sensitivity(const double alpha,
                                  const double g,
                                  const double tau)
    {
      const double updated = exponential_aging(alpha, g, tau);
      // The shares of theta1 that come from theta0 and from healing.
      const double memory = std::exp(alpha - g - updated);
      const double healing =
        std::exp(std::log(tau) + std::log(mean_decay(g)) - updated);
      return memory * g + healing * mean_decay_sensitivity(g);
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
  } // namespace



  double
  state_rate(const StateLaw law,
             const double   alpha,
             const double   V,
             const double   L)
  {
    if (law == StateLaw::aging)
      return std::exp(-alpha) - V / L;
    else
      return (V == 0.) ? 0. : -V / L * (alpha + std::log(V / L));
  }



  double
  steady_state(const double V, const double L)
  {
    return -std::log(V / L);
  }



  double
  updated_state(const StateLaw    law,
                const StateUpdate update,
                const double      alpha,
                const double      V,
                const double      L,
                const double      tau)
  {
    Assert(V >= 0. && L > 0. && tau >= 0., dealii::ExcInternalError());
    const double rate = V / L;
    const double g    = rate * tau;

    if (law == StateLaw::aging)
      return (update == StateUpdate::exponential) ?
               exponential_aging(alpha, g, tau) :
               implicit_aging(alpha, g, tau);

    // Also where V/L underflows: there the state of the slip law stands still.
    if (rate == 0.)
      return alpha;
    return (update == StateUpdate::exponential) ?
             exponential_slip(alpha, g, std::log(rate)) :
             implicit_slip(alpha, g, std::log(rate));
  }



  double
  state_sensitivity(const StateLaw    law,
                    const StateUpdate update,
                    const double      alpha,
                    const double      V,
                    const double      L,
                    const double      tau)
  {
    Assert(V >= 0. && L > 0. && tau >= 0., dealii::ExcInternalError());
    const double rate = V / L;
    const double g    = rate * tau;
    if (g == 0.)
      return 0.;

    if (law == StateLaw::aging)
      return (update == StateUpdate::exponential) ?
               exponential_aging_sensitivity(alpha, g, tau) :
               g / (1. + implicit_aging_increment(alpha, g, tau));

    const double distance = alpha + std::log(rate);
    return (update == StateUpdate::exponential) ?
             -std::expm1(-g) + g * std::exp(-g) * distance :
             g / (1. + g) * (1. + distance / (1. + g));
  }
} // namespace StickSlip
