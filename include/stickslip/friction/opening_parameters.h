// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_opening_parameters_h
#define stickslip_friction_opening_parameters_h

#include <stickslip/parameters/spatial_field.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Freedom of the two sides of a fault along its normal.
   */
  enum class ContactKind
  {
    /** Sides stay together, whatever pulls at them. */
    bilateral,
    /** Sides may part, and nothing but a bond pulls them together. */
    unilateral
  };

  /**
   * Evolution of the state at a node whose sides do not touch.
   */
  enum class OpenState
  {
    /** Evolution as at rest. */
    heals,
    /** No evolution. */
    frozen
  };

  /**
   * Opening and closing of one fault or one region of a fault, as a scene says
   * it.
   */
  struct OpeningParameters
  {
    ContactKind contact = ContactKind::bilateral;

    /** Tension that a bond withstands, Pa, and shear traction, in addition to
     * friction, that it takes for a slip, Pa. */
    SpatialField tensile_strength = 0.;
    SpatialField cohesion         = 0.;

    /** Time that the sides must touch before a bond is there again, s; zero: it
     * never is. */
    double bond_healing_time = 0.;

    /** Gap at the start, m. */
    SpatialField initial_gap = 0.;

    OpenState open_state = OpenState::heals;

    bool
    may_open() const
    {
      return contact == ContactKind::unilateral;
    }

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
