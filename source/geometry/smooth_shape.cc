// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/face_area.h>
#include <stickslip/geometry/smooth_outline.h>
#include <stickslip/geometry/smooth_shape.h>
#include <stickslip/geometry/smooth_surface.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace StickSlip
{
  namespace
  {
    /** The curve in planes normal to the y axis, the same in all of them. */
    class ExtrudedShape : public FaultShape<3>
    {
    public:
      explicit ExtrudedShape(std::shared_ptr<const FaultShape<2>> curve)
        : curve(std::move(curve))
      {}

      virtual Point<3>
      place(const Point<3> &point) const override
      {
        const Point<2> place = curve->place(Point<2>(point[0], point[2]));
        return Point<3>(place[0], point[1], place[1]);
      }

    private:
      std::shared_ptr<const FaultShape<2>> curve;
    };



    /** The lines by which the parts of a side are given; empty if one of them
     * is not part of a block. */
    template <int dim>
    std::vector<std::vector<Point<2>>>
    outlines(const std::vector<BodyCells<dim>> &bodies,
             const std::vector<BodySide>       &side)
    {
      std::vector<std::vector<Point<2>>> result;
      for (const BodySide &part : side)
        {
          const auto &of_body = bodies[part.body].outlines;
          const auto  outline = of_body.find(part.side);
          if (outline == of_body.end())
            return {};
          result.push_back(outline->second);
        }
      return result;
    }



    /** The curve through the points of the side of blocks that is given by
     * fewer lines, or else by more points; null for other bodies. */
    template <int dim>
    std::shared_ptr<const SmoothOutline>
    smooth_outline(const std::vector<BodyCells<dim>> &bodies,
                   const Fault                       &fault)
    {
      const auto first  = outlines(bodies, fault.sides[0]),
                 second = outlines(bodies, fault.sides[1]);
      if (first.empty() || second.empty())
        return nullptr;
      auto curve = std::make_shared<const SmoothOutline>(first),
           other = std::make_shared<const SmoothOutline>(second);
      const bool other_is_better = first.size() == second.size() ?
                                     other->n_points() > curve->n_points() :
                                     second.size() < first.size();
      return other_is_better ? other : curve;
    }



    /** The faces on one side as lines. */
    std::vector<std::vector<Point<2>>>
    face_lines(const std::vector<BodyCells<2>> &bodies,
               const std::vector<BodySide>     &side)
    {
      std::vector<std::vector<Point<2>>> result;
      for (const BodySide &part : side)
        for (const auto &face : bodies[part.body].boundary.boundary_lines)
          if (face.boundary_id == part.side)
            result.push_back({bodies[part.body].vertices[face.vertices[0]],
                              bodies[part.body].vertices[face.vertices[1]]});
      return result;
    }



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
    if (const auto outline = smooth_outline(bodies, fault))
      return outline;
    const SmoothOutline first(face_lines(bodies, fault.sides[0])),
      second(face_lines(bodies, fault.sides[1]));
    return std::make_shared<SmoothOutline>(
      second.n_points() > first.n_points() ? second : first);
  }



  template <>
  std::shared_ptr<const FaultShape<3>>
  smooth_shape<3>(const std::vector<BodyCells<3>> &bodies, const Fault &fault)
  {
    if (const auto outline = smooth_outline(bodies, fault))
      return std::make_shared<ExtrudedShape>(outline);
    const JoinedFaces first(bodies, fault.sides[0]),
      second(bodies, fault.sides[1]);
    const JoinedFaces &side =
      second.points.size() > first.points.size() ? second : first;
    return std::make_shared<SmoothSurface>(side.points,
                                           side.faces,
                                           planes_at(bodies, fault));
  }
} // namespace StickSlip
