// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_polygon_clipping_h
#define stickslip_mortar_polygon_clipping_h

#include <deal.II/base/point.h>

#include <boost/container/small_vector.hpp>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The vertices of a polygon in a plane, one after the other around it. Two
   * quadrilaterals have at most eight in common.
   */
  using Polygon = boost::container::small_vector<Point<2>, 12>;

  /**
   * Area of a polygon, positive if its vertices run counter-clockwise; that is
   * relative to its first vertex, so small polygons far from the origin lose
   * no digits.
   */
  double
  signed_area(const Polygon &polygon);

  /**
   * True if the vertices run counter-clockwise around a convex polygon of
   * positive area. Angles of 180 degrees are allowed.
   */
  bool
  is_convex_counter_clockwise(const Polygon &polygon);

  /**
   * The part of @p subject inside @p window, both convex and
   * counter-clockwise, by the algorithm of Sutherland and Hodgman (1974). The
   * result has fewer than three vertices or an area of rounding size where
   * they only touch, and may hold vertices that coincide.
   */
  Polygon
  clip_convex_polygon(const Polygon &subject, const Polygon &window);
} // namespace StickSlip

#endif
