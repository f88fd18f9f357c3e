// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mesh/fault_surface.h>

namespace StickSlip
{
  template <int dim>
  std::array<Point<dim - 1>, FaultSurface<dim>::n_vertices>
  FaultSurface<dim>::face_vertices(const std::vector<Point<dim - 1>> &positions,
                                   const unsigned int face) const
  {
    std::array<Point<dim - 1>, n_vertices> vertices;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        AssertIndexRange(faces[face][v], positions.size());
        vertices[v] = positions[faces[face][v]];
        if (!wraps.empty())
          for (unsigned int d = 0; d < dim - 1; ++d)
            vertices[v][d] += wraps[face][v][d] * period[d];
      }
    return vertices;
  }



  template <int dim>
  double
  FaultSurface<dim>::face_size(const unsigned int face) const
  {
    const unsigned int last = n_vertices - 1;
    Tensor<1, dim>     diagonal =
      points[faces[face][last]] - points[faces[face][0]];
    if (!wraps.empty())
      for (unsigned int d = 0; d < dim - 1; ++d)
        diagonal[d] += (wraps[face][last][d] - wraps[face][0][d]) * period[d];
    return diagonal.norm();
  }



  template struct FaultSurface<2>;
  template struct FaultSurface<3>;
} // namespace StickSlip
