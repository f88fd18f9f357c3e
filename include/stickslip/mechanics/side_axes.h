// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_side_axes_h
#define stickslip_mechanics_side_axes_h

#include <stickslip/mesh/fault_surface.h>

namespace StickSlip
{
  using namespace dealii;

  /** Return whether all nodes of a side lie in one plane, to 1e-8 of their
   * distances. */
  template <int dim>
  bool
  is_plane(const FaultSurface<dim> &side);

  /** The axes of a plane side with this outward unit normal, as columns:
   * tangential ones, the normal last. In two dimensions the tangential one is
   * (n_y, -n_x), in three the first one is nearest to the x axis, or to the y
   * axis where x lies within 15 degrees of the normal. */
  template <int dim>
  Tensor<2, dim>
  axes_of_side(const Tensor<1, dim> &normal);
} // namespace StickSlip

#endif
