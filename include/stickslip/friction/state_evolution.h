// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_state_evolution_h
#define stickslip_friction_state_evolution_h

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Update of the state over one step.
   */
  enum class StateUpdate
  {
    /** Exact solution for the mean slip rate of the step; second order. */
    exponential,
    /** Variational implicit Euler step at the final slip rate; first order. */
    implicit_euler
  };

  /**
   * Law of evolution of the state alpha = ln(theta / 1 s) at a point: the
   * negative derivative of a convex function psi of alpha at each slip rate.
   */
  class StateLaw
  {
  public:
    virtual ~StateLaw() = default;

    /**
     * alpha', 1/s, at the slip rate V >= 0 (m/s) with the characteristic slip L
     * (m).
     */
    virtual double
    rate(const double alpha, const double V, const double L) const = 0;

    /**
     * State at the end of a step of length @p tau >= 0 (s) with the slip rate
     * V >= 0 (m/s), from @p alpha at its beginning: the exact solution at
     * constant V, or the minimiser alpha1 of (alpha1 - alpha)^2 / (2 tau) +
     * psi(alpha1; V) of an implicit Euler step. Neither theta nor its inverse
     * is ever formed, so that any state may occur.
     */
    virtual double
    updated(const StateUpdate update,
            const double      alpha,
            const double      V,
            const double      L,
            const double      tau) const = 0;
  };



  /**
   * A state law, as the entry 'State law' of a parameter file names it.
   */
  struct StateLawKind
  {
    /** Word of the entry. */
    std::string name;

    /** Author of the law, for the documentation of the entry. */
    std::string description;

    std::shared_ptr<const StateLaw> law;
  };

  /**
   * All state laws that a scene may name; the first one is the default. With
   * g = V tau / L they are
   *
   * - Dieterich's law (aging), alpha' = exp(-alpha) - V/L:
   *
   *     exponential:     theta1 = theta0 exp(-g) + tau (1 - exp(-g)) / g,
   *     implicit Euler:  alpha1 - alpha0 = tau (exp(-alpha1) - V/L), by
   *                      wright_omega();
   *
   * - Ruina's law (slip), alpha' = -(V/L) (alpha + ln(V/L)):
   *
   *     exponential:     alpha1 + ln(V/L) = (alpha0 + ln(V/L)) exp(-g),
   *     implicit Euler:  alpha1 - alpha0 = -g (alpha1 + ln(V/L)).
   */
  const std::vector<StateLawKind> &
  state_laws();
} // namespace StickSlip

#endif
