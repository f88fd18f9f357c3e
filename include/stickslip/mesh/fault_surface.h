// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_fault_surface_h
#define stickslip_mesh_fault_surface_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The trace of one body's mesh on a fault: the boundary faces there and the
   * nodes they join.
   */
  template <int dim>
  struct FaultSurface
  {
    /** Scalar degrees of freedom of the body's DoFHandler, in the order of
     * their positions (x first, then y). */
    std::vector<types::global_dof_index> dofs;

    /** Reference positions of these, m. */
    std::vector<Point<dim>> points;

    /** For each face, the positions in the two arrays above of its vertices in
     * deal.II's order. */
    std::vector<std::array<unsigned int, GeometryInfo<dim>::vertices_per_face>>
      faces;
  };
} // namespace StickSlip

#endif
