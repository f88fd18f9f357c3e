// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/face_area.h>

namespace StickSlip
{
  template <int dim>
  Point<dim>
  face_centre(const GroupedCells<dim>             &mesh,
              const typename CellFaces<dim>::Face &face)
  {
    Point<dim> result;
    for (unsigned int v = 0; v < face.n_vertices; ++v)
      result += mesh.points[face.ring[v]] / face.n_vertices;
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  face_area(const GroupedCells<dim>             &mesh,
            const typename CellFaces<dim>::Face &face)
  {
    const auto point = [&](const unsigned int v) {
      return mesh.points[face.ring[v]];
    };
    if constexpr (dim == 2)
      return cross_product_2d(point(1) - point(0));
    else if (face.n_vertices == 3)
      return 0.5 * cross_product_3d(point(1) - point(0), point(2) - point(0));
    else
      return 0.5 * cross_product_3d(point(2) - point(0), point(3) - point(1));
  }



  template <int dim>
  Tensor<1, dim>
  face_area(const std::array<Point<dim>, GeometryInfo<dim>::vertices_per_face>
                              &vertices,
            const unsigned int n_vertices)
  {
    const auto &v = vertices;
    if constexpr (dim == 2)
      return cross_product_2d(v[1] - v[0]);
    else if (n_vertices == 3)
      return 0.5 * cross_product_3d(v[1] - v[0], v[2] - v[0]);
    else
      return 0.5 * cross_product_3d(v[3] - v[0], v[2] - v[1]);
  }



  template Point<2>
  face_centre<2>(const GroupedCells<2> &, const CellFaces<2>::Face &);
  template Point<3>
  face_centre<3>(const GroupedCells<3> &, const CellFaces<3>::Face &);
  template Tensor<1, 2>
  face_area<2>(const GroupedCells<2> &, const CellFaces<2>::Face &);
  template Tensor<1, 3>
  face_area<3>(const GroupedCells<3> &, const CellFaces<3>::Face &);
  template Tensor<1, 2>
  face_area<2>(const std::array<Point<2>, 2> &, const unsigned int);
  template Tensor<1, 3>
  face_area<3>(const std::array<Point<3>, 4> &, const unsigned int);
} // namespace StickSlip
