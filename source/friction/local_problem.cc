// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/friction/local_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /**
     * The solution of B n = e for a symmetric positive definite matrix.
     */
    Tensor<1, 2>
    solve(const Tensor<2, 2> &B, const Tensor<1, 2> &e)
    {
      const double determinant = B[0][0] * B[1][1] - B[0][1] * B[1][0];
      Tensor<1, 2> n;
      n[0] = (B[1][1] * e[0] - B[0][1] * e[1]) / determinant;
      n[1] = (B[0][0] * e[1] - B[1][0] * e[0]) / determinant;
      return n;
    }
  } // namespace



  double
  minimise_local(const FrictionLaw &law,
                 const double       data,
                 const double       c,
                 const double       r,
                 const double       k,
                 const double       threshold)
  {
    const double force = std::abs(r) - threshold;
    return force <= 0. ? 0. :
                         std::copysign(law.minimiser(c, force, k, data), r);
  }



  Tensor<1, 2>
  minimise_local(const FrictionLaw  &law,
                 const double        data,
                 const Tensor<2, 2> &A,
                 const Tensor<1, 2> &r,
                 const double        k,
                 const double        threshold)
  {
    const double norm_r = std::hypot(r[0], r[1]);
    if (norm_r <= threshold)
      return Tensor<1, 2>();

    // Everything in B below is of order one, whatever the units.
    const Tensor<1, 2> e        = r / norm_r;
    const double       scale    = trace(A);
    const Tensor<2, 2> A_scaled = A / scale;

    // The shares of the matrix and of friction in the balance of forces. A
    // node that sticks is the common case: begin with friction alone.
    double matrix_share   = 0.;
    double friction_share = 1.;
    double V              = 0.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        Tensor<2, 2> B = matrix_share * A_scaled;
        B[0][0] += friction_share;
        B[1][1] += friction_share;

        const Tensor<1, 2> n      = solve(B, e);
        const Tensor<1, 2> m      = solve(B, n);
        const double       length = n.norm();
        const double       cube   = length * length * length;

        const double force = norm_r - threshold * (n * m) / cube;
        if (force <= 0.)
          return Tensor<1, 2>();
        const double next = law.minimiser(scale * (n * (A_scaled * m)) / cube,
                                          force,
                                          k * (n * m) / cube,
                                          data);
        if (next == 0.)
          return Tensor<1, 2>();

        const double matrix_force = scale * next;
        const double friction_force =
          k * law.coefficient(next, data) + threshold;
        matrix_share   = matrix_force / (matrix_force + friction_force);
        friction_share = friction_force / (matrix_force + friction_force);

        // Convergence is quadratic.
        const bool converged = next <= V * (1. + 1e-10);
        V                    = next;
        if (converged)
          break;
      }

    Tensor<2, 2> B = matrix_share * A_scaled;
    B[0][0] += friction_share;
    B[1][1] += friction_share;
    const Tensor<1, 2> n = solve(B, e);
    return V * (n / n.norm());
  }



  double
  minimise_local_beside(const FrictionLaw &law,
                        const double       data,
                        const double       c,
                        const double       r,
                        const double       k,
                        const double       w,
                        const double       threshold)
  {
    if (w == 0. || (k == 0. && threshold == 0.) || r == 0.)
      return minimise_local(law, data, c, r, k, threshold);

    // Friction slows down, and its coefficient does not fall with the slip
    // rate: this gives bounds on both sides.
    const double force = std::abs(r);
    double       upper = force / c;
    double       lower =
      force /
      (c + (k * law.coefficient(std::hypot(upper, w), data) + threshold) /
             std::abs(w));
    lower = std::max(lower, std::numeric_limits<double>::min());

    double v = std::min(lower, upper);
    for (unsigned int i = 0; i < 200 && lower < upper; ++i)
      {
        const double V        = std::hypot(v, w);
        const double secant   = (k * law.coefficient(V, data) + threshold) / V;
        const double cosine   = v / V;
        const double residual = (c + secant) * v - force;
        const double slope = c + k * law.derivative(V, data) * cosine * cosine +
                             secant * (w / V) * (w / V);
        if (residual <= 0.)
          lower = v;
        if (residual >= 0.)
          upper = v;

        double next = v - residual / slope;
        // The bounds may be many decades apart, so halve the logarithm.
        if (!(next >= lower && next <= upper))
          next = std::sqrt(lower) * std::sqrt(upper);

        const bool converged = std::abs(next - v) <= 1e-15 * v;
        v                    = next;
        if (converged)
          break;
      }
    return std::copysign(v, r);
  }
} // namespace StickSlip
