// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_rate_and_state_h
#define stickslip_friction_rate_and_state_h

namespace StickSlip
{
  /**
   * The two convex regularisations of the friction coefficient at V -> 0.
   */
  enum class Regularisation
  {
    /** mu = a max(0, ln(V / Vmin)) */
    truncated,
    /** mu = a asinh(V / (2 Vmin)) */
    arcsinh
  };

  /**
   * Parameters of mu(V, theta) = mu0 + a ln(V/V0) + b ln(V0 theta / L).
   */
  struct RateAndStateParameters
  {
    /** Direct effect a. */
    double a = 0.010;
    /** Evolution effect b. */
    double b = 0.015;
    /** Reference friction coefficient mu0. */
    double reference_friction = 0.6;
    /** Reference slip rate V0, m/s. */
    double reference_slip_rate = 1e-6;
    /** Characteristic slip L, m. */
    double characteristic_slip = 2e-5;
  };
} // namespace StickSlip

#endif
