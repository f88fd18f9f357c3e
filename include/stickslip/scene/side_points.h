// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_side_points_h
#define stickslip_scene_side_points_h

#include <stickslip/scene/scene_parameters.h>

#include <vector>

namespace StickSlip
{
  /**
   * The corners and the centre of the side a condition holds on, m; with mesh
   * files its vertices.
   */
  template <int dim>
  std::vector<Point<dim>>
  side_points(const SceneParameters<dim>   &scene,
              const BoundaryCondition<dim> &condition);

  /**
   * The directions of the components of a condition as columns, for a curved
   * side at each of its faces; the normal may have either sign.
   */
  template <int dim>
  std::vector<Tensor<2, dim>>
  side_directions(const SceneParameters<dim>   &scene,
                  const BoundaryCondition<dim> &condition);

  /**
   * The corners and the centre of a body, m; with mesh files its vertices.
   */
  template <int dim>
  std::vector<Point<dim>>
  body_points(const SceneParameters<dim> &scene, const unsigned int body);

  /**
   * The corners and the centre of a fault, as far as its two sides lie opposite
   * to each other, and a grid of so many intervals along each axis, m; of each
   * pair of bodies on the two sides. With mesh files, the vertices of its first
   * side.
   */
  template <int dim>
  std::vector<Point<dim>>
  fault_points(const SceneParameters<dim> &scene,
               const unsigned int          fault,
               const unsigned int          n_intervals = 20);
} // namespace StickSlip

#endif
