// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/scene/scene_parameters.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  Tensor<1, dim>
  SceneParameters<dim>::gravity_vector() const
  {
    const double   angle = dip * numbers::PI / 180.;
    Tensor<1, dim> result;
    result[0]       = gravity * std::sin(angle);
    result[dim - 1] = -gravity * std::cos(angle);
    return result;
  }



  template <int dim>
  std::array<std::vector<BodySide>, 2>
  SceneParameters<dim>::below_and_above(const unsigned int fault) const
  {
    std::array<std::vector<BodySide>, 2> sides = topology.faults()[fault].sides;
    const auto                           base  = [&](const auto &side) {
      return bodies[side.front().body].geometry.base;
    };
    if (base(sides[1]) < base(sides[0]))
      std::swap(sides[0], sides[1]);
    return sides;
  }



  template <int dim>
  unsigned int
  SceneParameters<dim>::nearest_body(const std::vector<BodySide> &side,
                                     const Point<dim>            &point) const
  {
    const auto distance = [&](const BodySide &part) {
      return bodies[part.body].geometry.within_sides(point).distance(point);
    };
    return std::min_element(side.begin(),
                            side.end(),
                            [&](const BodySide &a, const BodySide &b) {
                              return distance(a) < distance(b);
                            })
      ->body;
  }



  template struct SceneParameters<2>;
  template struct SceneParameters<3>;
} // namespace StickSlip
