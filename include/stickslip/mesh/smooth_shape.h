// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_smooth_shape_h
#define stickslip_mesh_smooth_shape_h

#include <stickslip/mesh/fault_shape.h>

namespace StickSlip
{
  /** By how much a polygonal line turns at a corner at least, degrees. */
  constexpr double least_corner = 50.;

  /**
   * Smooth curves through the vertices of a fault of the coarse mesh: those of
   * the side that has more of them, the first one if both have as many. A
   * vertex at which the faces turn by more than least_corner stays a corner,
   * others are passed with continuous curvature; see SplineCurve. A fault may
   * have several parts, and closed ones.
   *
   * For two dimensions; throws InputError in three.
   */
  template <int dim>
  std::shared_ptr<const FaultShape<dim>>
  smooth_shape(const std::vector<BodyCells<dim>> &bodies, const Fault &fault);
} // namespace StickSlip

#endif
