// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_fault_surface_h
#define stickslip_mesh_fault_surface_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The trace of one body's mesh on a fault: the boundary faces there and the
   * nodes they join. On a periodic body, faces at its end join nodes of both
   * ends.
   */
  template <int dim>
  struct FaultSurface
  {
    static constexpr unsigned int n_vertices =
      GeometryInfo<dim>::vertices_per_face;

    /** Scalar degrees of freedom of the body's DoFHandler, in the order of
     * their positions (x first, then y). */
    std::vector<types::global_dof_index> dofs;

    /** Reference positions of these, m. */
    std::vector<Point<dim>> points;

    /** For each face, the positions in the two arrays above of its vertices in
     * deal.II's order. */
    std::vector<std::array<unsigned int, n_vertices>> faces;

    /** After how much the surface repeats along each horizontal axis, m; zero:
     * it ends there. */
    Tensor<1, dim - 1> period;

    /** How many periods from its node each vertex of a face lies. Empty if the
     * surface ends along all axes. */
    std::vector<std::array<std::array<int, dim - 1>, n_vertices>> wraps;

    /** Where the vertices of a face are in the fault plane, m, when the nodes
     * are at @p positions. */
    std::array<Point<dim - 1>, n_vertices>
    face_vertices(const std::vector<Point<dim - 1>> &positions,
                  const unsigned int                 face) const;

    /** Extent of a face in the reference configuration, m: its diagonal in
     * three dimensions. */
    double
    face_size(const unsigned int face) const;
  };
} // namespace StickSlip

#endif
