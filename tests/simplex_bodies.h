// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_simplex_bodies_h
#define stickslip_tests_simplex_bodies_h

#include <deal.II/grid/grid_generator.h>

#include <stickslip/geometry/coarse_body.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /** A brick whose coarse cells are cut into triangles or tetrahedra. */
  template <int dim>
  CoarseBody<dim>
  simplex_brick(const BodyGeometry<dim> &geometry)
  {
    CoarseBody<dim> body  = coarse_brick(geometry);
    const auto      cells = std::make_shared<Triangulation<dim>>();
    GridGenerator::convert_hypercube_to_simplex_mesh(*body.cells, *cells);
    body.cells = cells;
    return body;
  }



  template <int dim>
  std::vector<CoarseBody<dim>>
  simplex_bricks(const std::vector<BodyGeometry<dim>> &geometries)
  {
    std::vector<CoarseBody<dim>> bodies;
    for (const BodyGeometry<dim> &geometry : geometries)
      bodies.push_back(simplex_brick(geometry));
    return bodies;
  }
} // namespace StickSlip

#endif
