// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mortar/face_shape.h>
#include <stickslip/mortar/polygon_clipping.h>

#include <cmath>

namespace StickSlip
{
  namespace
  {
    const char *const bad_face =
      "A face of a fault surface has no area or is turned inside out. The "
      "deformation next to the fault is too large for the mesh.";



    double
    face_measure(const std::array<Point<1>, 2> &v)
    {
      return std::abs(v[1][0] - v[0][0]);
    }



    double
    face_measure(const std::array<Point<2>, 4> &v)
    {
      const Tensor<1, 2> diagonal = v[3] - v[0], other = v[2] - v[1];
      return std::abs(diagonal[0] * other[1] - diagonal[1] * other[0]) / 2.;
    }



    bool
    is_valid(const std::array<Point<1>, 2> &v)
    {
      const double length = face_measure(v);
      return length > 0. && std::isfinite(length);
    }



    bool
    is_valid(const std::array<Point<2>, 4> &v)
    {
      return is_convex_counter_clockwise({v[0], v[1], v[3], v[2]}) ||
             is_convex_counter_clockwise({v[0], v[2], v[3], v[1]});
    }



    // Both values are quotients of differences, so each keeps its relative
    // accuracy where it is small.
    std::array<double, 2>
    face_shape_values(const std::array<Point<1>, 2> &v, const Point<1> &x)
    {
      const double length = v[1][0] - v[0][0];
      return {{(v[1][0] - x[0]) / length, (x[0] - v[0][0]) / length}};
    }



    // Newton's method for the inverse of the bilinear map; a single step on
    // parallelograms.
    std::array<double, 4>
    face_shape_values(const std::array<Point<2>, 4> &v, const Point<2> &x)
    {
      const Tensor<1, 2> a = v[1] - v[0], b = v[2] - v[0];
      const Tensor<1, 2> c      = (v[3] - v[2]) - a;
      const Tensor<1, 2> offset = x - v[0];

      double s = 0.5, t = 0.5;
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const Tensor<1, 2> residual    = offset - s * a - t * b - s * t * c;
          const Tensor<1, 2> ds          = a + t * c;
          const Tensor<1, 2> dt          = b + s * c;
          const double       determinant = ds[0] * dt[1] - ds[1] * dt[0];
          const double       step_s =
            (residual[0] * dt[1] - residual[1] * dt[0]) / determinant;
          const double step_t =
            (ds[0] * residual[1] - ds[1] * residual[0]) / determinant;
          s += step_s;
          t += step_t;
          // The convergence is quadratic: what is left is below rounding.
          if (std::abs(step_s) + std::abs(step_t) < 1e-9)
            return {{(1. - s) * (1. - t), s * (1. - t), (1. - s) * t, s * t}};
        }
      AssertThrow(false, ExcMessage(bad_face));
      return {};
    }



    std::array<double, 2>
    face_shape_integrals(const std::array<Point<1>, 2> &v)
    {
      const double half = face_measure(v) / 2.;
      return {{half, half}};
    }



    // The Jacobian determinant is linear in the unit coordinates, so each
    // integrand is a product of two linear functions per direction.
    std::array<double, 4>
    face_shape_integrals(const std::array<Point<2>, 4> &v)
    {
      const auto corner = [&v](const unsigned int i) {
        const Tensor<1, 2> along   = v[i | 1] - v[i & 2];
        const Tensor<1, 2> towards = v[i | 2] - v[i & 1];
        return std::abs(along[0] * towards[1] - along[1] * towards[0]);
      };
      std::array<double, 4> integrals;
      for (unsigned int i = 0; i < 4; ++i)
        integrals[i] = (4. * corner(i) + 2. * corner(i ^ 1) +
                        2. * corner(i ^ 2) + corner(i ^ 3)) /
                       36.;
      return integrals;
    }
  } // namespace



  template <int dim>
  FaceShape<dim>::FaceShape(
    const std::array<Point<dim - 1>, n_vertices> &vertices)
    : corners(vertices)
  {
    AssertThrow(is_valid(corners), ExcMessage(bad_face));
    size = face_measure(corners);
  }



  template <int dim>
  const std::array<Point<dim - 1>, FaceShape<dim>::n_vertices> &
  FaceShape<dim>::vertices() const
  {
    return corners;
  }



  template <int dim>
  std::array<double, FaceShape<dim>::n_vertices>
  FaceShape<dim>::shape_values(const Point<dim - 1> &x) const
  {
    return face_shape_values(corners, x);
  }



  template <int dim>
  std::array<double, FaceShape<dim>::n_vertices>
  FaceShape<dim>::shape_integrals() const
  {
    return face_shape_integrals(corners);
  }



  template class FaceShape<2>;
  template class FaceShape<3>;
} // namespace StickSlip
