// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/mechanics/boundary_condition.h>
#include <stickslip/parameters/entries.h>

#include <cmath>
#include <regex>

namespace StickSlip
{
  template <int dim>
  BoundaryCondition<dim>::BoundaryCondition()
  {
    type.fill(BoundaryType::free);
    expression.fill("0");
  }



  template <int dim>
  std::string
  BoundaryCondition<dim>::component_name(const unsigned int component) const
  {
    if (n_components < dim)
      return "z";
    if (axes == BoundaryAxes::space)
      return std::string(1, "xyz"[component]);
    return component == dim - 1 ? "normal" :
           dim == 2             ? "tangential" :
           component == 0       ? "first tangential" :
                                  "second tangential";
  }



  template <int dim>
  bool
  BoundaryCondition<dim>::varies_in_time(const unsigned int component) const
  {
    static const std::regex the_time("\\bt\\b");
    return (type[component] == BoundaryType::velocity ||
            type[component] == BoundaryType::traction) &&
           std::regex_search(expression[component], the_time);
  }



  template <int dim>
  void
  BoundaryCondition<dim>::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Axes",
               axes,
               {{BoundaryAxes::space, "space"}, {BoundaryAxes::side, "side"}},
               "The directions of conditions and values: x, y (z) (space), or "
               "those of the side (side), which may be curved but have no "
               "corners: its outward "
               "normal n ('normal condition', 'normal value'), and in two "
               "dimensions the tangent (n_y, -n_x) ('tangential condition'); "
               "in three the first tangent is the direction in the side next "
               "to x (to y where n is anywhere within 15 degrees of x, then to "
               "z), the second one n times the first.");
    for (unsigned int component = 0; component < n_components; ++component)
      {
        const std::string axis = component_name(component);
        const std::string direction =
          axes == BoundaryAxes::space ?
            "direction " + axis :
            axis +
              (component + 1 < dim ? " direction" : " direction outwards") +
              ", with 'Axes = side'";
        add_choice(prm,
                   axis + " condition",
                   type[component],
                   {{BoundaryType::free, "free"},
                    {BoundaryType::fixed, "fixed"},
                    {BoundaryType::velocity, "velocity"},
                    {BoundaryType::traction, "traction"}},
                   "What holds on the side in " + direction +
                     ": no traction (free), no displacement (fixed), a given "
                     "velocity, or a given traction.");
        add_text(prm,
                 axis + " value",
                 expression[component],
                 "The given velocity, in m/s, or traction, in Pa, in " +
                   direction + ": an expression in x, y" +
                   (dim == 3 ? ", z" : "") + " (in m) and t (in s).");
      }
    add_number(prm,
               "Ramp length",
               ramp_length,
               NumberRange().at_least(0).in("s"),
               "Time in which the given values grow smoothly from zero, by "
               "half a cosine, in s; 0: they act in full from the start.");
  }



  double
  smooth_ramp(const double time, const double length)
  {
    if (time >= length)
      return 1.;
    if (time <= 0.)
      return 0.;
    return 0.5 * (1. - std::cos(numbers::PI * time / length));
  }



  template struct BoundaryCondition<2>;
  template struct BoundaryCondition<3>;
} // namespace StickSlip
