// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/geometry/face_area.h>
#include <stickslip/geometry/smooth_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace StickSlip
{
  namespace
  {
    using Faces = std::vector<std::vector<unsigned int>>;



    /** The edges of a face, vertices in rising order; for each whether the face
     * goes through it that way. */
    std::vector<std::pair<std::array<unsigned int, 2>, bool>>
    edges_of(const std::vector<unsigned int> &face)
    {
      std::vector<unsigned int> ring = face;
      if (ring.size() == 4)
        std::swap(ring[2], ring[3]);
      std::vector<std::pair<std::array<unsigned int, 2>, bool>> result;
      for (unsigned int i = 0; i < ring.size(); ++i)
        {
          const unsigned int a = ring[i], b = ring[(i + 1) % ring.size()];
          result.push_back({{{std::min(a, b), std::max(a, b)}}, a < b});
        }
      return result;
    }



    Tensor<1, 3>
    area_of(const std::vector<unsigned int> &face,
            const std::vector<Point<3>>     &points)
    {
      std::array<Point<3>, 4> vertices;
      for (unsigned int v = 0; v < face.size(); ++v)
        vertices[v] = points[face[v]];
      return face_area<3>(vertices, face.size());
    }



    /** Faces that are joined by edges at which they turn by less than
     * least_corner, and their areas, m^2, to the same side. */
    struct SmoothPart
    {
      Faces                     faces;
      std::vector<Tensor<1, 3>> areas;
    };



    std::vector<SmoothPart>
    smooth_parts(const Faces &faces, const std::vector<Point<3>> &points)
    {
      std::map<std::array<unsigned int, 2>,
               std::vector<std::pair<unsigned int, bool>>>
                                at_edge;
      std::vector<Tensor<1, 3>> areas;
      for (unsigned int f = 0; f < faces.size(); ++f)
        {
          areas.push_back(area_of(faces[f], points));
          for (const auto &[edge, forwards] : edges_of(faces[f]))
            at_edge[edge].emplace_back(f, forwards);
        }
      std::vector<SmoothPart> parts;
      std::vector<bool>       is_used(faces.size(), false);
      for (unsigned int first = 0; first < faces.size(); ++first)
        {
          if (is_used[first])
            continue;
          is_used[first] = true;
          parts.emplace_back();
          // Faces to be looked at, and their areas to the side of the first.
          std::vector<std::pair<unsigned int, Tensor<1, 3>>> next = {
            {first, areas[first]}};
          while (!next.empty())
            {
              const auto [face, area] = next.back();
              next.pop_back();
              parts.back().faces.push_back(faces[face]);
              parts.back().areas.push_back(area);
              for (const auto &[edge, forwards] : edges_of(faces[face]))
                for (const auto &[other, other_forwards] : at_edge[edge])
                  {
                    if (is_used[other])
                      continue;
                    // Neighbours that are turned alike go through their edge
                    // in opposite directions.
                    const bool is_turned_alike = forwards != other_forwards;
                    const Tensor<1, 3> own = areas[face], its = areas[other];
                    const double cosine = own * its / own.norm() / its.norm() *
                                          (is_turned_alike ? 1. : -1.);
                    if (cosine < std::cos(least_corner * numbers::PI / 180.))
                      continue;
                    is_used[other] = true;
                    next.emplace_back(
                      other, (area * own > 0.) == is_turned_alike ? its : -its);
                  }
            }
        }
      return parts;
    }



    /** Heights at the vertices of a part. */
    class HeightFits
    {
    public:
      HeightFits(const SmoothPart &part, const std::vector<Point<3>> &points)
        : part(part)
        , points(points)
      {
        for (unsigned int f = 0; f < part.faces.size(); ++f)
          for (const unsigned int v : part.faces[f])
            faces_at[v].push_back(f);
      }

      std::map<unsigned int, HeightFunction>
      heights() const
      {
        std::map<unsigned int, HeightFunction> result;
        for (const auto &[vertex, around] : faces_at)
          {
            Tensor<1, 3> normal;
            for (const unsigned int f : around)
              normal += part.areas[f];
            HeightFunction height(points[vertex], normal / normal.norm());
            fit(vertex, height);
            result.emplace(vertex, height);
          }
        return result;
      }

    private:
      /** Of each degree, from vertices farther and farther away until these
       * determine it, but not beyond what it can describe. */
      void
      fit(const unsigned int vertex, HeightFunction &height) const
      {
        for (unsigned int degree = 3; degree > 0; --degree)
          {
            std::set<unsigned int> near = {vertex};
            for (unsigned int ring = 1; ring <= degree + 2; ++ring)
              {
                widen(near);
                if (ring < std::min(degree, 2u))
                  continue;
                std::vector<Point<3>> others;
                for (const unsigned int v : near)
                  if (v != vertex)
                    others.push_back(points[v]);
                if (height.fit(others, degree))
                  return;
              }
          }
      }

      /** Add the vertices of all faces at some. */
      void
      widen(std::set<unsigned int> &vertices) const
      {
        const std::set<unsigned int> inner = vertices;
        for (const unsigned int v : inner)
          for (const unsigned int f : faces_at.at(v))
            vertices.insert(part.faces[f].begin(), part.faces[f].end());
      }

      const SmoothPart                                 &part;
      const std::vector<Point<3>>                      &points;
      std::map<unsigned int, std::vector<unsigned int>> faces_at;
    };
  } // namespace



  bool
  SmoothSurface::Plane::contains(const Point<3> &other,
                                 const double    tolerance) const
  {
    return std::abs((other - point) * normal) <= tolerance;
  }



  SmoothSurface::SmoothSurface(const std::vector<Point<3>> &points,
                               const Faces                 &faces,
                               const std::vector<Plane>    &planes)
    : planes(planes)
  {
    for (const SmoothPart &part : smooth_parts(faces, points))
      parts.push_back({PlaceFinder<3>(part.faces, points),
                       HeightFits(part, points).heights()});
  }



  Point<3>
  SmoothSurface::place(const Point<3> &point) const
  {
    const Part           *part = nullptr;
    PlaceFinder<3>::Place in_face;
    in_face.distance = std::numeric_limits<double>::infinity();
    for (const Part &candidate : parts)
      {
        const auto place = candidate.finder.find(point);
        if (place.distance < in_face.distance)
          {
            in_face = place;
            part    = &candidate;
          }
      }
    // Normals of the planes, made orthogonal.
    std::vector<Tensor<1, 3>> stays_on;
    for (const Plane &plane : planes)
      if (plane.contains(point, 1e-9 * in_face.size))
        {
          Tensor<1, 3> normal = plane.normal;
          for (const Tensor<1, 3> &other : stays_on)
            normal -= (normal * other) * other;
          if (normal.norm() > 1e-6)
            stays_on.push_back(normal / normal.norm());
        }
    Tensor<1, 3> step;
    for (const auto &[vertex, value] : in_face.values)
      {
        const HeightFunction &height    = part->heights.at(vertex);
        Tensor<1, 3>          direction = height.plane_normal();
        for (const Tensor<1, 3> &normal : stays_on)
          direction -= (direction * normal) * normal;
        // Along a plane that is next to the surface there is no way onto it.
        if (direction.norm() < 0.5)
          direction = height.plane_normal();
        step += value * (height.moved_along(point, direction) - point);
      }
    return point + step;
  }
} // namespace StickSlip
