// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/face_plane.h>

#include <cmath>

namespace StickSlip
{
  namespace
  {
    /** The vector or its negative: the one whose largest component is positive.
     */
    template <int dim>
    Tensor<1, dim>
    pointing_forwards(const Tensor<1, dim> &vector)
    {
      unsigned int largest = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (std::abs(vector[d]) > std::abs(vector[largest]))
          largest = d;
      return vector[largest] < 0. ? -vector : vector;
    }



    std::array<Tensor<1, 2>, 1>
    axes_normal_to(const Tensor<1, 2> &n)
    {
      return {{pointing_forwards(Tensor<1, 2>({n[1], -n[0]}))}};
    }



    std::array<Tensor<1, 3>, 2>
    axes_normal_to(const Tensor<1, 3> &n)
    {
      // The first axis is that of space which is nearest to the plane.
      unsigned int least = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(n[d]) < std::abs(n[least]))
          least = d;
      Tensor<1, 3> first = -n[least] * n;
      first[least] += 1.;
      first /= first.norm();
      return {{first, pointing_forwards(cross_product_3d(n, first))}};
    }
  } // namespace



  template <int dim>
  FacePlane<dim>::FacePlane(const Tensor<1, dim> &normal)
    : n(normal)
    , axes(axes_normal_to(normal))
  {}



  template <int dim>
  Point<dim - 1>
  FacePlane<dim>::coordinates(const Point<dim> &point) const
  {
    return Point<dim - 1>(components(point));
  }



  template <int dim>
  Tensor<1, dim - 1>
  FacePlane<dim>::components(const Tensor<1, dim> &vector) const
  {
    Tensor<1, dim - 1> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      result[d] = axes[d] * vector;
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  FacePlane<dim>::in_space(const Tensor<1, dim - 1> &components) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      result += components[d] * axes[d];
    return result;
  }



  template class FacePlane<2>;
  template class FacePlane<3>;
} // namespace StickSlip
