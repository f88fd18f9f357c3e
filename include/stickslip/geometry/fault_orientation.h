// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_fault_orientation_h
#define stickslip_geometry_fault_orientation_h

#include <stickslip/geometry/cell_faces.h>
#include <stickslip/geometry/mesh_fault.h>

namespace StickSlip
{
  /**
   * Flags of the @p fault_faces, true where the first cell is on the first
   * side of the fault. Faces that meet have the same sides; which of the two is
   * the first one is told by the fault (MeshFault::between), for each connected
   * part of it.
   *
   * Throws InputError if more than two faces of the fault meet, if it has one
   * side only like a Moebius strip, or if the bodies on its sides are not those
   * of MeshFault::between.
   */
  template <int dim>
  std::vector<bool>
  orient_fault(const GroupedCells<dim>         &mesh,
               const CellFaces<dim>            &faces,
               const std::vector<unsigned int> &fault_faces,
               const MeshFault                 &fault);
} // namespace StickSlip

#endif
