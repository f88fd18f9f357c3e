// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/opening_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  OpeningParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Contact",
      contact,
      {{ContactKind::bilateral, "bilateral"},
       {ContactKind::unilateral, "unilateral"}},
      "Whether the sides of the fault always touch (bilateral), or may "
      "part and close again (unilateral): no pressure pulls then, an "
      "open fault has no friction, and the normal stress in the "
      "friction law follows the contact pressure whatever 'Normal "
      "stress follows' says. The faults are closed and stuck in the "
      "equilibrium at the start.");
    add_field(prm,
              "Tensile strength",
              tensile_strength,
              NumberRange().at_least(0).in("Pa"),
              "Tension that keeps a unilateral fault from opening where its "
              "sides are bonded, in Pa. The bond breaks when they part.");
    add_field(prm,
              "Cohesion",
              cohesion,
              NumberRange().at_least(0).in("Pa"),
              "Shear traction beyond that of friction up to which a bond of a "
              "unilateral fault allows no slip, in Pa. The bond breaks when "
              "the fault slips or opens.");
    add_number(prm,
               "Bond healing time",
               bond_healing_time,
               NumberRange().at_least(0).in("s"),
               "Time for which the sides must touch after a bond has broken "
               "before they are bonded again, in s (0: they never are).");
    add_field(prm,
              "Initial gap",
              initial_gap,
              NumberRange().at_least(0).in("m"),
              "Gap between the sides of a unilateral fault at the start, in m: "
              "what the bodies may approach each other before they touch.");
    add_choice(
      prm,
      "State while open",
      open_state,
      {{OpenState::heals, "heal"}, {OpenState::frozen, "frozen"}},
      "Whether the state evolves as on a fault at rest (heal) or stays "
      "as it is (frozen) where the sides of a unilateral fault do not "
      "touch.");
  }
} // namespace StickSlip
