// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_newmark_h
#define stickslip_time_newmark_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * Newmark's method with beta = 1/4, gamma = 1/2, with the velocity at the
   * end of the step as the unknown:
   *
   *   u1 = u0 + tau/2 (v0 + v1),   a1 = 2/tau (v1 - v0) - a0,
   *
   * which turns the equation of motion at the end of the step into
   *
   *   (2/tau M + C + tau/2 K) v1 + friction(v1)
   *     = f1 + M (2/tau v0 + a0) - K (u0 + tau/2 v0).
   *
   * Second order, without numerical damping (Newmark 1959; Hairer, Lubich and
   * Wanner 2006).
   */
  namespace Newmark
  {
    /** Coefficients of mass, damping and stiffness in the operator. */
    std::vector<double>
    operator_coefficients(const double tau);

    /** The right hand side, a dual vector of the jump basis. */
    template <int dim>
    NodalVector
    right_hand_side(SpatialProblem<dim>    &problem,
                    const SystemState<dim> &from,
                    const double            tau);

    /** Displacement and acceleration of @p to from its velocity. */
    template <int dim>
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau);
  } // namespace Newmark
} // namespace StickSlip

#endif
