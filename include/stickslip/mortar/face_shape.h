// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_face_shape_h
#define stickslip_mortar_face_shape_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A fault face in its plane, or one opposite to it projected there: a segment
   * in two dimensions, a triangle or a convex quadrilateral in three, with the
   * linear or bilinear shape functions of its vertices.
   */
  template <int dim>
  class FaceShape
  {
  public:
    /** The most vertices of a face. Arrays over the vertices have this size;
     * the last entries of a triangle are zero. */
    static constexpr unsigned int max_vertices =
      GeometryInfo<dim>::vertices_per_face;

    /**
     * The face with the first @p n_vertices of these @p vertices (coordinates
     * in the plane, m), in deal.II's order. The sense of rotation does not
     * matter. Throws ExcMessage if the face has no area or is not convex: then
     * the deformation has turned the surface inside out.
     */
    explicit FaceShape(const std::array<Point<dim - 1>, max_vertices> &vertices,
                       const unsigned int n_vertices = max_vertices);

    unsigned int
    n_vertices() const
    {
      return n;
    }

    const std::array<Point<dim - 1>, max_vertices> &
    vertices() const
    {
      return corners;
    }

    /** Length (m) or area (m^2). */
    double
    measure() const
    {
      return size;
    }

    /**
     * The shape functions of all vertices at a point of the face, given in the
     * coordinates of the plane.
     */
    std::array<double, max_vertices>
    shape_values(const Point<dim - 1> &x) const;

    /** The gradients of the shape functions in the plane, 1/m. */
    std::array<Tensor<1, dim - 1>, max_vertices>
    shape_gradients(const Point<dim - 1> &x) const;

    /** The integrals of the shape functions over the whole face. */
    std::array<double, max_vertices>
    shape_integrals() const;

  private:
    std::array<Point<dim - 1>, max_vertices> corners;
    unsigned int                             n;
    double                                   size;
  };
} // namespace StickSlip

#endif
