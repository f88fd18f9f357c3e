// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_height_function_h
#define stickslip_geometry_height_function_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A surface near one of its points: the height over a plane through the
   * point, as a polynomial of at most third degree that is zero at the point.
   */
  class HeightFunction
  {
  public:
    /** Number of the terms of the polynomial of third degree. */
    static constexpr unsigned int n_terms = 9;

    /** The plane through @p origin that @p normal, a unit vector, is on. */
    HeightFunction(const Point<3> &origin, const Tensor<1, 3> &normal);

    /**
     * Fit the polynomial to @p points of the surface in the sense of least
     * squares, near ones with more weight. Return false, and leave the height
     * zero, if these points do not determine one of this degree, 1 to 3, well.
     */
    bool
    fit(const std::vector<Point<3>> &points, const unsigned int degree);

    /** The place on the surface of a point near to it, moved along a direction
     * that is not in the plane, m. */
    Point<3>
    moved_along(const Point<3> &point, const Tensor<1, 3> &direction) const;

    const Tensor<1, 3> &
    plane_normal() const
    {
      return normal;
    }

  private:
    /** Coordinates along the tangents and the normal, in units of the size. */
    std::array<double, 3>
    components(const Tensor<1, 3> &vector) const;

    Point<3>                    origin;
    std::array<Tensor<1, 3>, 2> tangents;
    Tensor<1, 3>                normal;

    /** Unit of length, m, and coefficients of the terms in it. */
    double                      size         = 1.;
    std::array<double, n_terms> coefficients = {};
  };
} // namespace StickSlip

#endif
