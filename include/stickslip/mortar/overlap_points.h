// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_overlap_points_h
#define stickslip_mortar_overlap_points_h

#include <stickslip/mortar/face_overlap.h>

#include <functional>

namespace StickSlip
{
  /**
   * A quadrature point of the overlap of the two sides of a fault.
   */
  template <int dim>
  struct OverlapPoint
  {
    using Values = std::array<double, FaceShape<dim>::max_vertices>;

    /** Positions in the surfaces' arrays of faces. */
    unsigned int slave_face, master_face;

    /** The plane of the slave face, and both faces in it. */
    const FacePlane<dim> &plane;
    const FaceShape<dim> &slave_shape, &master_shape;

    /** The point in that plane on each of the faces, which are a period apart
     * where the sides have slid past an end. */
    Point<dim - 1> on_slave, on_master;

    /** Shape functions of the vertices there. */
    Values slave_phi, master_phi;

    /** Weight times the measure of the integration cell, m^(dim-1). */
    double JxW;

    /** By how much the slave face is above the master face along its outward
     * normal, m; zero between plane sides. */
    double gap;
  };

  /**
   * Call @p visit at each quadrature point of the overlap, slave face after
   * slave face. Products of two shape functions are integrated exactly on
   * parallelograms. For surfaces and positions, and what is thrown, see
   * compute_face_overlap().
   */
  template <int dim>
  void
  for_each_overlap_point(
    const FaultSurface<dim>                              &slave,
    const std::vector<Point<dim>>                        &slave_positions,
    const FaultSurface<dim>                              &master,
    const std::vector<Point<dim>>                        &master_positions,
    const std::function<void(const OverlapPoint<dim> &)> &visit);
} // namespace StickSlip

#endif
