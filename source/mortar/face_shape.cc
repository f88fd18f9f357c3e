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

    using Segment       = std::array<Point<1>, 2>;
    using Quadrilateral = std::array<Point<2>, 4>;
    using Vector        = Tensor<1, 2>;

    // Triangles are the first three vertices of what is taken for a
    // quadrilateral otherwise.
    constexpr unsigned int triangle = 3;



    double
    determinant(const Vector &a, const Vector &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    double
    face_measure(const Segment &v, const unsigned int)
    {
      return std::abs(v[1][0] - v[0][0]);
    }



    double
    face_measure(const Quadrilateral &v, const unsigned int n)
    {
      const Vector diagonal = v[n == triangle ? 2 : 3] - v[0];
      const Vector other    = n == triangle ? v[1] - v[0] : v[2] - v[1];
      return std::abs(determinant(diagonal, other)) / 2.;
    }



    bool
    is_valid(const Segment &v, const unsigned int n)
    {
      const double length = face_measure(v, n);
      return length > 0. && std::isfinite(length);
    }



    bool
    is_valid(const Quadrilateral &v, const unsigned int n)
    {
      if (n == triangle)
        return is_convex_counter_clockwise({v[0], v[1], v[2]}) ||
               is_convex_counter_clockwise({v[0], v[2], v[1]});
      return is_convex_counter_clockwise({v[0], v[1], v[3], v[2]}) ||
             is_convex_counter_clockwise({v[0], v[2], v[3], v[1]});
    }



    /** The coordinates s and t of a point of a quadrilateral on the unit
     * square, by Newton's method for the inverse of the bilinear map; a single
     * step on parallelograms. */
    std::array<double, 2>
    unit_coordinates(const Quadrilateral &v, const Point<2> &x)
    {
      const Vector a = v[1] - v[0], b = v[2] - v[0];
      const Vector c      = (v[3] - v[2]) - a;
      const Vector offset = x - v[0];

      double s = 0.5, t = 0.5;
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const Vector residual = offset - s * a - t * b - s * t * c;
          const Vector ds       = a + t * c;
          const Vector dt       = b + s * c;
          const double jacobian = determinant(ds, dt);
          const double step_s   = determinant(residual, dt) / jacobian;
          const double step_t   = determinant(ds, residual) / jacobian;
          s += step_s;
          t += step_t;
          // The convergence is quadratic: what is left is below rounding.
          if (std::abs(step_s) + std::abs(step_t) < 1e-9)
            return {{s, t}};
        }
      AssertThrow(false, ExcMessage(bad_face));
      return {};
    }



    // Both values are quotients of differences, so each keeps its relative
    // accuracy where it is small.
    std::array<double, 2>
    values(const Segment &v, const unsigned int, const Point<1> &x)
    {
      const double length = v[1][0] - v[0][0];
      return {{(v[1][0] - x[0]) / length, (x[0] - v[0][0]) / length}};
    }



    std::array<double, 4>
    values(const Quadrilateral &v, const unsigned int n, const Point<2> &x)
    {
      if (n == triangle)
        {
          const double area = determinant(v[1] - v[0], v[2] - v[0]);
          return {{determinant(v[1] - x, v[2] - x) / area,
                   determinant(v[2] - x, v[0] - x) / area,
                   determinant(v[0] - x, v[1] - x) / area,
                   0.}};
        }
      const auto [s, t] = unit_coordinates(v, x);
      return {{(1. - s) * (1. - t), s * (1. - t), (1. - s) * t, s * t}};
    }



    std::array<Tensor<1, 1>, 2>
    gradients(const Segment &v, const unsigned int, const Point<1> &)
    {
      const double slope = 1. / (v[1][0] - v[0][0]);
      return {{Tensor<1, 1>({-slope}), Tensor<1, 1>({slope})}};
    }



    /** The gradient of a function with these derivatives along two vectors. */
    Vector
    gradient(const Vector &a,
             const Vector &b,
             const double  along_a,
             const double  along_b)
    {
      return Vector({along_a * b[1] - along_b * a[1],
                     along_b * a[0] - along_a * b[0]}) /
             determinant(a, b);
    }



    std::array<Vector, 4>
    gradients(const Quadrilateral &v, const unsigned int n, const Point<2> &x)
    {
      const Vector a = v[1] - v[0], b = v[2] - v[0];
      if (n == triangle)
        return {{gradient(a, b, -1., -1.),
                 gradient(a, b, 1., 0.),
                 gradient(a, b, 0., 1.),
                 Vector()}};
      const auto [s, t] = unit_coordinates(v, x);
      const Vector c    = (v[3] - v[2]) - a;
      const Vector ds = a + t * c, dt = b + s * c;
      return {{gradient(ds, dt, t - 1., s - 1.),
               gradient(ds, dt, 1. - t, -s),
               gradient(ds, dt, -t, 1. - s),
               gradient(ds, dt, t, s)}};
    }



    std::array<double, 2>
    integrals(const Segment &v, const unsigned int n)
    {
      const double half = face_measure(v, n) / 2.;
      return {{half, half}};
    }



    // The Jacobian determinant is linear in the unit coordinates, so each
    // integrand is a product of two linear functions per direction.
    std::array<double, 4>
    integrals(const Quadrilateral &v, const unsigned int n)
    {
      if (n == triangle)
        {
          const double third = face_measure(v, n) / 3.;
          return {{third, third, third, 0.}};
        }
      const auto corner = [&v](const unsigned int i) {
        const Vector along   = v[i | 1] - v[i & 2];
        const Vector towards = v[i | 2] - v[i & 1];
        return std::abs(determinant(along, towards));
      };
      std::array<double, 4> result;
      for (unsigned int i = 0; i < 4; ++i)
        result[i] = (4. * corner(i) + 2. * corner(i ^ 1) + 2. * corner(i ^ 2) +
                     corner(i ^ 3)) /
                    36.;
      return result;
    }
  } // namespace



  template <int dim>
  FaceShape<dim>::FaceShape(
    const std::array<Point<dim - 1>, max_vertices> &vertices,
    const unsigned int                              n_vertices)
    : corners(vertices)
    , n(n_vertices)
  {
    AssertThrow(is_valid(corners, n), ExcMessage(bad_face));
    size = face_measure(corners, n);
  }



  template <int dim>
  std::array<double, FaceShape<dim>::max_vertices>
  FaceShape<dim>::shape_values(const Point<dim - 1> &x) const
  {
    return values(corners, n, x);
  }



  template <int dim>
  std::array<Tensor<1, dim - 1>, FaceShape<dim>::max_vertices>
  FaceShape<dim>::shape_gradients(const Point<dim - 1> &x) const
  {
    return gradients(corners, n, x);
  }



  template <int dim>
  std::array<double, FaceShape<dim>::max_vertices>
  FaceShape<dim>::shape_integrals() const
  {
    return integrals(corners, n);
  }



  template class FaceShape<2>;
  template class FaceShape<3>;
} // namespace StickSlip
