// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_coarsening_h
#define stickslip_mesh_coarsening_h

#include <stickslip/geometry/fault_topology.h>
#include <stickslip/mesh/body_mesh.h>

namespace StickSlip
{
  /** True if there is a coarser level: if a body is refined, or if all of them
   * have coarser cells than their coarse ones. */
  template <int dim>
  bool
  can_be_coarsened(const BodyMeshes<dim> &bodies);

  /**
   * The meshes of the next coarser level. Those that have much larger faces
   * than a neighbour across a fault are kept until the neighbour is as coarse
   * or as coarse as it can be. What the nodes of a coarser side do is seen in
   * the finer body at their distance, and no other level than that one smoothes
   * it there; through a thin layer they are tied to the nodes of its other
   * side, which is seen where the layer is a cell thick and they are all there.
   * Collective.
   */
  template <int dim>
  BodyMeshes<dim>
  coarsened_once(const BodyMeshes<dim> &bodies,
                 const FaultTopology   &topology,
                 const MPI_Comm        &communicator);
} // namespace StickSlip

#endif
