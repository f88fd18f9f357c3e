// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_nodal_normals_h
#define stickslip_mesh_nodal_normals_h

#include <stickslip/mesh/fault_surface.h>

namespace StickSlip
{
  /**
   * Unit vectors out of the body at all nodes of a surface, in the order of the
   * surface; a single one if the surface is plane.
   *
   * A linear function is fitted by least squares to the normals at the centres
   * of the faces around a node and evaluated at the node; around a node at the
   * edge of the surface, to those of the faces next to these as well. Among
   * triangles, whose normals are less accurate, a paraboloid is fitted to the
   * nodes of the same faces in its place. In two
   * dimensions this is the tangent t ~ e_1 L_2/L_1 + e_2 L_1/L_2 of the
   * parabola through three nodes, with the edges e_i of lengths L_i; it is
   * exact on circles. On smooth surfaces the error is of second order in the
   * size of the faces.
   */
  template <int dim>
  std::vector<Tensor<1, dim>>
  nodal_normals(const FaultSurface<dim> &surface);
} // namespace StickSlip

#endif
