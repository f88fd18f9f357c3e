// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/mortar/face_overlap.h>
#include <stickslip/mortar/face_shape.h>
#include <stickslip/mortar/polygon_clipping.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    double
    cell_measure(const std::array<Point<1>, 2> &v)
    {
      return v[1][0] - v[0][0];
    }



    double
    cell_measure(const std::array<Point<2>, 3> &v)
    {
      return signed_area({v[0], v[1], v[2]});
    }



    /** A face on a line, with its ends in increasing order. */
    struct Interval
    {
      double       lower;
      double       upper;
      unsigned int face;
    };



    std::vector<Interval>
    sorted_intervals(const FaultSurface<2>       &surface,
                     const std::vector<Point<1>> &positions)
    {
      std::vector<Interval> intervals;
      intervals.reserve(surface.faces.size());
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        {
          const FaceShape<2> shape(positions, surface.faces[f]);
          const auto         ends =
            std::minmax(shape.vertices()[0][0], shape.vertices()[1][0]);
          intervals.push_back({ends.first, ends.second, f});
        }
      std::sort(intervals.begin(),
                intervals.end(),
                [](const Interval &a, const Interval &b) {
                  return a.lower < b.lower;
                });

      for (unsigned int i = 1; i < intervals.size(); ++i)
        AssertThrow(intervals[i].lower >=
                      intervals[i - 1].upper -
                        1e-10 * (intervals[i].upper - intervals[i].lower),
                    ExcMessage(
                      "Two faces on the same side of a fault overlap. The "
                      "deformation next to the fault is too large for the "
                      "mesh."));
      return intervals;
    }



    void
    append_overlap(const FaultSurface<2>       &slave,
                   const std::vector<Point<1>> &slave_positions,
                   const FaultSurface<2>       &master,
                   const std::vector<Point<1>> &master_positions,
                   std::vector<OverlapCell<2>> &cells)
    {
      const std::vector<Interval> slaves =
        sorted_intervals(slave, slave_positions);
      const std::vector<Interval> masters =
        sorted_intervals(master, master_positions);

      auto s = slaves.begin();
      auto m = masters.begin();
      while (s != slaves.end() && m != masters.end())
        {
          const double lower = std::max(s->lower, m->lower);
          const double upper = std::min(s->upper, m->upper);
          const double smaller =
            std::min(s->upper - s->lower, m->upper - m->lower);
          if (upper - lower > overlap_tolerance * smaller)
            cells.push_back(
              {s->face, m->face, {{Point<1>(lower), Point<1>(upper)}}});

          if (s->upper <= m->upper)
            ++s;
          else
            ++m;
        }
    }



    BoundingBox<2>
    bounding_box(const FaceShape<3> &shape)
    {
      return BoundingBox<2>(std::vector<Point<2>>(shape.vertices().begin(),
                                                  shape.vertices().end()));
    }



    /** The outline of a face, counter-clockwise. */
    Polygon
    outline(const FaceShape<3> &shape)
    {
      Polygon polygon;
      for (const unsigned int i : {0, 1, 3, 2})
        polygon.push_back(shape.vertices()[i]);
      if (signed_area(polygon) < 0.)
        std::reverse(polygon.begin(), polygon.end());
      return polygon;
    }



    void
    append_overlap(const FaultSurface<3>       &slave,
                   const std::vector<Point<2>> &slave_positions,
                   const FaultSurface<3>       &master,
                   const std::vector<Point<2>> &master_positions,
                   std::vector<OverlapCell<3>> &cells)
    {
      std::vector<FaceShape<3>>   master_shapes;
      std::vector<BoundingBox<2>> master_boxes;
      for (const auto &face : master.faces)
        {
          master_shapes.emplace_back(master_positions, face);
          master_boxes.push_back(bounding_box(master_shapes.back()));
        }
      const auto tree = pack_rtree_of_indices(master_boxes);

      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        {
          const FaceShape<3> slave_shape(slave_positions, slave.faces[f]);

          std::vector<std::size_t> candidates;
          tree.query(boost::geometry::index::intersects(
                       bounding_box(slave_shape)),
                     std::back_inserter(candidates));
          std::sort(candidates.begin(), candidates.end());

          const Polygon slave_outline = outline(slave_shape);
          for (const std::size_t m : candidates)
            {
              const Polygon common =
                clip_convex_polygon(slave_outline, outline(master_shapes[m]));
              if (signed_area(common) <=
                  overlap_tolerance *
                    std::min(slave_shape.measure(), master_shapes[m].measure()))
                continue;
              for (unsigned int i = 2; i < common.size(); ++i)
                {
                  const OverlapCell<3> cell = {
                    f,
                    static_cast<unsigned int>(m),
                    {{common[0], common[i - 1], common[i]}}};
                  // Vertices that coincide leave triangles without area.
                  if (cell.measure() > 0.)
                    cells.push_back(cell);
                }
            }
        }
    }
  } // namespace



  template <int dim>
  double
  OverlapCell<dim>::measure() const
  {
    return cell_measure(vertices);
  }



  template <int dim>
  std::vector<OverlapCell<dim>>
  compute_face_overlap(const FaultSurface<dim>           &slave,
                       const std::vector<Point<dim - 1>> &slave_positions,
                       const FaultSurface<dim>           &master,
                       const std::vector<Point<dim - 1>> &master_positions)
  {
    AssertDimension(slave.points.size(), slave_positions.size());
    AssertDimension(master.points.size(), master_positions.size());

    std::vector<OverlapCell<dim>> cells;
    append_overlap(slave, slave_positions, master, master_positions, cells);
    return cells;
  }



  template struct OverlapCell<2>;
  template struct OverlapCell<3>;

  template std::vector<OverlapCell<2>>
  compute_face_overlap(const FaultSurface<2> &,
                       const std::vector<Point<1>> &,
                       const FaultSurface<2> &,
                       const std::vector<Point<1>> &);
  template std::vector<OverlapCell<3>>
  compute_face_overlap(const FaultSurface<3> &,
                       const std::vector<Point<2>> &,
                       const FaultSurface<3> &,
                       const std::vector<Point<2>> &);
} // namespace StickSlip
