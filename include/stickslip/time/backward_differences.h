// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_backward_differences_h
#define stickslip_time_backward_differences_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * The backward differentiation formula of second order with steps of any
   * size (Hairer, Noersett and Wanner 1993), for problems without mass,
   *
   *   C v1 + K u1 + friction(v1) = f1,
   *
   * with the velocity at the end of the step as the unknown. With the mean
   * velocity d0 over the last step, of size tau0, and r = tau / tau0,
   *
   *   u1 = u0 + tau (w0 d0 + w1 v1),   w0 = r / (1 + 2 r),
   *                                    w1 = (1 + r) / (1 + 2 r).
   *
   * The first step takes the trapezoidal rule with the velocity at the start.
   *
   * Of second order and stiffly accurate: what follows the loads at once, as
   * bodies do that neither mass nor viscosity holds back, has the velocity of
   * its displacements. The trapezoidal rule would let that velocity swing about
   * its mean from step to step, for ever.
   */
  namespace BackwardDifferences
  {
    /** Coefficients of mass, which is zero, damping and stiffness in the
     * operator. */
    template <int dim>
    std::vector<double>
    operator_coefficients(const SystemState<dim> &from, const double tau);

    /** The right hand side, a dual vector of the jump basis. */
    template <int dim>
    NodalVector
    right_hand_side(SpatialProblem<dim>    &problem,
                    const SystemState<dim> &from,
                    const double            tau);

    /** Displacement, slip and their mean rates over the step from velocity and
     * slip rate of @p to. */
    template <int dim>
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau);

    /** Local error of the displacement over its third derivative, s^3, after a
     * step of size @p last. */
    double
    error_constant(const double tau, const double last);
  } // namespace BackwardDifferences
} // namespace StickSlip

#endif
