// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_fault_axes_h
#define stickslip_mortar_fault_axes_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The axes of a fault: the normal from its first side to the second one, and
   * the tangential axes along which slip and tangential tractions have their
   * components. They are the same at all nodes of a level fault, whose
   * tangential axes are the axes of space but the last.
   *
   * Vectors of the jump basis have the tangential components of a slave node
   * first and the normal one last.
   */
  template <int dim>
  class FaultAxes
  {
  public:
    /** Normal component of a slave node in vectors of the jump basis. */
    static constexpr unsigned int normal_component = dim - 1;

    FaultAxes() = default;

    /** Axes of a level fault from its unit @p normal. */
    explicit FaultAxes(const Tensor<1, dim> &normal)
      : n(normal)
    {}

    const Tensor<1, dim> &
    normal() const
    {
      return n;
    }

    /** The components of a vector along the tangential axes. */
    Tensor<1, dim - 1>
    tangential_part(const Tensor<1, dim> &vector) const
    {
      Tensor<1, dim - 1> part;
      for (unsigned int d = 0; d < dim - 1; ++d)
        part[d] = vector[d];
      return part;
    }

    /** The coordinates along the tangential axes of a point's projection onto
     * the plane of the fault, m. */
    Point<dim - 1>
    in_plane(const Point<dim> &point) const
    {
      return Point<dim - 1>(tangential_part(point));
    }

  private:
    Tensor<1, dim> n;
  };
} // namespace StickSlip

#endif
