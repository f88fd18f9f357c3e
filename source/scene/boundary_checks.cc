// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/mechanics/node_constraint.h>
#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/scene/boundary_checks.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>
#include <regex>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    void
    check_expression(const std::string             &path,
                     const std::string             &expression,
                     const NumberRange             &range,
                     const std::vector<Point<dim>> &points,
                     const std::vector<double>     &times)
    {
      try
        {
          const Expression<dim> parsed(expression, true);
          const std::string     mistake =
            range.mistaken_unit_in_expression(expression);
          if (!mistake.empty())
            throw InputError(mistake);
          for (const Point<dim> &point : points)
            for (const double time : times)
              parsed.finite_value(point, time);
        }
      catch (const InputError &error)
        {
          throw InputError(naming(path, expression) +
                           ": cannot be used: " + error.what() + ".");
        }
    }



    /** Check that the condition on a side is a motion of all of a rigid body.
     */
    template <int dim>
    void
    check_rigid_motion(const SceneParameters<dim>   &scene,
                       const BoundaryCondition<dim> &condition)
    {
      const std::string path = "Boundary conditions/" + condition.body + " " +
                               condition.side_name + "/";
      for (const BoundaryCondition<dim> &other : scene.boundary_conditions)
        if (other.body == condition.body && other.side != condition.side)
          throw InputError("'Boundary conditions/Sides': lists two sides of "
                           "the rigid body '" +
                           condition.body +
                           "'; one is enough, all of it moves with it.");
      for (unsigned int c = 0; c < scene.n_components(); ++c)
        {
          const std::string axis = condition.component_name(c);
          if (condition.type[c] == BoundaryType::traction)
            throw InputError(naming(path + axis + " condition", "traction") +
                             ": must be fixed, velocity or free on a rigid "
                             "body, which does not move where it is free.");
          static const std::regex a_coordinate("\\b[xyz]\\b");
          if (condition.type[c] == BoundaryType::velocity &&
              std::regex_search(condition.expression[c], a_coordinate))
            throw InputError(
              naming(path + axis + " value", condition.expression[c]) +
              ": must not depend on the position, since the body "
              "is rigid.");
        }
    }
  } // namespace



  template <int dim>
  void
  check_boundary_conditions(const SceneParameters<dim> &scene)
  {
    // A stack stands on its lowest body.
    const BodyParameters<dim> &lowest =
      *std::min_element(scene.bodies.begin(),
                        scene.bodies.end(),
                        [](const auto &a, const auto &b) {
                          return a.geometry.base < b.geometry.base;
                        });
    NodeConstraint<dim> held;
    for (const BodyParameters<dim> &body : scene.bodies)
      for (unsigned int c = 0; c < dim; ++c)
        if (body.geometry.rigid &&
            (scene.mesh != nullptr || body.name == lowest.name))
          held.add(Point<dim>::unit_vector(c));
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      for (const BodyParameters<dim> &body : scene.bodies)
        if (body.name == condition.body && body.geometry.rigid)
          check_rigid_motion(scene, condition);
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      {
        const std::string path = "Boundary conditions/" + condition.body + " " +
                                 condition.side_name + "/";
        const unsigned int normal_axis = condition.side / 2;
        if (normal_axis + 1 < dim && scene.periodic[normal_axis])
          throw InputError("'Boundary conditions/Sides': '" + condition.body +
                           " " + condition.side_name +
                           "' is no outer side, since '" +
                           periodic_entry(normal_axis) +
                           "' = 'true' joins it to the opposite one.");
        const std::vector<Tensor<2, dim>> directions =
          side_directions(scene, condition);
        for (unsigned int component = 0; component < scene.n_components();
             ++component)
          {
            const std::string  axis       = condition.component_name(component);
            const std::string &expression = condition.expression[component];
            const BoundaryType type       = condition.type[component];

            if ((scene.mesh != nullptr || condition.body == lowest.name) &&
                (type == BoundaryType::fixed || type == BoundaryType::velocity))
              for (const Tensor<2, dim> &axes : directions)
                {
                  Tensor<1, dim> direction;
                  for (unsigned int d = 0; d < dim; ++d)
                    direction[d] = axes[d][component];
                  held.add(direction);
                }

            const NumberRange range =
              NumberRange().in(type == BoundaryType::traction ? "Pa" : "m/s");
            const std::string mistake = range.mistaken_unit(expression);
            if (!mistake.empty())
              throw InputError(naming(path + axis + " value", expression) +
                               ": " + mistake + ".");
            if (type == BoundaryType::velocity ||
                type == BoundaryType::traction)
              check_expression(path + axis + " value",
                               expression,
                               range,
                               side_points(scene, condition),
                               {0.,
                                0.5 * scene.time.end_time,
                                scene.time.end_time});
            else if (expression != "0")
              throw InputError(
                naming(path + axis + " value", expression) +
                ": has no effect, since '" + axis + " condition' = '" +
                (type == BoundaryType::free ? "free" : "fixed") +
                "'; values are allowed with velocity and traction.");
          }
      }

    for (unsigned int component = 0; component < scene.n_components();
         ++component)
      if (NodeConstraint<dim>(held).add(Point<dim>::unit_vector(component)))
        throw InputError(
          "'Boundary conditions/Sides': no side of " +
          (scene.mesh != nullptr ? "any body" :
                                   "the lowest body '" + lowest.name + "'") +
          " has '" + scene.axis_name(component) +
          " condition' = 'fixed' or 'velocity', so the bodies could float "
          "away along " +
          scene.axis_name(component) + "; at least one must.");
  }



  template decltype(check_boundary_conditions<2>) check_boundary_conditions<2>;
  template decltype(check_boundary_conditions<3>) check_boundary_conditions<3>;
} // namespace StickSlip
