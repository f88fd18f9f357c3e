// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/smooth_shape.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/scene/fault_geometry.h>

namespace StickSlip
{
  namespace
  {
    const std::string level = "level", as_in_mesh = "mesh", smooth = "smooth";



    /** One coordinate as a function of the others. */
    template <int dim>
    std::function<double(const Point<dim> &)>
    coordinate(const SpatialField &field,
               const std::string  &section,
               const std::string  &entry,
               const unsigned int  axis)
    {
      if (field.depends_on(axis))
        throw InputError("'" + section + "/" + entry + "' = '" + field.text() +
                         "': must not depend on " + "xyz"[axis] +
                         ", since it is " + "xyz"[axis] + " of the fault.");
      return field.function<dim>(section);
    }
  } // namespace



  FaultGeometry::FaultGeometry()
  {
    elevation.set(level);
    shape.set(as_in_mesh);
  }



  bool
  FaultGeometry::is_level() const
  {
    return elevation.text() == level;
  }



  void
  FaultGeometry::add_parameters(ParameterHandler &prm)
  {
    add_field(
      prm,
      "Elevation",
      elevation,
      NumberRange().in("m"),
      "Elevation of the fault in a stack of built-in bodies, in m: an "
      "expression in x (and y in three dimensions) or a table; or the "
      "word level: as the thicknesses of the bodies say. Nodes of the "
      "fault are there on all levels of refinement; those of the bodies "
      "follow in proportion between their lower and upper sides.");
    add_field(
      prm,
      "Shape",
      shape,
      NumberRange().in("m"),
      "Where refinement puts new nodes of a fault of mesh files or blocks: "
      "mesh, straight between the nodes of the coarse mesh; smooth, on a curve "
      "of continuous curvature through them, in three dimensions a smooth "
      "surface (bends of more than 50 degrees stay corners or edges); or on a "
      "given curve or surface, as an "
      "expression or a table of one coordinate as a "
      "function of the others, in m (recommended where it is known).");
    add_choice<std::string>(
      prm,
      "Shape axis",
      shape_axis,
      {{"last", "last"}, {"x", "x"}, {"y", "y"}, {"z", "z"}},
      "The coordinate that an expression or a table in 'Shape' gives: the last "
      "one (last), which is the elevation, or for steep faults x, or y. The "
      "fault should be less than 45 degrees steep over the others.");
  }



  template <int dim>
  std::function<double(const Point<dim> &)>
  FaultGeometry::elevation_function() const
  {
    return coordinate<dim>(elevation, section, "Elevation", dim - 1);
  }



  template <int dim>
  std::shared_ptr<const FaultShape<dim>>
  FaultGeometry::make_shape(const std::vector<BodyCells<dim>> &bodies,
                            const Fault                       &fault) const
  {
    if (shape.text() == as_in_mesh)
      return nullptr;
    if (shape.text() == smooth)
      return smooth_shape<dim>(bodies, fault);
    const unsigned int axis =
      shape_axis == "last" ? dim - 1 : shape_axis[0] - 'x';
    if (axis >= dim)
      throw InputError("'" + section +
                       "/Shape axis' = 'z': there are only x and y in two "
                       "dimensions.");
    return std::make_shared<const GraphShape<dim>>(
      axis, coordinate<dim>(shape, section, "Shape", axis));
  }



#define STICKSLIP_INSTANTIATE(dim)                                           \
  template std::function<double(const Point<dim> &)>                         \
  FaultGeometry::elevation_function<dim>() const;                            \
  template std::shared_ptr<const FaultShape<dim>> FaultGeometry::make_shape( \
    const std::vector<BodyCells<dim>> &, const Fault &) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
