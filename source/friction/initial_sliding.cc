// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/friction/initial_sliding.h>
#include <stickslip/parameters/number_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The zero of a function that grows, between two numbers where its signs
     * differ, to the last digit. */
    template <typename Function>
    double
    zero_between(double lower, double upper, const Function &function)
    {
      while (true)
        {
          const double middle = 0.5 * (lower + upper);
          if (middle <= std::min(lower, upper) ||
              middle >= std::max(lower, upper))
            return middle;
          (function(middle) < 0. ? lower : upper) = middle;
        }
    }



    std::string
    pascal(const double value)
    {
      return shortest_form(value) + " Pa";
    }



    /** The slip rate with which friction and damping take up a shear stress;
     * zero below the strength. */
    double
    slip_rate_for(const double       stress,
                  const FrictionLaw &law,
                  const double       data,
                  const double       normal_stress,
                  const double       damping)
    {
      constexpr double largest = 1.;
      const auto       excess  = [&](const double log_rate) {
        const double V = std::exp(log_rate);
        return normal_stress * law.coefficient(V, data) + damping * V - stress;
      };
      const double least = std::log(std::numeric_limits<double>::min());
      if (stress == 0. || excess(least) >= 0.)
        return 0.;
      if (excess(std::log(largest)) < 0.)
        throw InputError("is " + pascal(stress) +
                         ", above the strength of the fault, which is " +
                         pascal(stress + excess(std::log(largest))) +
                         " at a slip rate of " + shortest_form(largest) +
                         " m/s");
      return std::exp(zero_between(least, std::log(largest), excess));
    }



    /** The state with which friction at a slip rate above zero is this. */
    double
    log_state_for(const double       friction,
                  const FrictionLaw &law,
                  const double       V,
                  const double       normal_stress)
    {
      constexpr double farthest = 1000.;
      const auto       excess   = [&](const double alpha) {
        return normal_stress * law.coefficient(V, law.node_data(alpha)) -
               friction;
      };
      // With b = 0 friction does not depend on the state.
      if (!(friction > 0.) || excess(-farthest) >= 0. || excess(farthest) <= 0.)
        throw InputError("leaves " + pascal(friction) +
                         " to friction, which no state gives at a slip rate "
                         "of " +
                         shortest_form(V) + " m/s");
      return zero_between(-farthest, farthest, excess);
    }
  } // namespace



  template <int n>
  InitialSliding<n>
  complete_start(const GivenStart<n> &given,
                 const FrictionLaw   &law,
                 const bool           has_state,
                 const double         normal_stress,
                 const double         damping)
  {
    constexpr double tolerance = 1e-4;

    InitialSliding<n> result;
    result.log_state    = given.log_state.value_or(0.);
    const auto friction = [&](const double V) {
      return V > 0. ? normal_stress *
                          law.coefficient(V, law.node_data(result.log_state)) +
                        damping * V :
                      0.;
    };

    if (!given.slip_rate)
      {
        if (!given.shear_stress)
          return result;
        result.shear_stress = *given.shear_stress;
        const double stress = magnitude(result.shear_stress);
        const double V      = slip_rate_for(
          stress, law, law.node_data(result.log_state), normal_stress, damping);
        if (V > 0.)
          result.slip_rate = (V / stress) * result.shear_stress;
        return result;
      }

    result.slip_rate = *given.slip_rate;
    const double V   = magnitude(result.slip_rate);
    if (!given.shear_stress)
      {
        if (V > 0.)
          result.shear_stress = (friction(V) / V) * result.slip_rate;
        return result;
      }

    result.shear_stress = *given.shear_stress;
    const double stress = magnitude(result.shear_stress);
    // At rest below the strength friction is whatever is needed.
    if (V == 0.)
      {
        if (law.rate_scale() == 0. &&
            slip_rate_for(stress,
                          law,
                          law.node_data(result.log_state),
                          normal_stress,
                          damping) > 0.)
          throw InputError("is " + pascal(stress) +
                           ", above the strength of the fault at rest, but "
                           "the initial slip rate is 0");
        return result;
      }
    if (result.shear_stress * result.slip_rate < (1. - tolerance) * stress * V)
      throw InputError("does not have the direction of the initial slip rate");
    if (has_state && normal_stress > 0.)
      {
        const double alpha =
          log_state_for(stress - damping * V, law, V, normal_stress);
        if (given.log_state &&
            std::abs(friction(V) - stress) > tolerance * stress)
          throw InputError("is " + pascal(stress) +
                           ", but the initial slip rate and state need " +
                           pascal(friction(V)) +
                           "; one of the three must be left out");
        result.log_state = alpha;
      }
    else if (std::abs(friction(V) - stress) > tolerance * stress)
      throw InputError(
        "is " + pascal(stress) + ", but the initial slip rate needs " +
        pascal(friction(V)) + "; one of the two must be left out");
    return result;
  }



  template decltype(complete_start<1>) complete_start<1>;
  template decltype(complete_start<2>) complete_start<2>;
} // namespace StickSlip
