// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/mesh/face_area.h>
#include <stickslip/mesh/smooth_shape.h>
#include <stickslip/mesh/smooth_surface.h>
#include <stickslip/mesh/spline_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace StickSlip
{
  namespace
  {
    /** The nearest of several curves. */
    class SmoothShape : public FaultShape<2>
    {
    public:
      explicit SmoothShape(const std::vector<SplineCurve> &curves)
        : curves(curves)
      {}

      virtual Point<2>
      place(const Point<2> &point) const override
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

    private:
      std::vector<SplineCurve> curves;
    };



    /** The vertices of the faces on one side, and which are joined. */
    class JoinedVertices
    {
    public:
      JoinedVertices(const std::vector<BodyCells<2>> &bodies,
                     const std::vector<BodySide>     &side)
      {
        for (const BodySide &part : side)
          {
            const BodyCells<2> &body = bodies[part.body];
            for (const auto &face : body.boundary.boundary_lines)
              if (face.boundary_id == part.side)
                {
                  const unsigned int a =
                                       number(body.vertices[face.vertices[0]]),
                                     b =
                                       number(body.vertices[face.vertices[1]]);
                  joined[a].push_back(b);
                  joined[b].push_back(a);
                }
          }
        is_used.resize(points.size(), false);
      }

      unsigned int
      size() const
      {
        return points.size();
      }

      /** Take the curves out, as long as there are any: open ones, and closed
       * ones where a curve begins and ends at one vertex. */
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
      /** Vertices of several bodies are one if they are at the same place up
       * to rounding. */
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

      /** True at the ends of the fault and its corners. */
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

      /** The vertices from one on, by way of a neighbour, to the next end or
       * back to itself. Those between become used. */
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


    /** The faces on one side in space, and the vertices they join: those of
     * several bodies are one if they are at the same place up to rounding. */
    struct JoinedFaces
    {
      std::vector<Point<3>>                  points;
      std::vector<std::vector<unsigned int>> faces;

      JoinedFaces(const std::vector<BodyCells<3>> &bodies,
                  const std::vector<BodySide>     &side)
      {
        for (const BodySide &part : side)
          {
            const BodyCells<3>                  &body = bodies[part.body];
            const unsigned int                   n_of_others = points.size();
            std::map<unsigned int, unsigned int> number;
            for (const auto &face : body.boundary.boundary_quads)
              if (face.boundary_id == part.side)
                {
                  faces.emplace_back();
                  for (const unsigned int v : face.vertices)
                    {
                      const auto [place, is_new] =
                        number.emplace(v, points.size());
                      if (is_new)
                        place->second =
                          find_or_add(body.vertices[v], n_of_others);
                      faces.back().push_back(place->second);
                    }
                }
          }
      }

    private:
      unsigned int
      find_or_add(const Point<3> &point, const unsigned int n_of_others)
      {
        for (unsigned int v = 0; v < n_of_others; ++v)
          if (points[v].distance(point) <= 1e-10 * point.norm())
            return v;
        points.push_back(point);
        return points.size() - 1;
      }
    };



    /** Add the plane of a face, unless it is there. */
    void
    add_plane(const std::vector<Point<3>>       &points,
              const std::vector<unsigned int>   &face,
              std::vector<SmoothSurface::Plane> &planes)
    {
      std::array<Point<3>, 4> vertices;
      for (unsigned int v = 0; v < face.size(); ++v)
        vertices[v] = points[face[v]];
      const Tensor<1, 3> area      = face_area<3>(vertices, face.size());
      const double       tolerance = 1e-9 * std::sqrt(area.norm());
      const bool         is_there =
        std::any_of(planes.begin(), planes.end(), [&](const auto &plane) {
          return std::all_of(face.begin(), face.end(), [&](const auto v) {
            return plane.contains(points[v], tolerance);
          });
        });
      if (!is_there)
        planes.push_back({vertices[0], area / area.norm()});
    }



    /** The planes of other boundary faces that share an edge with a fault. */
    std::vector<SmoothSurface::Plane>
    planes_at(const std::vector<BodyCells<3>> &bodies, const Fault &fault)
    {
      std::vector<SmoothSurface::Plane> planes;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          std::set<types::boundary_id> of_fault;
          for (const auto &side : fault.sides)
            for (const BodySide &part : side)
              if (part.body == b)
                of_fault.insert(part.side);
          std::set<unsigned int> at_fault;
          for (const auto &face : bodies[b].boundary.boundary_quads)
            if (of_fault.count(face.boundary_id) > 0)
              at_fault.insert(face.vertices.begin(), face.vertices.end());
          for (const auto &face : bodies[b].boundary.boundary_quads)
            if (of_fault.count(face.boundary_id) == 0 &&
                std::count_if(face.vertices.begin(),
                              face.vertices.end(),
                              [&](const unsigned int v) {
                                return at_fault.count(v) > 0;
                              }) > 1)
              add_plane(bodies[b].vertices, face.vertices, planes);
        }
      return planes;
    }
  } // namespace



  template <>
  std::shared_ptr<const FaultShape<2>>
  smooth_shape<2>(const std::vector<BodyCells<2>> &bodies, const Fault &fault)
  {
    JoinedVertices first(bodies, fault.sides[0]),
      second(bodies, fault.sides[1]);
    return std::make_shared<SmoothShape>(
      (second.size() > first.size() ? second : first).curves());
  }



  template <>
  std::shared_ptr<const FaultShape<3>>
  smooth_shape<3>(const std::vector<BodyCells<3>> &bodies, const Fault &fault)
  {
    const JoinedFaces first(bodies, fault.sides[0]),
      second(bodies, fault.sides[1]);
    const JoinedFaces &side =
      second.points.size() > first.points.size() ? second : first;
    return std::make_shared<SmoothSurface>(side.points,
                                           side.faces,
                                           planes_at(bodies, fault));
  }
} // namespace StickSlip
