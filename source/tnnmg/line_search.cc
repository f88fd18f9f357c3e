// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/line_search.h>

#include <cmath>

namespace StickSlip
{
  LineSearchResult
  find_step_length(const std::function<double(double)> &slope,
                   const double                         at_start,
                   const double                         at_end)
  {
    constexpr double       sufficient_fraction = 0.1;
    constexpr unsigned int max_evaluations     = 100;

    LineSearchResult result;
    double           upper = 1., slope_upper = at_end;
    result.evaluations = 2;
    if (!(at_start < 0.) || !std::isfinite(slope_upper))
      return result;
    if (slope_upper <= 0.)
      {
        result.step_length = 1.;
        return result;
      }

    // Regula falsi in the Illinois form, with bisection in every third step
    // against slopes of very different size at the two ends.
    double lower = 0., slope_lower = at_start;
    double weight_lower = 1., weight_upper = 1.;
    while (result.evaluations < max_evaluations &&
           slope_lower < sufficient_fraction * at_start &&
           upper - lower > 1e-15 * upper)
      {
        const double a = weight_lower * slope_lower,
                     b = weight_upper * slope_upper;
        const double t = (result.evaluations % 3 == 0) ?
                           0.5 * (lower + upper) :
                           lower + (upper - lower) * (-a / (b - a));
        const double s = slope(t);
        ++result.evaluations;
        if (s <= 0.)
          {
            lower = t, slope_lower = s;
            weight_lower = 1., weight_upper *= 0.5;
          }
        else
          {
            upper = t, slope_upper = s;
            weight_upper = 1., weight_lower *= 0.5;
          }
      }
    result.step_length = lower;
    return result;
  }
} // namespace StickSlip
