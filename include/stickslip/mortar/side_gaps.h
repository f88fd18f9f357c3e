// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_side_gaps_h
#define stickslip_mortar_side_gaps_h

#include <stickslip/mortar/slave_weights.h>

namespace StickSlip
{
  /**
   * The means of the gap between two curved sides over the dual functions of
   * the slave nodes, m: by how much the slave side is above the master side
   * along its outward normal, that is, reaches into it. NaN where less than
   * active_weight_fraction of a node's weight is covered. For the positions,
   * see build_mortar_coupling(); nodes may have slid ahead of the points of the
   * surfaces, which tell how these are curved.
   *
   * The gap is that of smooth sides, of which the faces are chords: with the
   * slopes s_v that the nodal normals say at the vertices x_v of a face, each
   * side is above its face by
   *
   *   b(x) = 1/2 sum_v phi_v(x) s_v . (x - x_v),
   *
   * half of what the tangent planes at the vertices, weighted by the shape
   * functions, are above it. This is exact for surfaces of second degree.
   *
   * If a @p range of slave nodes is given, gaps of others are NaN. Throws
   * ExcMessage as compute_face_overlap() does.
   */
  template <int dim>
  std::vector<double>
  side_gaps(const FaultSurface<dim>       &slave,
            const std::vector<Point<dim>> &slave_positions,
            const FaultSurface<dim>       &master,
            const std::vector<Point<dim>> &master_positions,
            const SlaveRange              &range = {});
} // namespace StickSlip

#endif
