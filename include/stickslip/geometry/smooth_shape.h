// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_smooth_shape_h
#define stickslip_geometry_smooth_shape_h

#include <stickslip/geometry/fault_shape.h>

namespace StickSlip
{
  /**
   * A smooth curve or surface through the vertices of a fault of the coarse
   * mesh: those of the side that has more of them, the first one if both have
   * as many. A vertex or an edge at which the faces turn by more than
   * least_corner stays as it is; see SplineCurve and SmoothSurface. A fault may
   * have several parts, and closed ones. In three dimensions, points on plane
   * outer sides, and those of faults that are cut there, stay on these.
   */
  template <int dim>
  std::shared_ptr<const FaultShape<dim>>
  smooth_shape(const std::vector<BodyCells<dim>> &bodies, const Fault &fault);
} // namespace StickSlip

#endif
