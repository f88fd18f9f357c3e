// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_fault_surface_h
#define stickslip_mesh_fault_surface_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>
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
     * deal.II's order. In the last place of a triangle is
     * numbers::invalid_unsigned_int. */
    std::vector<std::array<unsigned int, n_vertices>> faces;

    /** Unit vector out of the bodies: the mean over the surface, if that is not
     * plane. */
    Tensor<1, dim> normal;

    /** Unit vectors out of the bodies, one for each face; empty where the
     * surface is plane. */
    std::vector<Tensor<1, dim>> face_normals;

    /** Length after which the surface repeats along each horizontal axis, m;
     * zero: it ends there. */
    Tensor<1, dim - 1> period;

    /** Number of periods between each vertex of a face and its node. Empty if
     * the surface ends along all axes. */
    std::vector<std::array<std::array<int, dim - 1>, n_vertices>> wraps;

    /** Number of vertices of a face: 2 in two dimensions, 3 or 4 in three. */
    unsigned int
    n_vertices_of(const unsigned int face) const
    {
      return faces[face][n_vertices - 1] == numbers::invalid_unsigned_int ?
               n_vertices - 1 :
               n_vertices;
    }

    /** Positions of the vertices of a face, m, when the nodes are at
     * @p positions; the last one of a triangle means nothing. */
    std::array<Point<dim>, n_vertices>
    face_vertices(const std::vector<Point<dim>> &positions,
                  const unsigned int             face) const;

    /** Return whether all faces lie in one plane. */
    bool
    is_plane() const
    {
      return face_normals.empty();
    }

    /** The unit vector out of the body at a face. */
    const Tensor<1, dim> &
    normal_of(const unsigned int face) const
    {
      return is_plane() ? normal : face_normals[face];
    }

    /** Set the normals from those of the faces, each as long as the face is
     * large, m^(dim-1). Faces are in one plane if their unit normals agree to
     * 1e-10 and their nodes are at most 1e-8 of a face off it. */
    void
    set_normals(const std::vector<Tensor<1, dim>> &face_areas);

    /** Extent of a face in the reference configuration, m: its diagonal in
     * three dimensions. */
    double
    face_size(const unsigned int face) const;
  };
} // namespace StickSlip

#endif
