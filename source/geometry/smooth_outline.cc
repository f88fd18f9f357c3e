// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/geometry/smooth_outline.h>

#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The points of lines, and which are joined. */
    class JoinedPoints
    {
    public:
      explicit JoinedPoints(const std::vector<std::vector<Point<2>>> &lines)
      {
        for (const std::vector<Point<2>> &line : lines)
          for (unsigned int i = 1; i < line.size(); ++i)
            {
              const unsigned int a = number(line[i - 1]), b = number(line[i]);
              joined[a].push_back(b);
              joined[b].push_back(a);
            }
        is_used.resize(points.size(), false);
      }

      unsigned int
      size() const
      {
        return points.size();
      }

      /** Take the curves out, as long as there are any: open ones, and closed
       * ones where a curve begins and ends at one point. */
      std::vector<SplineCurve>
      curves()
      {
        std::vector<SplineCurve> result;
        for (unsigned int v = 0; v < points.size(); ++v)
          if (ends_at(v))
            for (const unsigned int next : joined[v])
              if (!is_used[next] || (ends_at(next) && next > v))
                result.push_back(SplineCurve(from(v, next), false));
        for (unsigned int v = 0; v < points.size(); ++v)
          if (!is_used[v] && !ends_at(v))
            {
              std::vector<Point<2>> line = from(v, joined[v][0]);
              line.pop_back();
              result.push_back(SplineCurve(line, true));
            }
        return result;
      }

    private:
      unsigned int
      number(const Point<2> &point)
      {
        for (unsigned int v = 0; v < points.size(); ++v)
          if (points[v].distance(point) <= 1e-10 * point.norm())
            return v;
        points.push_back(point);
        joined.emplace_back();
        return points.size() - 1;
      }

      /** True at the ends of lines and their corners. */
      bool
      ends_at(const unsigned int v) const
      {
        if (joined[v].size() != 2)
          return true;
        const Tensor<1, 2> before = points[v] - points[joined[v][0]],
                           behind = points[joined[v][1]] - points[v];
        return before * behind < std::cos(least_corner * numbers::PI / 180.) *
                                   before.norm() * behind.norm();
      }

      /** The points from one on, by way of a neighbour, to the next end or back
       * to itself. Those between become used. */
      std::vector<Point<2>>
      from(const unsigned int first, const unsigned int second)
      {
        std::vector<Point<2>> line     = {points[first]};
        unsigned int          previous = first, v = second;
        while (v != first && !ends_at(v))
          {
            is_used[v] = true;
            line.push_back(points[v]);
            const unsigned int next =
              joined[v][0] == previous ? joined[v][1] : joined[v][0];
            previous = v;
            v        = next;
          }
        is_used[first] = true;
        line.push_back(points[v]);
        return line;
      }

      std::vector<Point<2>>                  points;
      std::vector<std::vector<unsigned int>> joined;
      std::vector<bool>                      is_used;
    };
  } // namespace



  SmoothOutline::SmoothOutline(const std::vector<std::vector<Point<2>>> &lines)
  {
    JoinedPoints joined(lines);
    n      = joined.size();
    curves = joined.curves();
  }



  Point<2>
  SmoothOutline::place(const Point<2> &point) const
  {
    Point<2> result;
    double   least = std::numeric_limits<double>::max();
    for (const SplineCurve &curve : curves)
      {
        const Point<2> candidate = curve.nearest(point);
        if (candidate.distance(point) < least)
          {
            least  = candidate.distance(point);
            result = candidate;
          }
      }
    return result;
  }
} // namespace StickSlip
