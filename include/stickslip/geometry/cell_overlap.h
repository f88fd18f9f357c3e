// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_cell_overlap_h
#define stickslip_geometry_cell_overlap_h

#include <stickslip/geometry/cell_faces.h>

namespace StickSlip
{
  /**
   * Throws InputError if cells overlap, by more than meshes of curved sides do
   * that do not match: if the centre of a cell, or a point a quarter of the way
   * from a vertex to it, is inside another cell.
   */
  template <int dim>
  void
  check_overlap(const GroupedCells<dim> &mesh, const CellFaces<dim> &faces);
} // namespace StickSlip

#endif
