// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/height_function.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    using Terms = std::array<double, HeightFunction::n_terms>;



    /** Terms by rising degree. */
    Terms
    terms(const double x, const double y)
    {
      return {{x,
               y,
               x * x,
               x * y,
               y * y,
               x * x * x,
               x * x * y,
               x * y * y,
               y * y * y}};
    }



    Terms
    derivatives_along_x(const double x, const double y)
    {
      return {{1., 0., 2. * x, y, 0., 3. * x * x, 2. * x * y, y * y, 0.}};
    }



    Terms
    derivatives_along_y(const double x, const double y)
    {
      return {{0., 1., 0., x, 2. * y, 0., x * x, 2. * x * y, 3. * y * y}};
    }



    double
    product(const Terms &a, const Terms &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }



    /** Solve the first n equations with a symmetric matrix by Cholesky's
     * method; false if a pivot is less than this part of the diagonal entry:
     * terms that points hardly tell apart. */
    bool
    solve(std::array<Terms, HeightFunction::n_terms> matrix,
          const unsigned int                         n,
          const double                               least_pivot,
          Terms                                     &b)
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          const double diagonal = matrix[i][i];
          for (unsigned int j = 0; j <= i; ++j)
            {
              for (unsigned int k = 0; k < j; ++k)
                matrix[i][j] -= matrix[i][k] * matrix[j][k];
              if (j < i)
                matrix[i][j] /= matrix[j][j];
            }
          if (!(matrix[i][i] > least_pivot * diagonal))
            return false;
          matrix[i][i] = std::sqrt(matrix[i][i]);
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int k = 0; k < i; ++k)
            b[i] -= matrix[i][k] * b[k];
          b[i] /= matrix[i][i];
        }
      for (unsigned int i = n; i-- > 0;)
        {
          for (unsigned int k = i + 1; k < n; ++k)
            b[i] -= matrix[k][i] * b[k];
          b[i] /= matrix[i][i];
        }
      return true;
    }
  } // namespace



  HeightFunction::HeightFunction(const Point<3>     &origin,
                                 const Tensor<1, 3> &normal)
    : origin(origin)
    , normal(normal)
  {
    // The axis farthest from the normal.
    Tensor<1, 3> axis;
    unsigned int least = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(normal[d]) < std::abs(normal[least]))
        least = d;
    axis[least] = 1.;
    tangents[0] = cross_product_3d(normal, axis);
    tangents[0] /= tangents[0].norm();
    tangents[1] = cross_product_3d(normal, tangents[0]);
  }



  std::array<double, 3>
  HeightFunction::components(const Tensor<1, 3> &vector) const
  {
    return {{tangents[0] * vector / size,
             tangents[1] * vector / size,
             normal * vector / size}};
  }



  bool
  HeightFunction::fit(const std::vector<Point<3>> &points,
                      const unsigned int           degree)
  {
    // As many terms as there are up to this degree.
    const unsigned int n = (degree + 1) * (degree + 2) / 2 - 1;
    if (points.size() < n)
      return false;
    size = 0.;
    for (const Point<3> &point : points)
      size = std::max(size, point.distance(origin));
    std::array<Terms, n_terms> matrix = {};
    Terms                      right  = {};
    for (const Point<3> &point : points)
      {
        const auto   y      = components(point - origin);
        const Terms  t      = terms(y[0], y[1]);
        const double weight = 1. / (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
        for (unsigned int i = 0; i < n; ++i)
          {
            right[i] += weight * t[i] * y[2];
            for (unsigned int j = 0; j < n; ++j)
              matrix[i][j] += weight * t[i] * t[j];
          }
      }
    if (!solve(matrix, n, 1e-2, right))
      return false;
    coefficients = right;
    return true;
  }



  Point<3>
  HeightFunction::moved_along(const Point<3>     &point,
                              const Tensor<1, 3> &direction) const
  {
    const std::array<double, 3> start = components(point - origin),
                                along = components(direction);
    double s                          = 0.;
    // Newton's method; along the normal the first step is exact.
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const double x = start[0] + s * along[0], y = start[1] + s * along[1],
                     above = start[2] + s * along[2] -
                             product(coefficients, terms(x, y)),
                     slope = along[2] -
                             along[0] * product(coefficients,
                                                derivatives_along_x(x, y)) -
                             along[1] *
                               product(coefficients, derivatives_along_y(x, y));
        s -= above / slope;
        if (std::abs(above) <= 1e-16)
          break;
      }
    return point + s * direction;
  }
} // namespace StickSlip
