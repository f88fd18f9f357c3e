// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_fault_geometry_h
#define stickslip_scene_fault_geometry_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/geometry/fault_shape.h>
#include <stickslip/parameters/spatial_field.h>

#include <functional>
#include <memory>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The place of a fault as the scene says it, beside mesh files or thicknesses
   * of bodies.
   */
  struct FaultGeometry
  {
    /** The subsection of the entries, for messages. */
    std::string section;

    /** In a stack of built-in bodies the elevation of the fault, m, or the word
     * 'level'. */
    SpatialField elevation;

    /** In mesh files the words 'mesh' or 'smooth', or a coordinate of the fault
     * as a function of the others, m. */
    SpatialField shape;

    /** The coordinate that the shape gives; none: the last one. */
    std::string shape_axis = "last";

    FaultGeometry();

    bool
    is_level() const;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);

    /** The elevation as a function of the horizontal coordinates. Throws
     * InputError if it depends on the vertical one, and as
     * SpatialField::function(). */
    template <int dim>
    std::function<double(const Point<dim> &)>
    elevation_function() const;

    /** The shape of a fault of these bodies; null: as in the mesh. Throws
     * InputError as elevation_function() or smooth_shape(). */
    template <int dim>
    std::shared_ptr<const FaultShape<dim>>
    make_shape(const std::vector<BodyCells<dim>> &bodies,
               const Fault                       &fault) const;
  };
} // namespace StickSlip

#endif
