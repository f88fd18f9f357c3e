// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_deformation_h
#define stickslip_mechanics_deformation_h

namespace StickSlip
{
  /**
   * Displacements of bodies in two dimensions.
   */
  enum class Deformation
  {
    /** Both components in the plane. */
    plane_strain,
    /** The component out of the plane alone, which all stresses on faults and
     * sides are along, too. */
    antiplane
  };
} // namespace StickSlip

#endif
