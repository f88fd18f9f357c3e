// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/mechanics/side_axes.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  bool
  is_plane(const FaultSurface<dim> &side)
  {
    return std::all_of(
      side.points.begin(), side.points.end(), [&](const Point<dim> &point) {
        const Tensor<1, dim> offset = point - side.points.front();
        return std::abs(offset * side.normal) <= 1e-8 * offset.norm();
      });
  }



  template <int dim>
  Tensor<2, dim>
  axes_of_side(const Tensor<1, dim> &normal)
  {
    std::array<Tensor<1, dim>, dim> axes;
    axes[dim - 1] = normal;
    if constexpr (dim == 2)
      {
        axes[0][0] = normal[1];
        axes[0][1] = -normal[0];
      }
    else
      {
        const double       cosine    = std::cos(15. * numbers::PI / 180.);
        const unsigned int reference = (std::abs(normal[0]) > cosine ? 1 : 0);
        axes[0][reference]           = 1.;
        axes[0] -= normal[reference] * normal;
        axes[0] /= axes[0].norm();
        axes[1] = cross_product_3d(normal, axes[0]);
      }
    Tensor<2, dim> columns;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        columns[d][c] = axes[c][d];
    return columns;
  }



  template bool
  is_plane(const FaultSurface<2> &);
  template bool
  is_plane(const FaultSurface<3> &);
  template Tensor<2, 2>
  axes_of_side(const Tensor<1, 2> &);
  template Tensor<2, 3>
  axes_of_side(const Tensor<1, 3> &);
} // namespace StickSlip
