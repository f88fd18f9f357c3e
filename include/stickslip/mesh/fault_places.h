// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_fault_places_h
#define stickslip_mesh_fault_places_h

#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mesh/nodal_prolongation.h>

#include <vector>

namespace StickSlip
{
  /**
   * The places on the surface @p fine of the nodes of the surface @p coarse. A
   * coarse node is at the place of the fine node whose row of the
   * @p prolongation is that node alone; if there is none, since meshes are not
   * nested, at that of the nearest one.
   */
  template <int dim>
  std::vector<unsigned int>
  places_on_finer(const FaultSurface<dim> &coarse,
                  const FaultSurface<dim> &fine,
                  const NodalProlongation &prolongation);
} // namespace StickSlip

#endif
