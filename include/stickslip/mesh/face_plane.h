// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_face_plane_h
#define stickslip_mesh_face_plane_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Orthogonal coordinates in the planes normal to one direction: the plane of
   * a face, onto which the faces opposite to it are projected. The axes only
   * serve to integrate; where the plane is level they are those of space but
   * the last one, to the last bit, on both sides of a fault.
   */
  template <int dim>
  class FacePlane
  {
  public:
    /** The planes with this unit @p normal. */
    explicit FacePlane(const Tensor<1, dim> &normal);

    const Tensor<1, dim> &
    normal() const
    {
      return n;
    }

    /** The coordinates of the projection of a point, m. */
    Point<dim - 1>
    coordinates(const Point<dim> &point) const;

    /** The components of a vector along the plane. */
    Tensor<1, dim - 1>
    components(const Tensor<1, dim> &vector) const;

    /** The vector in space with these components. */
    Tensor<1, dim>
    in_space(const Tensor<1, dim - 1> &components) const;

  private:
    Tensor<1, dim>                      n;
    std::array<Tensor<1, dim>, dim - 1> axes;
  };
} // namespace StickSlip

#endif
