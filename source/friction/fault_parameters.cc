// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/fault_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  FaultParameters::add_parameters(ParameterHandler &prm)
  {
    add_number(prm,
               "a",
               rate_and_state.a,
               NumberRange().above(0),
               "Direct effect a of the slip rate in mu = mu0 + a ln(V/V0) + b "
               "ln(V0 theta/L), without unit.");
    add_number(prm,
               "b",
               rate_and_state.b,
               NumberRange().at_least(0),
               "Evolution effect b of the state, without unit. The fault can "
               "be unstable only if b > a.");
    add_number(prm,
               "Reference friction coefficient",
               rate_and_state.reference_friction,
               NumberRange().at_least(0),
               "Friction coefficient mu0 at the reference slip rate, without "
               "unit.");
    add_number(prm,
               "Reference slip rate",
               rate_and_state.reference_slip_rate,
               NumberRange().above(0),
               "Reference slip rate V0, in m/s.");
    add_number(prm,
               "Characteristic slip",
               rate_and_state.characteristic_slip,
               NumberRange().above(0),
               "Slip L over which the state evolves, in m.");
    add_choice(prm,
               "State law",
               state_law,
               {{StateLaw::aging, "aging"}, {StateLaw::slip, "slip"}},
               "Evolution of the state theta: the aging law (Dieterich) or "
               "the slip law (Ruina).");
    add_choice(prm,
               "Regularisation",
               regularisation,
               {{Regularisation::truncated, "truncated"},
                {Regularisation::arcsinh, "arcsinh"}},
               "Friction coefficient as V tends to 0: a max(0, ln(V/Vmin)), or "
               "a asinh(V/(2 Vmin)).");
    add_text(prm,
             "Initial state",
             initial_state,
             "State theta at the start, in s, greater than 0: an expression in "
             "the coordinates x, y (z), in m.");
    add_choice(prm,
               "Normal stress",
               normal_stress_source,
               {{NormalStressSource::initial_equilibrium,
                 "initial equilibrium"},
                {NormalStressSource::lithostatic, "lithostatic"},
                {NormalStressSource::function, "function"}},
               "Normal stress in the friction law: from the contact force of "
               "the initial equilibrium, from the weight of the bodies above, "
               "or a given function.");
    add_text(prm,
             "Normal stress function",
             normal_stress,
             "The given normal stress, in Pa, compression positive, at least "
             "0: an expression in the coordinates x, y (z), in m. Used only "
             "with 'Normal stress = function'.");
  }
} // namespace StickSlip
