// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/thickness_checks.h>

#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The lateral extent of a body in equal steps, both ends included. */
    template <int dim>
    std::vector<Point<dim>>
    lateral_grid(const BodyGeometry<dim> &geometry)
    {
      constexpr unsigned int  n = dim == 2 ? 200 : 50;
      std::vector<Point<dim>> points;
      for (unsigned int i = 0; i < Utilities::pow(n + 1, dim - 1); ++i)
        {
          Point<dim> point = geometry.lower_corner();
          for (unsigned int axis = 0, place = i; axis + 1 < dim; ++axis)
            {
              point[axis] +=
                (geometry.lateral_upper[axis] - geometry.lateral_lower[axis]) *
                (place % (n + 1)) / n;
              place /= n + 1;
            }
          points.push_back(point);
        }
      return points;
    }



    template <int dim>
    void
    check_slope(const BodyParameters<dim> &body, const bool has_fault_above)
    {
      const BodyGeometry<dim> &geometry = body.geometry;
      const std::string        path = "Bodies/" + body.name + "/Upper slope";
      if (has_fault_above)
        throw InputError("'" + path +
                         "': must be 0, since there is a fault above, which "
                         "has an 'Elevation'; only the highest body may have "
                         "a slope.");
      if (geometry.rigid)
        throw InputError("'" + path +
                         "': must be 0 for a body with 'Rigid' = 'true'.");
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        if (geometry.periodic[axis] && geometry.upper_slope[axis] != 0)
          throw InputError(naming(path, geometry.upper_slope[axis]) +
                           " along " + "xy"[axis] + ": must be 0, since '" +
                           periodic_entry(axis) + "' = 'true'.");
    }



    template <int dim>
    void
    check_positive(const BodyParameters<dim> &body)
    {
      const BodyGeometry<dim> &geometry = body.geometry;
      double                   least    = std::numeric_limits<double>::max();
      Point<dim>               place;
      for (const Point<dim> &point : lateral_grid(geometry))
        if (geometry.thickness_at(point) < least)
          {
            least = geometry.thickness_at(point);
            place = point;
          }
      if (least > 0)
        return;
      const std::string body_path = "Bodies/" + body.name;
      if (!geometry.has_elevation())
        throw InputError("'" + body_path +
                         "/Upper slope': leaves a thickness of " +
                         shortest_form(least) +
                         " m at the thin end; it must be greater than 0.");
      std::string position = "x = " + shortest_form(place[0]);
      if (dim == 3)
        position += ", y = " + shortest_form(place[1]);
      throw InputError("'" + body_path + "': the 'Elevation' of the faults " +
                       "below and above leaves it a thickness of " +
                       shortest_form(least) + " m at " + position +
                       " m; it must be greater than 0.");
    }



    /** Extents of a body that are so different that matrices are singular to
     * rounding. */
    template <int dim>
    void
    check_proportions(const BodyParameters<dim> &body)
    {
      constexpr double         largest_ratio = 1e6;
      const BodyGeometry<dim> &geometry      = body.geometry;
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        {
          const double width =
            geometry.lateral_upper[axis] - geometry.lateral_lower[axis];
          if (!(geometry.thickness * largest_ratio >= width &&
                width * largest_ratio >= geometry.thickness))
            {
              const std::string path  = "Bodies/" + body.name + "/";
              const std::string which = std::string("width along ") +
                                        "xy"[axis] + ", " +
                                        shortest_form(width) + " m";
              if (width < geometry.thickness)
                throw InputError(
                  naming(path + "Upper lateral corner",
                         geometry.lateral_upper[axis]) +
                  ": is so near to 'Lower lateral corner' that the " + which +
                  ", is out of all proportion to " +
                  naming("Thickness", geometry.thickness) + ".");
              throw InputError(naming(path + "Thickness", geometry.thickness) +
                               ": is out of all proportion to the " + which +
                               ".");
            }
        }
    }



    /** Elevations of the fault on top of a body, and of its two ends. */
    template <int dim>
    void
    check_fault(const std::string         &entry,
                const BodyParameters<dim> &below,
                const BodyParameters<dim> &above)
    {
      for (const BodyParameters<dim> *body : {&below, &above})
        if (body->geometry.rigid)
          throw InputError(entry + ": must be level, since the body '" +
                           body->name + "' is rigid.");
      const BodyGeometry<dim> &geometry = below.geometry;
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        {
          const double period = geometry.period()[axis];
          if (period == 0.)
            continue;
          // At the upper end itself the function is that of the lower one.
          for (Point<dim> point : lateral_grid(geometry))
            {
              point[axis]        = geometry.lateral_lower[axis];
              const double lower = geometry.upper_elevation(point);
              point[axis]        = geometry.lateral_upper[axis] - 1e-6 * period;
              const double upper = geometry.upper_elevation(point);
              if (std::abs(upper - lower) > 1e-3 * period)
                throw InputError(entry + ": is " + shortest_form(lower) +
                                 " m at one end along " + "xy"[axis] + " and " +
                                 shortest_form(upper) +
                                 " m at the other; both must agree, since '" +
                                 periodic_entry(axis) + "' = 'true'.");
            }
        }
    }
  } // namespace



  template <int dim>
  void
  check_thicknesses(const SceneParameters<dim> &scene)
  {
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      if (!scene.fault_geometries[f].is_level())
        {
          const auto [below, above] = scene.below_and_above(f);
          check_fault("'" + scene.faults[f].section() + "/Elevation' = '" +
                        scene.fault_geometries[f].elevation.text() + "'",
                      scene.bodies[below[0].body],
                      scene.bodies[above[0].body]);
        }
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        check_proportions(scene.bodies[b]);
        if (scene.bodies[b].geometry.is_sloped())
          check_slope(scene.bodies[b],
                      scene.topology.is_at_fault(b, BodyMesh<dim>::upper_side));
        if (scene.bodies[b].geometry.is_sloped() ||
            scene.bodies[b].geometry.has_elevation())
          check_positive(scene.bodies[b]);
      }
  }



  template decltype(check_thicknesses<2>) check_thicknesses<2>;
  template decltype(check_thicknesses<3>) check_thicknesses<3>;
} // namespace StickSlip
