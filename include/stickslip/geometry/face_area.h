// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_face_area_h
#define stickslip_geometry_face_area_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <stickslip/geometry/cell_faces.h>

#include <array>

namespace StickSlip
{
  /** The mean of the vertices of a face, m. */
  template <int dim>
  Point<dim>
  face_centre(const GroupedCells<dim>             &mesh,
              const typename CellFaces<dim>::Face &face);

  /** The area of a face, m^(dim-1), times the normal around which its ring of
   * vertices turns; in two dimensions that to the right of the line. */
  template <int dim>
  Tensor<1, dim>
  face_area(const GroupedCells<dim>             &mesh,
            const typename CellFaces<dim>::Face &face);

  /** The area of a face by the first @p n_vertices of its vertices in
   * deal.II's order, m^(dim-1), times its normal on one side, which depends on
   * that order: of a line to the right of it. */
  template <int dim>
  Tensor<1, dim>
  face_area(const std::array<Point<dim>, GeometryInfo<dim>::vertices_per_face>
                              &vertices,
            const unsigned int n_vertices);
} // namespace StickSlip

#endif
