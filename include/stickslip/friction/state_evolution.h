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
} // namespace StickSlip

#endif
