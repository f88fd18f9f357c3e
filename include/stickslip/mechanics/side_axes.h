// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_side_axes_h
#define stickslip_mechanics_side_axes_h

#include <stickslip/mesh/fault_surface.h>

#include <array>
#include <map>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** Return whether all nodes of a side lie in one plane, to 1e-8 of their
   * distances. */
  template <int dim>
  bool
  is_plane(const FaultSurface<dim> &side);

  /** The axis of space next to which the first tangential axis of a side is in
   * three dimensions: x, or else y, or z, the first that is farther than 15
   * degrees from all @p normals; numbers::invalid_unsigned_int if none is. */
  template <int dim>
  unsigned int
  reference_of_side(const std::vector<Tensor<1, dim>> &normals);

  /** The axes of a side where it has this outward unit normal, as columns:
   * tangential ones, the normal last. In two dimensions the tangential one is
   * (n_y, -n_x), in three the first one is nearest to the axis of space
   * @p reference; none: reference_of_side() of this normal. */
  template <int dim>
  Tensor<2, dim>
  axes_of_side(const Tensor<1, dim> &normal,
               const unsigned int    reference = numbers::invalid_unsigned_int);

  /**
   * The outward normals at the nodes of a curved side, by position. Throws
   * InputError with the place if the side has a corner there, that is if a face
   * turns by more than 25 degrees from the normal at its node.
   */
  template <int dim>
  class SideNormals
  {
  public:
    SideNormals() = default;

    explicit SideNormals(const FaultSurface<dim> &side);

    /** True for plane sides. */
    bool
    empty() const
    {
      return normals.empty();
    }

    std::vector<Tensor<1, dim>>
    all() const;

    /** The normal at a node of any mesh of the same side: that of the node at
     * the same place, or else of the nearest one. */
    const Tensor<1, dim> &
    at(const Point<dim> &point) const;

  private:
    std::map<std::array<double, dim>, Tensor<1, dim>> normals;
  };
} // namespace StickSlip

#endif
