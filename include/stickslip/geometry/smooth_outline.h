// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_smooth_outline_h
#define stickslip_geometry_smooth_outline_h

#include <stickslip/geometry/fault_shape.h>
#include <stickslip/geometry/spline_curve.h>

#include <vector>

namespace StickSlip
{
  /**
   * Smooth curves through the points of lines in the plane, which go on where
   * the end of one is at that of another. A curve ends where lines end or
   * branch, and at corners, at which they turn by more than least_corner; one
   * that ends nowhere is closed. See SplineCurve.
   */
  class SmoothOutline : public FaultShape<2>
  {
  public:
    /** Points that are at the same place up to rounding are one. */
    explicit SmoothOutline(const std::vector<std::vector<Point<2>>> &lines);

    /** The nearest point of all curves. */
    virtual Point<2>
    place(const Point<2> &point) const override;

    /** Number of points that the curves go through. */
    unsigned int
    n_points() const
    {
      return n;
    }

  private:
    unsigned int             n;
    std::vector<SplineCurve> curves;
  };
} // namespace StickSlip

#endif
