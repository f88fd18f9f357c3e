// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_moved_surface_h
#define stickslip_mortar_moved_surface_h

#include <stickslip/mesh/fault_surface.h>

namespace StickSlip
{
  /**
   * A surface whose nodes have moved: its points are the given @p positions,
   * m, in the order of its nodes, and each face has the normal that it has
   * there, even if all of them were in one plane. Throws ExcMessage if a face
   * has no area any more or has turned over.
   */
  template <int dim>
  FaultSurface<dim>
  moved_surface(const FaultSurface<dim>       &surface,
                const std::vector<Point<dim>> &positions);
} // namespace StickSlip

#endif
