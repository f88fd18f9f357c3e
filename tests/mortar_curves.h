// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_mortar_curves_h
#define stickslip_tests_mortar_curves_h

#include <stickslip/mesh/nodal_normals.h>

#include <functional>

#include "mortar_surfaces.h"

namespace StickSlip
{
  /** A polygonal line with the normal to the left of its direction; a closed
   * one joins the last node to the first. */
  inline Side<2>
  polygonal_line(const std::vector<Point<2>> &points,
                 const bool                   is_closed = false)
  {
    Side<2>                   side;
    std::vector<Tensor<1, 2>> areas;
    const unsigned int        n = points.size();
    for (const Point<2> &x : points)
      {
        side.surface.nodes.push_back(side.surface.nodes.size());
        side.surface.points.push_back(x);
      }
    for (unsigned int i = 0; i < (is_closed ? n : n - 1); ++i)
      {
        side.surface.faces.push_back({{i, (i + 1) % n}});
        const Tensor<1, 2> edge = points[(i + 1) % n] - points[i];
        areas.push_back(Tensor<1, 2>({-edge[1], edge[0]}));
      }
    side.positions = points;
    side.surface.set_normals(areas);
    return side;
  }



  inline Side<2>
  curve(const std::vector<double>                   &parameters,
        const std::function<Point<2>(const double)> &position,
        const bool                                   is_closed = false)
  {
    std::vector<Point<2>> points;
    for (const double s : parameters)
      points.push_back(position(s));
    return polygonal_line(points, is_closed);
  }



  /** @p n faces around a circle about the origin, the normal inwards. */
  inline Side<2>
  circle(const unsigned int n, const double radius, const double first_angle)
  {
    std::vector<double> angles;
    for (unsigned int i = 0; i < n; ++i)
      angles.push_back(first_angle + 2. * numbers::PI * i / n);
    return curve(
      angles,
      [radius](const double angle) {
        return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
      },
      true);
  }



  /** A curved surface over a grid of two parameters, of quadrilaterals or of
   * triangles, two for each of these; the normal is that of the parameters in
   * their order. */
  inline Side<3>
  curved_grid(
    const std::vector<double>                                 &a,
    const std::vector<double>                                 &b,
    const std::function<Point<3>(const double, const double)> &position,
    const bool of_triangles = false)
  {
    Side<3>      side = grid(a, b);
    unsigned int k    = 0;
    for (const double y : b)
      for (const double x : a)
        side.positions[k++] = position(x, y);
    side.surface.points = side.positions;

    const auto quadrilaterals = side.surface.faces;
    if (of_triangles)
      {
        side.surface.faces.clear();
        for (const auto &f : quadrilaterals)
          {
            const unsigned int none = numbers::invalid_unsigned_int;
            side.surface.faces.push_back({{f[0], f[1], f[2], none}});
            side.surface.faces.push_back({{f[3], f[2], f[1], none}});
          }
      }
    std::vector<Tensor<1, 3>> areas;
    for (const auto &f : side.surface.faces)
      {
        const auto        &x           = side.positions;
        const bool         is_triangle = f[3] == numbers::invalid_unsigned_int;
        const Tensor<1, 3> one =
          is_triangle ? x[f[1]] - x[f[0]] : x[f[3]] - x[f[0]];
        const Tensor<1, 3> other =
          is_triangle ? x[f[2]] - x[f[0]] : x[f[2]] - x[f[1]];
        areas.push_back(0.5 * cross_product_3d(one, other));
      }
    side.surface.set_normals(areas);
    return side;
  }



  /** A side moved by a rotation and a translation. */
  template <int dim>
  Side<dim>
  moved(const Side<dim>      &side,
        const Tensor<2, dim> &rotation,
        const Tensor<1, dim> &translation)
  {
    Side<dim> result = side;
    for (auto *points : {&result.positions, &result.surface.points})
      for (Point<dim> &x : *points)
        x = Point<dim>(rotation * x + translation);
    result.surface.normal = rotation * side.surface.normal;
    for (Tensor<1, dim> &normal : result.surface.face_normals)
      normal = rotation * normal;
    return result;
  }



  inline Tensor<2, 2>
  rotation_by(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return Tensor<2, 2>({{c, -s}, {s, c}});
  }



  /** The jumps at active slave nodes of values on both sides, in the axes of
   * space; with the rotation term or without. */
  template <int dim>
  std::vector<Tensor<1, dim>>
  jumps(const MortarCoupling<dim>                               &coupling,
        const Side<dim>                                         &slave,
        const Side<dim>                                         &master,
        const std::function<Tensor<1, dim>(const Point<dim> &)> &value,
        const bool with_rotation_term = true)
  {
    std::vector<Tensor<1, dim>> result(slave.positions.size());
    for (unsigned int p = 0; p < result.size(); ++p)
      {
        if (!coupling.active[p])
          continue;
        result[p] = value(slave.positions[p]);
        for (const auto &[q, N] : coupling.master_rows[p])
          result[p] -= N * value(master.positions[q]);
        for (const auto &[k, S] : coupling.inactive_slave_rows[p])
          result[p] -= S * value(slave.positions[k]);
        if (with_rotation_term && !coupling.rotation_rows.empty())
          for (const auto &[q, C] : coupling.rotation_rows[p])
            result[p] += C * value(master.positions[q]);
      }
    return result;
  }



  template <int dim>
  double
  largest(const std::vector<Tensor<1, dim>> &vectors)
  {
    double result = 0.;
    for (const Tensor<1, dim> &vector : vectors)
      result = std::max(result, vector.norm());
    return result;
  }
} // namespace StickSlip

#endif
