// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/polygon_clipping.h>

namespace StickSlip
{
  namespace
  {
    /**
     * Twice the area of the triangle a, b, c: positive where c lies to the left
     * of the line from a to b.
     */
    double
    orientation(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }
  } // namespace



  double
  signed_area(const Polygon &polygon)
  {
    double area = 0.;
    for (unsigned int i = 2; i < polygon.size(); ++i)
      area += orientation(polygon[0], polygon[i - 1], polygon[i]);
    return area / 2.;
  }



  bool
  is_convex_counter_clockwise(const Polygon &polygon)
  {
    const unsigned int n    = polygon.size();
    const double       area = signed_area(polygon);
    if (n < 3 || !(area > 0.))
      return false;

    // Every vertex lies to the left of every edge; this excludes stars, too.
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (j != i && j != (i + 1) % n &&
            orientation(polygon[i], polygon[(i + 1) % n], polygon[j]) <
              -1e-12 * area)
          return false;
    return true;
  }



  Polygon
  clip_convex_polygon(const Polygon &subject, const Polygon &window)
  {
    Polygon result = subject;
    for (unsigned int e = 0; e < window.size() && !result.empty(); ++e)
      {
        const Point<2> &start = window[e];
        const Point<2> &end   = window[(e + 1) % window.size()];

        Polygon  kept;
        Point<2> previous      = result.back();
        double   previous_side = orientation(start, end, previous);
        for (const Point<2> &current : result)
          {
            const double side = orientation(start, end, current);
            // Vertices on the line are kept as they are, so a crossing is
            // computed only where both distances differ from zero.
            if ((side > 0. && previous_side < 0.) ||
                (side < 0. && previous_side > 0.))
              kept.push_back(previous + previous_side / (previous_side - side) *
                                          (current - previous));
            if (side >= 0.)
              kept.push_back(current);
            previous      = current;
            previous_side = side;
          }
        result = kept;
      }
    return result;
  }
} // namespace StickSlip
