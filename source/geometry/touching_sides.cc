// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/grouped_cells.h>
#include <stickslip/geometry/touching_sides.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** A line, or a triangle as which or as half of which a face counts. */
    template <int dim>
    struct Facet
    {
      std::array<Point<dim>, dim> corners;

      /** Normal of unit length. */
      Tensor<1, dim> normal;

      /** Diameter, m. */
      double size = 0.;

      explicit Facet(const std::array<Point<dim>, dim> &corners)
        : corners(corners)
      {
        if constexpr (dim == 2)
          normal = cross_product_2d(corners[1] - corners[0]);
        else
          normal =
            cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
        normal /= normal.norm();
        for (const auto &a : corners)
          for (const auto &b : corners)
            size = std::max(size, a.distance(b));
      }

      /** A point inside, by shares of the corners but the first. */
      Point<dim>
      point(const std::array<double, dim - 1> &shares) const
      {
        Point<dim> result = corners[0];
        for (unsigned int d = 0; d + 1 < dim; ++d)
          result += shares[d] * (corners[d + 1] - corners[0]);
        return result;
      }

      /** True if a point is above or below the facet. */
      bool
      is_opposite(const Point<dim> &place) const
      {
        if constexpr (dim == 2)
          {
            const double share =
              (place - corners[0]) * (corners[1] - corners[0]) / (size * size);
            return share >= -1e-10 && share <= 1. + 1e-10;
          }
        else
          {
            for (unsigned int v = 0; v < 3; ++v)
              if (cross_product_3d(corners[(v + 1) % 3] - corners[v],
                                   place - corners[v]) *
                    normal <
                  -1e-10 * size * size)
                return false;
            return true;
          }
      }
    };



    template <int dim>
    std::vector<Facet<dim>>
    facets_of(const BodyCells<dim> &body, const types::boundary_id side)
    {
      std::vector<Facet<dim>> facets;
      const auto              at = [&body](const unsigned int vertex) {
        return body.vertices[vertex];
      };
      if constexpr (dim == 2)
        for (const auto &line : body.boundary.boundary_lines)
          {
            if (line.boundary_id == side)
              facets.emplace_back(std::array<Point<2>, 2>{
                {at(line.vertices[0]), at(line.vertices[1])}});
          }
      else
        for (const auto &face : body.boundary.boundary_quads)
          if (face.boundary_id == side)
            {
              const auto &v = face.vertices;
              facets.emplace_back(
                std::array<Point<3>, 3>{{at(v[0]), at(v[1]), at(v[2])}});
              if (v.size() == 4)
                facets.emplace_back(
                  std::array<Point<3>, 3>{{at(v[3]), at(v[2]), at(v[1])}});
            }
      return facets;
    }



    /** Facets, and where they are. */
    template <int dim>
    class FacetTree
    {
    public:
      explicit FacetTree(const std::vector<Facet<dim>> &facets)
        : facets(facets)
      {
        std::vector<Box> boxes;
        for (unsigned int i = 0; i < facets.size(); ++i)
          boxes.emplace_back(box(facets[i], 0.), i);
        tree = pack_rtree(boxes);
      }

      /** The distance of a point from the facet opposite to it that is
       * nearest, in multiples of the larger of both facets and in m; infinite
       * if there is none within the size of either. */
      std::pair<double, double>
      distance(const Point<dim> &point, const Facet<dim> &its_facet) const
      {
        std::pair<double, double> least = {
          std::numeric_limits<double>::infinity(), 0.};
        std::vector<Box> found;
        tree.query(boost::geometry::index::intersects(box(its_facet, 1.)),
                   std::back_inserter(found));
        for (const Box &other : found)
          {
            const Facet<dim> &facet = facets[other.second];
            const double      offset =
              std::abs((point - facet.corners[0]) * facet.normal);
            if (std::abs(facet.normal * its_facet.normal) < 0.5 ||
                !facet.is_opposite(point))
              continue;
            least = std::min(least,
                             std::make_pair(offset / std::max(facet.size,
                                                              its_facet.size),
                                            offset));
          }
        return least;
      }

    private:
      using Box = std::pair<BoundingBox<dim>, unsigned int>;

      /** The box around a facet, larger on all sides by a multiple of its
       * size. */
      static BoundingBox<dim>
      box(const Facet<dim> &facet, const double more)
      {
        BoundingBox<dim> result(
          std::vector<Point<dim>>(facet.corners.begin(), facet.corners.end()));
        result.extend((more + 0.1) * facet.size);
        return result;
      }

      const std::vector<Facet<dim>>           &facets;
      decltype(pack_rtree(std::vector<Box>())) tree;
    };



    /** Points inside a facet, by shares. */
    template <int dim>
    std::vector<std::array<double, dim - 1>>
    samples()
    {
      if constexpr (dim == 2)
        return {{{0.1}}, {{0.3}}, {{0.5}}, {{0.7}}, {{0.9}}};
      else
        return {{{1. / 3., 1. / 3.}}, {{0.1, 0.1}}, {{0.8, 0.1}}, {{0.1, 0.8}}};
    }
  } // namespace



  template <int dim>
  void
  check_sides_touch(const std::vector<BodyCells<dim>> &bodies,
                    const std::vector<std::string>    &body_names,
                    const Fault                       &fault)
  {
    const double allowed = fault.may_be_apart ? 1. : 0.1;
    std::array<std::vector<Facet<dim>>, 2> facets;
    for (const unsigned int side : {0, 1})
      for (const BodySide &part : fault.sides[side])
        for (const Facet<dim> &facet : facets_of(bodies[part.body], part.side))
          facets[side].push_back(facet);

    for (const unsigned int side : {0, 1})
      {
        const FacetTree<dim> others(facets[1 - side]);
        for (const BodySide &part : fault.sides[side])
          {
            bool touches = false;
            for (const Facet<dim> &facet :
                 facets_of(bodies[part.body], part.side))
              for (const auto &shares : samples<dim>())
                {
                  const Point<dim> point    = facet.point(shares);
                  const auto       distance = others.distance(point, facet);
                  if (std::isinf(distance.first))
                    continue;
                  if (distance.first > allowed)
                    {
                      std::ostringstream metres;
                      metres << distance.second;
                      throw InputError(
                        "The two sides of the fault '" + fault.name + "' are " +
                        metres.str() + " m apart at " + position_text(point) +
                        (fault.may_be_apart ? ", more than a face is large." :
                                              "; they must touch."));
                    }
                  touches = true;
                }
            if (!touches)
              throw InputError("The side '" + body_names[part.body] + " " +
                               bodies[part.body].side_names.at(part.side) +
                               "' of the fault '" + fault.name +
                               "' does not touch the other side.");
          }
      }
  }



  template void
  check_sides_touch(const std::vector<BodyCells<2>> &,
                    const std::vector<std::string> &,
                    const Fault &);
  template void
  check_sides_touch(const std::vector<BodyCells<3>> &,
                    const std::vector<std::string> &,
                    const Fault &);
} // namespace StickSlip
