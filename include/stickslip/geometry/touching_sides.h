// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_touching_sides_h
#define stickslip_geometry_touching_sides_h

#include <stickslip/geometry/body_cells.h>
#include <stickslip/geometry/fault_topology.h>

namespace StickSlip
{
  /**
   * Throws InputError if a part of a side of a fault is nowhere opposite to the
   * other side, or off it by more than a tenth of the size of the faces there,
   * which is what meshes of curved sides need that do not match; where the
   * sides may be apart (Fault::may_be_apart), by more than the size of the
   * faces, beyond which they would not find each other.
   *
   * @p bodies in the order of the topology.
   */
  template <int dim>
  void
  check_sides_touch(const std::vector<BodyCells<dim>> &bodies,
                    const std::vector<std::string>    &body_names,
                    const Fault                       &fault);
} // namespace StickSlip

#endif
