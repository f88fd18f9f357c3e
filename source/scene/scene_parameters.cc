// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/scene/scene_parameters.h>

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



  template struct SceneParameters<2>;
  template struct SceneParameters<3>;
} // namespace StickSlip
