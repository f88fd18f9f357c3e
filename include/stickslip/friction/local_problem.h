// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_local_problem_h
#define stickslip_friction_local_problem_h

#include <deal.II/base/tensor.h>

#include <stickslip/friction/friction_law.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The minimiser v of
   *
   *   1/2 c v^2 - r v + k Phi(|v|) + s |v|,   c > 0, k >= 0, s >= 0,
   *
   * where Phi is the potential of @p law at a node with the given @p data and
   * s a @p threshold, the force below which nothing moves. Exact up to
   * rounding.
   */
  double
  minimise_local(const FrictionLaw &law,
                 const double       data,
                 const double       c,
                 const double       r,
                 const double       k,
                 const double       threshold = 0.);

  /**
   * The minimiser v of
   *
   *   1/2 v . A v - r . v + k Phi(|v|) + s |v|
   *
   * for a symmetric positive definite matrix A. Exact up to rounding times the
   * condition number of A.
   *
   * A minimiser v = V n with |n| = 1 balances the forces,
   * (V A + p I) n = r, where p = k mu(V) + s. So V is the solution of
   *
   *   N(V, p) = 1,   N(V, p) = 1 / |(V A + p I)^-1 r|.
   *
   * N is concave, homogeneous of degree one and increasing in both
   * arguments. Its tangent plane at any point turns the equation into a scalar
   * local problem, N_V V + N_p (k mu(V) + s) = 1, which the law solves exactly:
   * a Newton iteration that leaves the strong nonlinearity of mu alone, and
   * that climbs monotonically to the solution from any start. If A is a
   * multiple of the identity, the first step is exact.
   */
  Tensor<1, 2>
  minimise_local(const FrictionLaw  &law,
                 const double        data,
                 const Tensor<2, 2> &A,
                 const Tensor<1, 2> &r,
                 const double        k,
                 const double        threshold = 0.);

  /**
   * The minimiser v of
   *
   *   1/2 c v^2 - r v + (k Phi + s)(sqrt(v^2 + w^2)),   c > 0, k >= 0, s >= 0,
   *
   * where the other tangential component w is prescribed. Exact up to
   * rounding.
   */
  double
  minimise_local_beside(const FrictionLaw &law,
                        const double       data,
                        const double       c,
                        const double       r,
                        const double       k,
                        const double       w,
                        const double       threshold = 0.);
} // namespace StickSlip

#endif
