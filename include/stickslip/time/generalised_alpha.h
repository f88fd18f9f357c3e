// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_generalised_alpha_h
#define stickslip_time_generalised_alpha_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * The generalised-alpha method (Chung and Hulbert 1993) with the velocity at
   * the end of the step as the unknown, in the form of Arnold and Bruels
   * (2007): the equation of motion holds at the end of the step,
   *
   *   M v1' + C v1 + K u1 + friction(v1) = f1,
   *
   * and Newmark's formulas use an auxiliary acceleration a,
   *
   *   v1 = v0 + tau ((1 - gamma) a0 + gamma a1),
   *   u1 = u0 + tau v0 + tau^2 ((1/2 - beta) a0 + beta a1),
   *   (1 - alpha_m) a1 + alpha_m a0 = (1 - alpha_f) v1' + alpha_f v0'.
   *
   * So friction is that of the new velocity, and the rate problem a convex
   * minimisation as with Newmark's method. Second order; oscillations too fast
   * for the step size are damped by the factor rho in each step: not at all
   * with rho = 1, which is Newmark's method with beta = 1/4, gamma = 1/2, and
   * within a step with rho = 0.
   */
  class GeneralisedAlpha
  {
  public:
    /** @p spectral_radius: rho, from 0 to 1. */
    explicit GeneralisedAlpha(const double spectral_radius);

    /** Coefficients of mass, damping and stiffness in the operator. */
    std::vector<double>
    operator_coefficients(const double tau) const;

    /** The right hand side, a dual vector of the jump basis. */
    template <int dim>
    NodalVector
    right_hand_side(SpatialProblem<dim>    &problem,
                    const SystemState<dim> &from,
                    const double            tau) const;

    /** Displacement and accelerations of @p to from its velocity. */
    template <int dim>
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const;

  private:
    const double alpha_m, alpha_f, gamma, beta;
  };
} // namespace StickSlip

#endif
