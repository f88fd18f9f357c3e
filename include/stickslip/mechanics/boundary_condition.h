// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_boundary_condition_h
#define stickslip_mechanics_boundary_condition_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The kind of condition for one component on one side of a body.
   */
  enum class BoundaryType
  {
    /** No traction. */
    free,
    /** No displacement. */
    fixed,
    /** The velocity is a given function of position and time, m/s. */
    velocity,
    /** The traction is a given function of position and time, Pa. */
    traction
  };

  /**
   * The directions of the components of a condition.
   */
  enum class BoundaryAxes
  {
    /** The axes of space. */
    space,
    /** Tangential axes of the side, and its outward normal as the last one; see
     * axes_of_side(). */
    side
  };

  /**
   * The conditions on one outer side of one body, component by component.
   * Values are muParser expressions in x, y (z) and t, multiplied by a smooth
   * ramp: half a cosine from 0 at t = 0 to 1 at t = ramp_length.
   */
  template <int dim>
  struct BoundaryCondition
  {
    /** Name of the body. */
    std::string body;

    /** Name of the side. */
    std::string side_name = "left";

    /** Boundary indicator of the side; that of a brick is
     * 2 * axis + (0: lower, 1: upper). */
    unsigned int side = 0;

    BoundaryAxes axes = BoundaryAxes::space;

    /** Components of displacements: those of space, or one, out of the plane;
     * only so many of the following count. */
    unsigned int n_components = dim;

    std::array<BoundaryType, dim> type;
    std::array<std::string, dim>  expression;

    /** Length of the ramp in s; zero: none. */
    double ramp_length = 1.;

    BoundaryCondition();

    /** The name of a component in entries: x, or normal; z out of the plane. */
    std::string
    component_name(const unsigned int component) const;

    /** True if a component has a velocity or a traction that depends on time
     * other than by the ramp. */
    bool
    varies_in_time(const unsigned int component) const;

    /** Declare the entries in the current subsection of @p prm: of components
     * along the axes that the condition has now. */
    void
    add_parameters(ParameterHandler &prm);
  };

  /**
   * The smooth ramp, (1 - cos(pi t / length)) / 2 for 0 < t < length.
   */
  double
  smooth_ramp(const double time, const double length);
} // namespace StickSlip

#endif
