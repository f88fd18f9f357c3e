// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_common_parameters_h
#define stickslip_friction_common_parameters_h

#include <stickslip/friction/law_parameter.h>

namespace StickSlip
{
  /**
   * Parameters that several kinds of friction have, or that are read elsewhere
   * than in the law.
   */
  namespace CommonParameters
  {
    /** Direct effect a, without unit. */
    LawParameter
    direct_effect();

    /** Reference friction coefficient mu0, without unit. */
    LawParameter
    reference_friction();

    /** Reference slip rate V0, m/s. */
    LawParameter
    reference_slip_rate();

    /** Characteristic slip L, m: that of the state, and the measure of an error
     * of the slip. Every kind with friction has it, listed or not. */
    LawParameter
    characteristic_slip();

    /** State law, a choice. Every kind with a state has it. */
    LawParameter
    state_law();

    /** State theta at the start, s. Every kind with a state has it. */
    LawParameter
    initial_state();

    /** Prescribed slip rate along a horizontal axis, m/s. */
    LawParameter
    slip_rate(const unsigned int axis);

    /** Time in which the prescribed slip rate grows from zero, s. */
    LawParameter
    slip_rate_ramp_length();
  } // namespace CommonParameters
} // namespace StickSlip

#endif
