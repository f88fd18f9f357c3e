// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_node_opening_h
#define stickslip_faults_node_opening_h

namespace StickSlip
{
  /**
   * Freedom of a slave node along the normal.
   */
  struct NodeOpening
  {
    bool may_open = false;

    /** Strength of a bond against tension and against slip, Pa, and the time of
     * contact after which a broken one is there again, s; zero: never. */
    double tensile_strength = 0, cohesion = 0, bond_healing_time = 0;

    /** Gap at the start, m. */
    double initial_gap = 0;
  };
} // namespace StickSlip

#endif
