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
   * Some boundary faces of meshes, such as one side of a fault, and the nodes
   * they join. On a periodic body, faces at its end join nodes of both ends.
   */
  template <int dim>
  struct FaultSurface
  {
    static constexpr unsigned int n_vertices =
      GeometryInfo<dim>::vertices_per_face;

    /** Numbers of the nodes, as BodyMesh or MeshLevel count them. Nodes of
     * one part of a boundary are in the order of their positions (x first, then
     * y). */
    std::vector<types::global_dof_index> nodes;

    /** Reference positions of the nodes, m. */
    std::vector<Point<dim>> points;

    /** For each face, the places in the two arrays above of its vertices in
     * deal.II's order. */
    std::vector<std::array<unsigned int, n_vertices>> faces;

    /** Unit vector out of the bodies: the mean over the surface, if that is not
     * plane. */
    Tensor<1, dim> normal;

    /** Length after which the surface repeats along each horizontal axis, m;
     * zero: it ends there. */
    Tensor<1, dim - 1> period;

    /** Number of periods between each vertex of a face and its node. Empty if
     * the surface ends along all axes. */
    std::vector<std::array<std::array<int, dim - 1>, n_vertices>> wraps;

    /** Positions of the vertices of a face in the fault plane, m, when the
     * nodes are at @p positions. */
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
