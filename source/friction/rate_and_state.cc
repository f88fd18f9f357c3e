// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/rate_and_state.h>
#include <stickslip/friction/wright_omega.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace StickSlip
{
  namespace
  {
    /**
     * asinh(exp(x) / 2) without overflow.
     */
    double
    asinh_half_exp(const double x)
    {
      return (x > 18.) ? x + std::exp(-2. * x) : std::asinh(0.5 * std::exp(x));
    }

    /**
     * z - 1 + exp(-z) for z >= 0 without cancellation.
     */
    double
    second_exponential_remainder(const double z)
    {
      if (z > 0.5)
        return z + std::expm1(-z);
      double term = 0.5 * z * z;
      double sum  = term;
      for (unsigned int n = 3; n < 16; ++n)
        {
          term *= -z / n;
          sum += term;
        }
      return sum;
    }

    /**
     * The solution of c V + k max(0, ln(V/Vmin)) = r with q = r/k.
     */
    double
    minimiser_truncated(const double c,
                        const double r,
                        const double k,
                        const double q,
                        const double log_vmin)
    {
      if (r / c <= std::exp(log_vmin))
        return r / c;

      // With y = c V / k the equation is y + ln(y) = s.
      const double y = wright_omega(q + (std::log(c) - std::log(k) + log_vmin));
      // If friction carries nearly all of r, y has lost digits in units of
      // itself but none in units of q.
      return (y < 1.) ? std::exp(log_vmin + (q - y)) : y * k / c;
    }

    /**
     * The solution of c V + k asinh(V / (2 Vmin)) = r with q = r/k.
     */
    double
    minimiser_arcsinh(const double c,
                      const double r,
                      const double k,
                      const double q,
                      const double log_vmin)
    {
      // In z = asinh(V / (2 Vmin)) and with e = c Vmin / k, the equation is
      // 2 e sinh(z) + z = q.
      const double log_e = std::log(c) - std::log(k) + log_vmin;

      // Friction is below the last digit of r.
      if (log_e > 40.)
        return r / c;
      const double twice_e = 2. * std::exp(log_e);

      // Both terms are positive, so either alone bounds z from above. The
      // function is convex, and Newton's method falls monotonically.
      double z  = std::min(q, asinh_half_exp(std::log(q) - log_e));
      double cv = 0.;
      for (unsigned int i = 0; i < 50; ++i)
        {
          double slope;
          if (z < 1.)
            {
              cv    = twice_e * std::sinh(z);
              slope = twice_e * std::cosh(z);
            }
          else
            {
              const double growing    = std::exp(log_e + z);
              const double decreasing = std::exp(log_e - z);
              cv                      = growing - decreasing;
              slope                   = growing + decreasing;
            }
          const double step = (cv + (z - q)) / (1. + slope);
          z -= step;
          // The next step would be of the order of the square of this one.
          if (step < 1e-9 * std::min(z, 1.))
            break;
        }

      // The part of the matrix in r, where it is not small, has more digits.
      if (cv >= std::min(z, 1.))
        return (q - z) * k / c;
      else if (z >= 1.)
        return std::exp(log_vmin + z) - std::exp(log_vmin - z);
      else
        return 2. * std::exp(std::min(log_vmin, 700.)) * std::sinh(z);
    }



    LawParameter
    evolution_effect()
    {
      return LawParameter::field("b",
                                 "Evolution effect b of the state (the fault "
                                 "can be unstable only if b > a)",
                                 "1",
                                 NumberRange().at_least(0),
                                 RateAndStateParameters().b);
    }



    LawParameter
    regularisation_choice()
    {
      return LawParameter::choice(
        "Regularisation",
        "Friction coefficient as V tends to 0: a max(0, ln(V/Vmin)), or a "
        "asinh(V/(2 Vmin))",
        {"truncated", "arcsinh"});
    }



    Regularisation
    chosen_regularisation(const LawValues &values)
    {
      return values[regularisation_choice()] == 0. ? Regularisation::truncated :
                                                     Regularisation::arcsinh;
    }
  } // namespace



  RateAndStateLaw::RateAndStateLaw(const RateAndStateParameters &parameters,
                                   const Regularisation          regularisation)
    : parameters(parameters)
    , regularisation(regularisation)
    , log_vmin_at_zero(
        std::log(parameters.reference_slip_rate) -
        (parameters.reference_friction +
         parameters.b * std::log(parameters.reference_slip_rate /
                                 parameters.characteristic_slip)) /
          parameters.a)
  {
    AssertThrow(parameters.a > 0.,
                dealii::ExcMessage(
                  "The direct effect a of rate-and-state friction must be "
                  "positive, but is " +
                  std::to_string(parameters.a) + "."));
    AssertThrow(parameters.reference_slip_rate > 0. &&
                  parameters.characteristic_slip > 0.,
                dealii::ExcMessage(
                  "The reference slip rate V0 and the characteristic slip L of "
                  "rate-and-state friction must be positive."));
    AssertThrow(std::isfinite(log_vmin_at_zero) && std::isfinite(parameters.b),
                dealii::ExcMessage("The parameters of rate-and-state friction "
                                   "must be finite."));
  }



  RateAndStateLaw::RateAndStateLaw(const LawValues &values)
    : RateAndStateLaw({values[CommonParameters::direct_effect()],
                       values[evolution_effect()],
                       values[CommonParameters::reference_friction()],
                       values[CommonParameters::reference_slip_rate()],
                       values[CommonParameters::characteristic_slip()]},
                      chosen_regularisation(values))
  {}



  LawKind
  RateAndStateLaw::kind()
  {
    LawKind kind   = {"rate and state",
                      "mu = mu0 + a ln(V/V0) + b ln(V0 theta/L)",
                      {CommonParameters::direct_effect(),
                       evolution_effect(),
                       CommonParameters::reference_friction(),
                       CommonParameters::reference_slip_rate(),
                       CommonParameters::characteristic_slip(),
                       regularisation_choice()}};
    kind.has_state = true;
    return kind;
  }



  double
  RateAndStateLaw::scaled_coefficient(const double V,
                                      const double log_vmin) const
  {
    const double x = std::log(V) - log_vmin;
    return (regularisation == Regularisation::truncated) ? std::max(0., x) :
                                                           asinh_half_exp(x);
  }



  double
  RateAndStateLaw::derivative(const double V, const double log_vmin) const
  {
    if (regularisation == Regularisation::truncated)
      return is_smooth(V, log_vmin) ? parameters.a / V : 0.;
    else
      return parameters.a / std::hypot(V, 2. * std::exp(log_vmin));
  }



  double
  RateAndStateLaw::chord(const double V,
                         const double change,
                         const double log_vmin) const
  {
    const double tangent = derivative(V, log_vmin);
    const double z       = scaled_coefficient(V, log_vmin);
    const double x       = std::max(change / parameters.a, -z);
    if (x == 0. || !std::isfinite(tangent))
      return tangent;

    // ln(V) changes by x; asinh differs from it near Vmin.
    const double logarithmic = tangent * (x / std::expm1(x));
    return (regularisation == Regularisation::truncated) ?
             logarithmic :
             logarithmic * (1. + std::exp(-2. * z)) /
               (1. + std::exp(-2. * z - x));
  }



  double
  RateAndStateLaw::potential(const double V, const double log_vmin) const
  {
    const double z = scaled_coefficient(V, log_vmin);
    // Both are V z minus the integral of V over z, written such that Vmin
    // drops out: (cosh(z) - 1) / sinh(z) = tanh(z/2).
    return parameters.a * V *
           ((regularisation == Regularisation::truncated) ?
              second_exponential_remainder(z) :
              z - std::tanh(0.5 * z));
  }



  bool
  RateAndStateLaw::is_smooth(const double V, const double log_vmin) const
  {
    return regularisation == Regularisation::arcsinh || std::log(V) > log_vmin;
  }



  double
  RateAndStateLaw::minimiser(const double c,
                             const double r,
                             const double k,
                             const double log_vmin) const
  {
    Assert(c > 0. && r >= 0. && k >= 0., dealii::ExcInternalError());
    if (r == 0.)
      return 0.;

    const double ka = k * parameters.a;
    const double q  = r / ka;
    // z is the difference of two logarithms and cannot be that large, so that
    // nothing of friction is left in r.
    if (k == 0. || q > 1e30)
      return r / c;
    return (regularisation == Regularisation::truncated) ?
             minimiser_truncated(c, r, ka, q, log_vmin) :
             minimiser_arcsinh(c, r, ka, q, log_vmin);
  }



  LawKind
  RateAndStateLaw::velocity_strengthening_kind()
  {
    return {"velocity strengthening",
            "mu0 + a ln(V/V0)",
            {CommonParameters::direct_effect(),
             CommonParameters::reference_friction(),
             CommonParameters::reference_slip_rate(),
             regularisation_choice()},
            false,
            true,
            [](const LawValues &values) {
              RateAndStateParameters parameters;
              parameters.a = values[CommonParameters::direct_effect()];
              parameters.b = 0.;
              parameters.reference_friction =
                values[CommonParameters::reference_friction()];
              parameters.reference_slip_rate =
                values[CommonParameters::reference_slip_rate()];
              return std::make_shared<const RateAndStateLaw>(
                parameters, chosen_regularisation(values));
            }};
  }
} // namespace StickSlip
