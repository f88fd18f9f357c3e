// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/geometry/spline_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    using Vectors = std::vector<Tensor<1, 2>>;



    /** Solve a tridiagonal system: row i is below[i], diagonal[i], above[i]. */
    Vectors
    solve_tridiagonal(const std::vector<double> &below,
                      std::vector<double>        diagonal,
                      const std::vector<double> &above,
                      Vectors                    rhs)
    {
      const unsigned int n = diagonal.size();
      for (unsigned int i = 1; i < n; ++i)
        {
          const double factor = below[i] / diagonal[i - 1];
          diagonal[i] -= factor * above[i - 1];
          rhs[i] -= factor * rhs[i - 1];
        }
      rhs[n - 1] /= diagonal[n - 1];
      for (unsigned int i = n - 1; i-- > 0;)
        rhs[i] = (rhs[i] - above[i] * rhs[i + 1]) / diagonal[i];
      return rhs;
    }



    /** Solve it with below[0] in the last column and the last entry of above in
     * the first one, by the formula of Sherman and Morrison. */
    Vectors
    solve_cyclic(const std::vector<double> &below,
                 std::vector<double>        diagonal,
                 const std::vector<double> &above,
                 const Vectors             &rhs)
    {
      const unsigned int n     = diagonal.size();
      const double       gamma = -diagonal[0], corner = below[0],
                   other = above[n - 1];
      diagonal[0] -= gamma;
      diagonal[n - 1] -= corner * other / gamma;
      Vectors result = solve_tridiagonal(below, diagonal, above, rhs);
      Vectors rank_one(n);
      rank_one[0][0]     = gamma;
      rank_one[n - 1][0] = other;
      rank_one           = solve_tridiagonal(below, diagonal, above, rank_one);
      const double denominator =
        1. + rank_one[0][0] + corner / gamma * rank_one[n - 1][0];
      const Tensor<1, 2> factor =
        (result[0] + corner / gamma * result[n - 1]) / denominator;
      for (unsigned int i = 0; i < n; ++i)
        result[i] -= rank_one[i][0] * factor;
      return result;
    }



    /** Second derivatives at the points of an open curve; @p h: lengths of the
     * chords, @p slope: their directions. */
    Vectors
    open_curvatures(const std::vector<double> &h, const Vectors &slope)
    {
      const unsigned int n = h.size();
      if (n == 1)
        return Vectors(2);
      if (n == 2)
        return Vectors(3, 2. * (slope[1] - slope[0]) / (h[0] + h[1]));
      // Values at the ends follow from their neighbours and are eliminated.
      std::vector<double> below(n - 1), diagonal(n - 1), above(n - 1);
      Vectors             rhs(n - 1);
      for (unsigned int i = 0; i + 1 < n; ++i)
        {
          below[i]    = h[i];
          diagonal[i] = 2. * (h[i] + h[i + 1]);
          above[i]    = h[i + 1];
          rhs[i]      = 6. * (slope[i + 1] - slope[i]);
        }
      diagonal[0] += h[0] + h[0] * h[0] / h[1];
      above[0] -= h[0] * h[0] / h[1];
      diagonal[n - 2] += h[n - 1] + h[n - 1] * h[n - 1] / h[n - 2];
      below[n - 2] -= h[n - 1] * h[n - 1] / h[n - 2];
      const Vectors inner = solve_tridiagonal(below, diagonal, above, rhs);

      Vectors result(n + 1);
      std::copy(inner.begin(), inner.end(), result.begin() + 1);
      result[0] = result[1] - h[0] / h[1] * (result[2] - result[1]);
      result[n] =
        result[n - 1] + h[n - 1] / h[n - 2] * (result[n - 1] - result[n - 2]);
      return result;
    }



    Vectors
    closed_curvatures(const std::vector<double> &h, const Vectors &slope)
    {
      const unsigned int  n = h.size();
      std::vector<double> below(n), diagonal(n), above(n);
      Vectors             rhs(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int previous = (i + n - 1) % n;
          below[i]                    = h[previous];
          diagonal[i]                 = 2. * (h[previous] + h[i]);
          above[i]                    = h[i];
          rhs[i]                      = 6. * (slope[i] - slope[previous]);
        }
      Vectors result = solve_cyclic(below, diagonal, above, rhs);
      result.push_back(result[0]);
      return result;
    }



    double
    distance_from_chord(const Point<2> &a,
                        const Point<2> &b,
                        const Point<2> &point)
    {
      const Tensor<1, 2> chord = b - a;
      const double       s =
        std::clamp((point - a) * chord / chord.norm_square(), 0., 1.);
      return point.distance(a + s * chord);
    }
  } // namespace



  SplineCurve::SplineCurve(const std::vector<Point<2>> &points,
                           const bool                   is_closed)
  {
    const unsigned int n = is_closed ? points.size() : points.size() - 1;
    Assert(points.size() >= (is_closed ? 3 : 2),
           ExcMessage("There are too few points for a curve."));
    std::vector<double> h;
    Vectors             slope;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor<1, 2> chord = points[(i + 1) % points.size()] - points[i];
        h.push_back(chord.norm());
        slope.push_back(chord / chord.norm());
      }
    const Vectors curvature =
      is_closed ? closed_curvatures(h, slope) : open_curvatures(h, slope);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double largest =
          std::max(curvature[i].norm(), curvature[i + 1].norm());
        pieces.push_back({points[i],
                          points[(i + 1) % points.size()],
                          curvature[i],
                          curvature[i + 1],
                          h[i],
                          largest * h[i] * h[i] / 8.});
      }
  }



  Point<2>
  SplineCurve::Piece::value(const double t) const
  {
    const double b = t / length, a = 1. - b, c = length * length / 6.;
    return Point<2>(a * begin + b * Tensor<1, 2>(end) +
                    c * ((a * a * a - a) * begin_curvature +
                         (b * b * b - b) * end_curvature));
  }



  std::array<Tensor<1, 2>, 2>
  SplineCurve::Piece::derivatives(const double t) const
  {
    const double b = t / length, a = 1. - b;
    return {{(end - begin) / length + length / 6. *
                                        ((1. - 3. * a * a) * begin_curvature +
                                         (3. * b * b - 1.) * end_curvature),
             a * begin_curvature + b * end_curvature}};
  }



  double
  SplineCurve::Piece::nearest(const Point<2> &point) const
  {
    double t = std::clamp((point - begin) * (end - begin) / length, 0., length);
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        const Tensor<1, 2> offset  = value(t) - point;
        const auto [first, second] = derivatives(t);
        const double slope         = first * offset;
        // Without the second term far inside of a bend, where it is negative.
        const double full = first * first + second * offset;
        const double curvature =
          full > 0.5 * first.norm_square() ? full : first.norm_square();
        const double next = std::clamp(t - slope / curvature, 0., length);
        const double step = std::abs(next - t);
        t                 = next;
        if (step <= 1e-15 * length)
          break;
      }
    return t;
  }



  Point<2>
  SplineCurve::nearest(const Point<2> &point) const
  {
    // The piece whose chord is nearest says how far it can be at most.
    double bound = std::numeric_limits<double>::max();
    for (const Piece &piece : pieces)
      {
        if (point == piece.begin || point == piece.end)
          return point;
        bound = std::min(bound,
                         distance_from_chord(piece.begin, piece.end, point) +
                           piece.bulge);
      }
    double   least = std::numeric_limits<double>::max();
    Point<2> result;
    for (const Piece &piece : pieces)
      if (distance_from_chord(piece.begin, piece.end, point) - piece.bulge <=
          bound)
        {
          const Point<2> candidate = piece.value(piece.nearest(point));
          const double   distance  = candidate.distance(point);
          if (distance < least)
            {
              least  = distance;
              result = candidate;
            }
        }
    return result;
  }
} // namespace StickSlip
