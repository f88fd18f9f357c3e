// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_common_parameters_h
#define stickslip_friction_common_parameters_h

#include <stickslip/friction/law_parameter.h>
#include <stickslip/friction/rate_and_state.h>
#include <stickslip/friction/state_evolution.h>
#include <stickslip/parameters/name_list.h>

namespace StickSlip
{
  /**
   * Parameters that several kinds of friction have, or that are read elsewhere
   * than in the law.
   */
  namespace CommonParameters
  {
    /** Direct effect a, without unit. */
    inline LawParameter
    direct_effect()
    {
      return LawParameter::field(
        "a",
        "Direct effect a of the slip rate in mu = mu0 + a ln(V/V0) + b "
        "ln(V0 theta/L)",
        "1",
        NumberRange().above(0),
        RateAndStateParameters().a);
    }

    /** Reference friction coefficient mu0, without unit. */
    inline LawParameter
    reference_friction()
    {
      return LawParameter::field(
        "Reference friction coefficient",
        "Friction coefficient mu0 at the reference slip rate",
        "1",
        NumberRange().at_least(0),
        RateAndStateParameters().reference_friction);
    }

    /** Reference slip rate V0, m/s. */
    inline LawParameter
    reference_slip_rate()
    {
      return LawParameter::field("Reference slip rate",
                                 "Reference slip rate V0",
                                 "m/s",
                                 NumberRange().above(0),
                                 RateAndStateParameters().reference_slip_rate);
    }

    /** Characteristic slip L, m: that of the state, and the measure of an error
     * of the slip. Every kind with friction has it, listed or not. */
    inline LawParameter
    characteristic_slip()
    {
      return LawParameter::field(
        "Characteristic slip",
        "Slip L over which the state evolves; without a state, the slip that "
        "matters to the size of the time steps",
        "m",
        NumberRange().above(0),
        RateAndStateParameters().characteristic_slip);
    }

    /** State law, a choice. Every kind with a state has it. */
    inline LawParameter
    state_law()
    {
      std::vector<std::string> names, descriptions;
      for (const StateLawKind &kind : state_laws())
        {
          names.push_back(kind.name);
          descriptions.push_back("the " + kind.name + " law (" +
                                 kind.description + ")");
        }
      return LawParameter::choice("State law",
                                  "Evolution of the state theta: " +
                                    join_names(descriptions, " or "),
                                  names);
    }

    /** State theta at the start, s. Every kind with a state has it. */
    inline LawParameter
    initial_state()
    {
      return LawParameter::optional_field(
        "Initial state",
        "State theta at the start (empty: that with which the initial slip "
        "rate needs the initial shear stress, or 1 s where they are not both "
        "given)",
        "s",
        NumberRange().above(0),
        1.);
    }

    /** Slip rate at the start along a horizontal axis, m/s. Every kind with
     * friction has it. */
    inline LawParameter
    initial_slip_rate(const unsigned int axis)
    {
      const std::string name(1, "xy"[axis]);
      LawParameter      parameter = LawParameter::optional_field(
        "Initial slip rate along " + name,
        "Slip rate at the start, that of the upper side relative to the lower "
             "one along " +
          name +
          " (empty: what the initial shear stress and state need, or none "
               "where no shear stress is given)",
        "m/s",
        NumberRange(),
        0.);
      parameter.least_dimension = 2 + axis;
      return parameter;
    }

    /** Shear stress at the start along a horizontal axis, Pa. Every kind with
     * friction has it. */
    inline LawParameter
    initial_shear_stress(const unsigned int axis)
    {
      const std::string name(1, "xy"[axis]);
      LawParameter      parameter = LawParameter::optional_field(
        "Initial shear stress along " + name,
        "Shear stress at the start that drives the upper side relative to the "
             "lower one along " +
          name +
          "; what the bodies do not carry of it acts on the fault for ever "
               "(empty: what the initial slip rate and state need, or what the "
               "bodies carry where no slip rate is given)",
        "Pa",
        NumberRange(),
        0.);
      parameter.least_dimension = 2 + axis;
      return parameter;
    }

    /** Prescribed slip rate along a horizontal axis, m/s. */
    inline LawParameter
    slip_rate(const unsigned int axis)
    {
      const std::string name(1, "xy"[axis]);
      LawParameter      parameter =
        LawParameter::field("Slip rate along " + name,
                            "Prescribed slip rate, that of the upper side "
                            "relative to the lower one along " +
                              name,
                            "m/s",
                            NumberRange(),
                            0.);
      parameter.least_dimension = 2 + axis;
      return parameter;
    }

    /** Time in which the prescribed slip rate grows from zero, s. */
    inline LawParameter
    slip_rate_ramp_length()
    {
      return LawParameter::number(
        "Slip rate ramp length",
        "Time in which the prescribed slip rate grows "
        "smoothly from zero, by half a cosine (0: it "
        "is there from the start)",
        "s",
        NumberRange().at_least(0),
        0.);
    }
  } // namespace CommonParameters
} // namespace StickSlip

#endif
