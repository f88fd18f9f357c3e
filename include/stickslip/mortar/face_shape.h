// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_face_shape_h
#define stickslip_mortar_face_shape_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <array>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A fault face in the fault plane: a segment in two dimensions, a
   * convex quadrilateral in three, with the linear or bilinear shape functions
   * of its vertices.
   */
  template <int dim>
  class FaceShape
  {
  public:
    static constexpr unsigned int n_vertices =
      GeometryInfo<dim>::vertices_per_face;

    /**
     * The face with these @p vertices (in the fault plane, m), in deal.II's
     * order. The sense of rotation does not matter. Throws ExcMessage if the
     * face has no area or is not convex: then the deformation has turned the
     * surface inside out.
     */
    explicit FaceShape(const std::array<Point<dim - 1>, n_vertices> &vertices);

    const std::array<Point<dim - 1>, n_vertices> &
    vertices() const;

    /** Length (m) or area (m^2). */
    double
    measure() const
    {
      return size;
    }

    /**
     * The shape functions of all vertices at a point of the face, given in the
     * coordinates of the fault plane.
     */
    std::array<double, n_vertices>
    shape_values(const Point<dim - 1> &x) const;

    /** The integrals of the shape functions over the whole face. */
    std::array<double, n_vertices>
    shape_integrals() const;

  private:
    std::array<Point<dim - 1>, n_vertices> corners;
    double                                 size;
  };
} // namespace StickSlip

#endif
