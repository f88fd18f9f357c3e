// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_state_evolution_h
#define stickslip_friction_state_evolution_h

namespace StickSlip
{
  /**
   * Evolution of the state alpha = ln(theta / 1 s).
   */
  enum class StateLaw
  {
    /** Dieterich: alpha' = exp(-alpha) - V/L. */
    aging,
    /** Ruina: alpha' = -(V/L) (alpha + ln(V/L)). */
    slip
  };

  /**
   * The update of the state over one step.
   */
  enum class StateUpdate
  {
    /** Exact solution for the step's mean slip rate; second order. */
    exponential,
    /** Variational implicit Euler step at the final slip rate; first order. */
    implicit_euler
  };

  /**
   * alpha', 1/s, at the slip rate V >= 0 (m/s) with the characteristic slip L
   * (m).
   */
  double
  state_rate(const StateLaw law,
             const double   alpha,
             const double   V,
             const double   L);

  /**
   * The state at which alpha' = 0, ln(L/V) for both laws. Infinity at V = 0.
   */
  double
  steady_state(const double V, const double L);

  /**
   * The state at the end of a step of length @p tau >= 0 (s) with the slip
   * rate V >= 0 (m/s), from @p alpha at its beginning. With g = V tau / L:
   *
   * Exponential, the exact solution at constant V:
   *
   *   aging: theta1 = theta0 exp(-g) + tau (1 - exp(-g)) / g,
   *   slip:  alpha1 + ln(V/L) = (alpha0 + ln(V/L)) exp(-g).
   *
   * Implicit Euler, the minimiser of (alpha1 - alpha0)^2 / (2 tau)
   * + psi(alpha1; V), where psi is the convex function of which alpha' is the
   * negative derivative:
   *
   *   aging: alpha1 - alpha0 = tau (exp(-alpha1) - V/L), by wright_omega(),
   *   slip:  alpha1 - alpha0 = -g (alpha1 + ln(V/L)).
   *
   * Neither theta nor its inverse is ever formed, so that any state may occur.
   */
  double
  updated_state(const StateLaw    law,
                const StateUpdate update,
                const double      alpha,
                const double      V,
                const double      L,
                const double      tau);

  /**
   * chi = -d alpha1 / d ln V for the result alpha1 of updated_state() with the
   * same arguments, dimensionless. It is zero at V = 0 and tends to 1 for
   * V tau / L -> infinity.
   */
  double
  state_sensitivity(const StateLaw    law,
                    const StateUpdate update,
                    const double      alpha,
                    const double      V,
                    const double      L,
                    const double      tau);
} // namespace StickSlip

#endif
