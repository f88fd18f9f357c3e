// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/fault_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  FaultParameters::add_parameters(ParameterHandler &prm)
  {
    rate_and_state.add_parameters(prm);
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
    add_field(prm,
              "Initial state",
              initial_state,
              NumberRange().above(0),
              "State theta at the start, in s.");
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
    add_field(prm,
              "Normal stress function",
              normal_stress,
              NumberRange().at_least(0),
              "The given normal stress, in Pa, compression positive. Used only "
              "with 'Normal stress = function'.");
  }



  std::string
  FaultParameters::section() const
  {
    return "Faults/" + name;
  }
} // namespace StickSlip
