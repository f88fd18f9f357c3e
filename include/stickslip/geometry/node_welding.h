// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_node_welding_h
#define stickslip_geometry_node_welding_h

#include <stickslip/geometry/cell_faces.h>

namespace StickSlip
{
  /**
   * Join the doubled nodes of a mesh that is open at some groups of faces
   * already: where a face of these groups has one cell, and another face with
   * one cell is at the same place, both get the same nodes.
   *
   * @p is_welded: for each group whether that is to be done.
   */
  template <int dim>
  void
  weld_nodes(GroupedCells<dim> &mesh, const std::vector<bool> &is_welded);

  /**
   * Pairs of faces with one cell each that are at the same place but have
   * different nodes, by their numbers.
   */
  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  touching_faces(const GroupedCells<dim> &mesh, const CellFaces<dim> &faces);
} // namespace StickSlip

#endif
