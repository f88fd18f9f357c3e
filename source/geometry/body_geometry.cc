// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/body_geometry.h>
#include <stickslip/parameters/entries.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  BodyGeometry<dim>::BodyGeometry()
  {
    lateral_lower.fill(-2.5);
    lateral_upper.fill(2.5);
    periodic.fill(false);
    coarse_cells.fill(10);
    coarse_cells[dim - 1] = 2;
    upper_slope.fill(0.);
  }



  template <int dim>
  Point<dim>
  BodyGeometry<dim>::lower_corner() const
  {
    Point<dim> corner;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      corner[axis] = lateral_lower[axis];
    corner[dim - 1] = base;
    return corner;
  }



  template <int dim>
  Point<dim>
  BodyGeometry<dim>::upper_corner() const
  {
    Point<dim> corner;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      corner[axis] = lateral_upper[axis];
    corner[dim - 1] = base + thickness;
    return corner;
  }



  template <int dim>
  double
  BodyGeometry<dim>::lower_at(const Point<dim> &point) const
  {
    return lower_elevation ? lower_elevation(point) : base;
  }



  template <int dim>
  double
  BodyGeometry<dim>::thickness_at(const Point<dim> &point) const
  {
    if (upper_elevation)
      return upper_elevation(point) - lower_at(point);
    double result = thickness;
    if (lower_elevation)
      result -= lower_elevation(point) - base;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      result += upper_slope[axis] * (point[axis] - lateral_lower[axis]);
    return result;
  }



  template <int dim>
  Point<dim>
  BodyGeometry<dim>::placed(const Point<dim> &point) const
  {
    Point<dim> result = point;
    result[dim - 1]   = lower_at(point) +
                      (point[dim - 1] - base) * thickness_at(point) / thickness;
    return result;
  }



  template <int dim>
  Point<dim>
  BodyGeometry<dim>::in_brick(const Point<dim> &position) const
  {
    Point<dim> result = position;
    result[dim - 1]   = base + (position[dim - 1] - lower_at(position)) *
                               thickness / thickness_at(position);
    return result;
  }



  template <int dim>
  Point<dim>
  BodyGeometry<dim>::within_sides(const Point<dim> &point) const
  {
    Point<dim> result = point;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      result[axis] = std::min(std::max(point[axis], lateral_lower[axis]),
                              lateral_upper[axis]);
    return result;
  }



  template <int dim>
  bool
  BodyGeometry<dim>::is_sloped() const
  {
    return std::any_of(upper_slope.begin(),
                       upper_slope.end(),
                       [](const double slope) { return slope != 0.; });
  }



  template <int dim>
  Tensor<1, dim - 1>
  BodyGeometry<dim>::period() const
  {
    Tensor<1, dim - 1> period;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (periodic[axis])
        period[axis] = lateral_upper[axis] - lateral_lower[axis];
    return period;
  }



  template <int dim>
  std::function<double(const Point<dim> &)>
  BodyGeometry<dim>::where_to_refine() const
  {
    if (refine_where.is_constant() && refine_where.constant() > 0)
      return {};
    return refine_where.function<dim>(section);
  }



  template <int dim>
  void
  BodyGeometry<dim>::add_parameters(ParameterHandler &prm)
  {
    add_numbers(prm,
                "Lower lateral corner",
                lateral_lower,
                NumberRange().in("m"),
                "Lower bound of the body along each horizontal axis, in m: x "
                "in two dimensions; x, y in three.");
    add_numbers(prm,
                "Upper lateral corner",
                lateral_upper,
                NumberRange().in("m"),
                "Upper bound of the body along each horizontal axis, in m.");
    add_number(prm,
               "Thickness",
               thickness,
               NumberRange().above(0).in("m"),
               "Extent along the vertical axis, in m; where the upper side "
               "slopes, that at the lower lateral corner. The elevation of a "
               "fault follows from those below it, unless it has one of its "
               "own.");
    add_numbers(prm,
                "Upper slope",
                upper_slope,
                NumberRange(),
                "By how much the upper side rises along each horizontal axis, "
                "in m/m: a wedge. The highest body only; faults have an "
                "'Elevation'.");
    add_switch(prm,
               "Rigid",
               rigid,
               "Whether the body does not deform: a foundation. It has no "
               "unknowns, and its mesh and material are not used, but for the "
               "density in a lithostatic normal stress below it. It does not "
               "move, or moves as the boundary condition of one of its sides "
               "says.");
    add_numbers(prm,
                "Coarse cells",
                coarse_cells,
                NumberRange().whole().at_least(1).at_most(100000),
                "Number of cells of the coarsest mesh along each axis, the "
                "vertical one last. The solver does best with cells not more "
                "than twice as long as wide.");
    add_count(prm,
              "Uniform refinements",
              uniform_refinements,
              0,
              20,
              "How many times all cells are halved, before the refinement "
              "passes. Like those, these are levels of the multigrid method.");
    add_count(prm,
              "Refinement passes",
              refinement_passes,
              0,
              20,
              "How many times all cells that touch a fault are halved.");
    add_count(prm,
              "Refinement rows",
              refinement_rows,
              1,
              100,
              "How many rows of cells a pass halves: those that touch the "
              "fault, those that touch these, and so on. Cells at a distance "
              "from the fault are about this part of it.");
    add_field(prm,
              "Refine where",
              refine_where,
              NumberRange().in_any_unit(),
              "The passes halve the cells that touch a fault where this is "
              "greater than 0, as in 'y + 36e3'.");
  }



  template struct BodyGeometry<2>;
  template struct BodyGeometry<3>;
} // namespace StickSlip
