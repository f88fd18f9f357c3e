// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_face_overlap_h
#define stickslip_mortar_face_overlap_h

#include <deal.II/base/point.h>

#include <stickslip/mesh/fault_surface.h>

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

    /** Corners in the fault plane, m, on the slave face. */
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
   * The positions are the current ones of the nodes in the (flat) fault plane,
   * in m and in the order of the nodes of the surfaces; nodes and faces
   * may be numbered in any order. The faces of one side must not overlap each
   * other. Periodic surfaces have the same period, and the images of the master
   * faces count too.
   *
   * Two dimensions: the two sets of breakpoints are merged on the line. Three
   * dimensions: pairs of faces whose bounding boxes meet are clipped against
   * each other and cut into triangles; the error is a few units of rounding.
   *
   * Throws ExcMessage if a face has no area, is not convex, or overlaps its
   * neighbour (2d only).
   */
  template <int dim>
  std::vector<OverlapCell<dim>>
  compute_face_overlap(const FaultSurface<dim>           &slave,
                       const std::vector<Point<dim - 1>> &slave_positions,
                       const FaultSurface<dim>           &master,
                       const std::vector<Point<dim - 1>> &master_positions);
} // namespace StickSlip

#endif
