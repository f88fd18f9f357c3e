// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/wright_omega.h>

#include <cmath>

namespace StickSlip
{
  double
  wright_omega(const double s)
  {
    // There, exp(-y) rounds to 1; this includes s = -infinity.
    if (s < -40.)
      return std::exp(s);

    if (s < -1.)
      {
        // z + exp(z) is convex and z = s lies right of the solution, so that
        // Newton's method falls monotonically.
        double z = s;
        for (unsigned int i = 0; i < 10; ++i)
          {
            const double y    = std::exp(z);
            const double step = (z + y - s) / (1. + y);
            z -= step;
            if (std::abs(step) < 1e-9)
              break;
          }
        return std::exp(z);
      }

    // There, ln(s) is below the last digit; this includes s = infinity.
    if (s > 1e18)
      return s;

    // Start from below: the tangent at s = 0, and y <= s for s >= 1.
    double y =
      (s < 1.) ? 0.567143290409784 + 0.361896256634889 * s : s - std::log(s);
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double residual = s - y - std::log(y);
        const double slope    = 1. + y;
        const double q        = 2. * slope * (slope + 2. / 3. * residual);
        const double relative_step =
          residual / slope * (q - residual) / (q - 2. * residual);
        y += y * relative_step;
        if (std::abs(relative_step) < 1e-5)
          break;
      }
    return y;
  }
} // namespace StickSlip
