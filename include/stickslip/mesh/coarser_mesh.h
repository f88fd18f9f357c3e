// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_coarser_mesh_h
#define stickslip_mesh_coarser_mesh_h

#include <stickslip/geometry/fault_cutting.h>

namespace StickSlip
{
  /**
   * Give the sides of a mesh the boundary indicators that those of the same
   * names have in a finer mesh of the same bodies. The meshes need not be
   * nested.
   *
   * Throws InputError if a body has other sides, is as fine as the finer one,
   * or if one of both does not cover the other, by more than half of the size
   * of a cell at the place, which is what curved sides need.
   */
  template <int dim>
  void
  match_to_finer(const CutMesh<dim> &finer, CutMesh<dim> &coarser);
} // namespace StickSlip

#endif
