// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mesh/fault_surface.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  std::array<Point<dim>, FaultSurface<dim>::n_vertices>
  FaultSurface<dim>::face_vertices(const std::vector<Point<dim>> &positions,
                                   const unsigned int             face) const
  {
    std::array<Point<dim>, n_vertices> vertices;
    const unsigned int                 n = n_vertices_of(face);
    for (unsigned int v = 0; v < n; ++v)
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
    const unsigned int last = n_vertices_of(face) - 1;
    Tensor<1, dim>     diagonal =
      points[faces[face][last]] - points[faces[face][0]];
    if (!wraps.empty())
      for (unsigned int d = 0; d < dim - 1; ++d)
        diagonal[d] += (wraps[face][last][d] - wraps[face][0][d]) * period[d];
    return diagonal.norm();
  }



  template <int dim>
  void
  FaultSurface<dim>::set_normals(const std::vector<Tensor<1, dim>> &face_areas)
  {
    AssertDimension(face_areas.size(), faces.size());
    normal = Tensor<1, dim>();
    face_normals.clear();
    if (faces.empty())
      return;
    for (const Tensor<1, dim> &area : face_areas)
      normal += area;
    // A closed surface has no mean; any will do.
    if (normal.norm() > 0.)
      normal /= normal.norm();

    double largest_face = 0.;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        face_normals.push_back(face_areas[f] / face_areas[f].norm());
        largest_face = std::max(largest_face, face_size(f));
      }
    const bool is_in_one_plane =
      std::all_of(face_normals.begin(),
                  face_normals.end(),
                  [&](const Tensor<1, dim> &n) {
                    return (n - normal).norm() <= 1e-10;
                  }) &&
      std::all_of(points.begin(), points.end(), [&](const Point<dim> &x) {
        return std::abs((x - points[0]) * normal) <= 1e-8 * largest_face;
      });
    if (!is_in_one_plane)
      return;
    face_normals.clear();
    face_normals.shrink_to_fit();
    // A level fault is level to the last bit.
    for (unsigned int d = 0; d < dim; ++d)
      for (const double sign : {-1., 1.})
        {
          Tensor<1, dim> axis;
          axis[d] = sign;
          if ((normal - axis).norm() <= 1e-10)
            normal = axis;
        }
  }



  template struct FaultSurface<2>;
  template struct FaultSurface<3>;
} // namespace StickSlip
