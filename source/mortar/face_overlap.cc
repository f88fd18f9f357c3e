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
      int          wraps;
    };



    std::vector<Interval>
    sorted_intervals(const FaultSurface<2>       &surface,
                     const std::vector<Point<1>> &positions)
    {
      std::vector<Interval> intervals;
      intervals.reserve(surface.faces.size());
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        {
          const FaceShape<2> shape(surface.face_vertices(positions, f));
          const auto         ends =
            std::minmax(shape.vertices()[0][0], shape.vertices()[1][0]);
          intervals.push_back({ends.first, ends.second, f, 0});
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



    /** All images, moved by multiples of @p period, that reach into the
     * window, which is not empty; sorted like the @p intervals. */
    std::vector<Interval>
    images_in(const Interval              &window,
              const double                 period,
              const std::vector<Interval> &intervals)
    {
      const int first =
        std::floor((window.lower - intervals.back().upper) / period);
      const int last =
        std::ceil((window.upper - intervals.front().lower) / period);
      std::vector<Interval> images;
      for (int wraps = first; wraps <= last; ++wraps)
        for (const Interval &interval : intervals)
          images.push_back({interval.lower + wraps * period,
                            interval.upper + wraps * period,
                            interval.face,
                            wraps});
      return images;
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
      std::vector<Interval> masters =
        sorted_intervals(master, master_positions);
      if (slave.period[0] > 0)
        masters = images_in({slaves.front().lower, slaves.back().upper, 0, 0},
                            slave.period[0],
                            masters);

      auto s = slaves.begin();
      auto m = masters.begin();
      while (s != slaves.end() && m != masters.end())
        {
          const double lower = std::max(s->lower, m->lower);
          const double upper = std::min(s->upper, m->upper);
          const double smaller =
            std::min(s->upper - s->lower, m->upper - m->lower);
          if (upper - lower > overlap_tolerance * smaller)
            cells.push_back({s->face,
                             m->face,
                             {{m->wraps}},
                             {{Point<1>(lower), Point<1>(upper)}}});

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



    std::vector<FaceShape<3>>
    face_shapes(const FaultSurface<3>       &surface,
                const std::vector<Point<2>> &positions)
    {
      std::vector<FaceShape<3>> shapes;
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        shapes.emplace_back(surface.face_vertices(positions, f));
      return shapes;
    }



    BoundingBox<2>
    bounding_box(const std::vector<FaceShape<3>> &shapes)
    {
      BoundingBox<2> box = bounding_box(shapes.front());
      for (const FaceShape<3> &shape : shapes)
        box.merge_with(bounding_box(shape));
      return box;
    }



    FaceShape<3>
    moved(const FaceShape<3> &shape, const Tensor<1, 2> &by)
    {
      auto vertices = shape.vertices();
      for (Point<2> &vertex : vertices)
        vertex += by;
      return FaceShape<3>(vertices);
    }



    /** A master face, moved by whole periods. */
    struct MasterImage
    {
      FaceShape<3>       shape;
      unsigned int       face;
      std::array<int, 2> wraps;
    };



    /** The images of master faces, moved by multiples of @p period, next to the
     * slave faces in @p window; and their bounding boxes. */
    void
    append_images(const Tensor<1, 2>              &period,
                  const BoundingBox<2>            &window,
                  const std::vector<FaceShape<3>> &masters,
                  std::vector<MasterImage>        &images,
                  std::vector<BoundingBox<2>>     &boxes)
    {
      const BoundingBox<2> extent = bounding_box(masters);
      std::array<int, 2>   first = {}, last = {};
      for (unsigned int d = 0; d < 2; ++d)
        if (period[d] > 0)
          {
            first[d] = std::floor(
              (window.lower_bound(d) - extent.upper_bound(d)) / period[d]);
            last[d] = std::ceil(
              (window.upper_bound(d) - extent.lower_bound(d)) / period[d]);
          }
      std::array<int, 2> wraps;
      for (wraps[0] = first[0]; wraps[0] <= last[0]; ++wraps[0])
        for (wraps[1] = first[1]; wraps[1] <= last[1]; ++wraps[1])
          for (unsigned int f = 0; f < masters.size(); ++f)
            {
              const FaceShape<3> image =
                moved(masters[f],
                      Tensor<1, 2>(
                        {wraps[0] * period[0], wraps[1] * period[1]}));
              boxes.push_back(bounding_box(image));
              images.push_back({image, f, wraps});
            }
    }



    void
    append_overlap(const FaultSurface<3>       &slave,
                   const std::vector<Point<2>> &slave_positions,
                   const FaultSurface<3>       &master,
                   const std::vector<Point<2>> &master_positions,
                   std::vector<OverlapCell<3>> &cells)
    {
      const std::vector<FaceShape<3>> slave_shapes =
        face_shapes(slave, slave_positions);
      std::vector<MasterImage>    images;
      std::vector<BoundingBox<2>> boxes;
      append_images(slave.period,
                    bounding_box(slave_shapes),
                    face_shapes(master, master_positions),
                    images,
                    boxes);
      const auto tree = pack_rtree_of_indices(boxes);

      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        {
          std::vector<std::size_t> candidates;
          tree.query(boost::geometry::index::intersects(
                       bounding_box(slave_shapes[f])),
                     std::back_inserter(candidates));
          std::sort(candidates.begin(), candidates.end());

          const Polygon slave_outline = outline(slave_shapes[f]);
          for (const std::size_t i : candidates)
            {
              const MasterImage &master_image = images[i];
              const Polygon      common =
                clip_convex_polygon(slave_outline, outline(master_image.shape));
              if (signed_area(common) <=
                  overlap_tolerance * std::min(slave_shapes[f].measure(),
                                               master_image.shape.measure()))
                continue;
              for (unsigned int v = 2; v < common.size(); ++v)
                {
                  const OverlapCell<3> cell = {
                    f,
                    master_image.face,
                    master_image.wraps,
                    {{common[0], common[v - 1], common[v]}}};
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
