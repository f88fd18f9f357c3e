// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_body_geometry_h
#define stickslip_geometry_body_geometry_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <stickslip/parameters/spatial_field.h>

#include <array>
#include <functional>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A brick-shaped body and its mesh: coarse cells, refined all over, then
   * passes that each refine every cell touching a fault, or more rows of cells
   * from there. The last axis is
   * vertical; bodies are stacked along it. The lower and the upper side may
   * have any elevation, or the upper one a slope, which makes a wedge; what is
   * between them is moved in proportion.
   *
   * A rigid body is one cell, whatever its mesh is said to be.
   */
  template <int dim>
  struct BodyGeometry
  {
    /** Lateral extent: lower and upper bound for each horizontal axis, m. */
    std::array<double, dim - 1> lateral_lower;
    std::array<double, dim - 1> lateral_upper;

    /** True where the body goes on for ever along a horizontal axis: its two
     * sides there are one, and fields repeat after its extent. */
    std::array<bool, dim - 1> periodic;

    /** Extent along the vertical axis, m; where the upper side slopes, that
     * at the lower lateral corner; where sides have an elevation, that of the
     * brick of which the body is made. */
    double thickness = 1.;

    /** Rise of the upper side along each horizontal axis, without unit. */
    std::array<double, dim - 1> upper_slope;

    /** True if the body does not deform. */
    bool rigid = false;

    /** Elevation of the lower side, m; follows from the bodies below. */
    double base = 0.;

    /** Elevation of the lower and of the upper side as functions of the
     * horizontal coordinates, m; empty: as said above. */
    std::function<double(const Point<dim> &)> lower_elevation, upper_elevation;

    /** Coarse cells along each axis. */
    std::array<unsigned int, dim> coarse_cells;

    /** Number of refinements of all cells before the passes. */
    unsigned int uniform_refinements = 0;

    /** Number of passes that refine the cells touching a fault. */
    unsigned int refinement_passes = 4;

    /** Number of rows of cells next to the fault that a pass refines. */
    unsigned int refinement_rows = 1;

    /** The passes refine where this is greater than zero. */
    SpatialField refine_where = 1.;

    /** The subsection of the entries, for messages. */
    std::string section = "Bodies";

    BodyGeometry();

    Point<dim>
    lower_corner() const;

    /** Upper corner with the thickness at the lower lateral corner. */
    Point<dim>
    upper_corner() const;

    /** Elevation of the lower side at the horizontal coordinates of a point,
     * m. */
    double
    lower_at(const Point<dim> &point) const;

    /** The thickness there, m. */
    double
    thickness_at(const Point<dim> &point) const;

    /** Position of a point of the brick from lower_corner() to upper_corner()
     * between sides that are not level: heights change in proportion. */
    Point<dim>
    placed(const Point<dim> &point) const;

    /** The point of the brick that is placed at a position. */
    Point<dim>
    in_brick(const Point<dim> &position) const;

    /** The point with horizontal coordinates beyond the sides moved to them. */
    Point<dim>
    within_sides(const Point<dim> &point) const;

    /** True if the upper side has a slope. */
    bool
    is_sloped() const;

    /** True if a side has an elevation. */
    bool
    has_elevation() const
    {
      return lower_elevation || upper_elevation;
    }

    /** Length after which fields repeat along each horizontal axis, m; zero:
     * the body ends there. */
    Tensor<1, dim - 1>
    period() const;

    /** The field above as a function; empty if the passes refine everywhere.
     * Throws InputError, see SpatialField::function(). */
    std::function<double(const Point<dim> &)>
    where_to_refine() const;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
