// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/contact_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    add_switch(prm,
               "Follow slip",
               follow_slip,
               "Whether the contact mapping of the faults follows large slip; "
               "without, that of the reference positions is kept.");
    add_number(prm,
               "Rebuild fraction",
               rebuild_fraction,
               NumberRange().at_least(0).at_most(1),
               "The mapping is rebuilt as soon as a node has slid farther than "
               "this fraction of the smallest fault face since the last time, "
               "without unit; 0: 1/16 at faults that bend, 1/4 at others.");
  }
} // namespace StickSlip
