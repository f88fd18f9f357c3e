// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_spline_curve_h
#define stickslip_geometry_spline_curve_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A curve of continuous curvature through points of the plane: each
   * coordinate is a cubic spline of the length of the chords. At open ends the
   * third derivative is continuous at the last point but one ("not a knot"), so
   * that the distance from a smooth curve is of fourth order in the distance of
   * the points, up to the ends. A closed curve is periodic.
   */
  class SplineCurve
  {
  public:
    /** Through at least two points, three if it is closed, none of them twice
     * in a row; a closed curve joins the last one to the first. */
    SplineCurve(const std::vector<Point<2>> &points, const bool is_closed);

    /** The point of the curve nearest to a point that is near to it, m. A point
     * that the curve goes through is itself. */
    Point<2>
    nearest(const Point<2> &point) const;

  private:
    /** A cubic between two points: value and second derivatives at its ends. */
    struct Piece
    {
      Point<2>     begin, end;
      Tensor<1, 2> begin_curvature, end_curvature;
      double       length;

      /** Bound of the distance between curve and chord, m. */
      double bulge;

      Point<2>
      value(const double t) const;

      /** First and second derivative. */
      std::array<Tensor<1, 2>, 2>
      derivatives(const double t) const;

      /** The parameter of the point nearest to a point. */
      double
      nearest(const Point<2> &point) const;
    };

    std::vector<Piece> pieces;
  };
} // namespace StickSlip

#endif
