// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_face_overlap_h
#define stickslip_mortar_face_overlap_h

#include <deal.II/base/point.h>

#include <stickslip/mesh/face_plane.h>
#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mortar/face_shape.h>

#include <array>
#include <vector>

namespace StickSlip
{
  /**
   * An integration cell: part of what a slave and a master face have in
   * common. A segment in two dimensions, a triangle in three.
   */
  template <int dim>
  struct OverlapCell
  {
    /** Position in the slave surface's array of faces. */
    unsigned int slave_face;

    /** Position in the master surface's array of faces. */
    unsigned int master_face;

    /** The cell lies on the image of the master face that is moved by this many
     * periods. */
    std::array<int, dim - 1> master_wraps;

    /** Corners in the coordinates of the plane of the slave face, m. */
    std::array<Point<dim - 1>, dim> vertices;

    /** Length (m) or area (m^2). */
    double
    measure() const;
  };

  /**
   * Overlaps smaller than this fraction of the smaller one of the two faces
   * are rounding and left out.
   */
  constexpr double overlap_tolerance = 1e-14;

  /**
   * The overlap of the two sides of a fault, cut into integration cells. The
   * cells of one slave face follow each other.
   *
   * Master faces are projected onto the plane of a slave face along its normal.
   * In three dimensions the plane of a face is normal to its area vector, which
   * is the mean plane of a face that is warped.
   *
   * The positions are the current ones of the nodes, in m and in the order of
   * the nodes of the surfaces; the normals are those of the reference
   * configuration. Nodes and faces may be numbered in any order. Periodic
   * surfaces have the same period, and the images of the master faces count
   * too.
   *
   * Faces overlap only if they face each other and are near to each other
   * (face_search.h). On a fault that closes around a body, or that is folded,
   * this leaves out what lies on the far side of a body.
   *
   * Each slave face is cut against the master faces whose bounding boxes are
   * near to its own: in two dimensions segments on a line, in three polygons,
   * which are cut into triangles; the error is a few units of rounding.
   *
   * Throws ExcMessage if a face has no area, is not convex, or is turned inside
   * out.
   */
  template <int dim>
  std::vector<OverlapCell<dim>>
  compute_face_overlap(const FaultSurface<dim>       &slave,
                       const std::vector<Point<dim>> &slave_positions,
                       const FaultSurface<dim>       &master,
                       const std::vector<Point<dim>> &master_positions);

  /** The projection of a face onto a plane, its nodes at @p positions. */
  template <int dim>
  FaceShape<dim>
  project_face(const FacePlane<dim>          &plane,
               const FaultSurface<dim>       &surface,
               const std::vector<Point<dim>> &positions,
               const unsigned int             face);
} // namespace StickSlip

#endif
