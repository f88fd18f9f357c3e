// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/friction_law.h>

#include <cmath>

namespace StickSlip
{
  double
  FrictionLaw::minimiser(const double c,
                         const double r,
                         const double k,
                         const double data) const
  {
    // Bounds of the root of c V + k mu(V) = r, whose left side grows with V.
    double lower = 0.;
    double upper = (r - k * coefficient(0., data)) / c;
    if (!(upper > 0.))
      return 0.;

    double V = upper;
    for (unsigned int i = 0; i < 300; ++i)
      {
        const double excess = c * V + k * coefficient(V, data) - r;
        if (excess == 0.)
          return V;
        (excess > 0. ? upper : lower) = V;

        double next = V - excess / (c + k * derivative(V, data));
        // The bounds may be many decades apart, so halve the logarithm.
        if (!(next > lower && next < upper))
          next =
            lower > 0. ? std::sqrt(lower) * std::sqrt(upper) : upper / 1024.;
        const bool has_converged = std::abs(next - V) <= 1e-16 * V;
        V                        = next;
        if (has_converged || V == 0.)
          break;
      }
    return V;
  }
} // namespace StickSlip
