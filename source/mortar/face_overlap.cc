// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mortar/face_overlap.h>
#include <stickslip/mortar/face_search.h>
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



    /** A positive or negative number for the two senses in which the vertices
     * of a face run in its plane. */
    double
    sense(const FacePlane<2> &plane, const std::array<Point<2>, 2> &v)
    {
      return plane.components(v[1] - v[0])[0];
    }



    double
    sense(const FacePlane<3> &plane, const std::array<Point<3>, 4> &v)
    {
      return cross_product_3d(v[1] - v[0], v[2] - v[0]) * plane.normal();
    }



    /** Throw if the displacement of the nodes has turned a face around. */
    template <int dim>
    void
    check_senses(const FaultSurface<dim>       &surface,
                 const std::vector<Point<dim>> &positions)
    {
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        {
          const FacePlane<dim> plane(surface.normal_of(f));
          AssertThrow(
            sense(plane, surface.face_vertices(positions, f)) *
                sense(plane, surface.face_vertices(surface.points, f)) >
              0.,
            ExcMessage("A face on a side of a fault has no area or is turned "
                       "inside out. The deformation next to the fault is too "
                       "large for the mesh."));
        }
    }



    /** A master face projected onto the plane of a slave face. */
    template <int dim>
    struct Projected
    {
      FaceShape<dim>          shape;
      const MasterImage<dim> &image;
    };

    template <int dim>
    using Masters = boost::container::small_vector<Projected<dim>, 8>;



    template <int dim>
    FaceShape<dim>
    moved(const FaceShape<dim> &shape, const Tensor<1, dim - 1> &by)
    {
      auto vertices = shape.vertices();
      for (Point<dim - 1> &vertex : vertices)
        vertex += by;
      return FaceShape<dim>(vertices, shape.n_vertices());
    }



    /** The ends of a face on a line, the lower one first. */
    std::pair<double, double>
    ends(const FaceShape<2> &shape)
    {
      return std::minmax({shape.vertices()[0][0], shape.vertices()[1][0]});
    }



    void
    append_overlap(const unsigned int           slave_face,
                   const FaceShape<2>          &slave,
                   const Masters<2>            &masters,
                   std::vector<OverlapCell<2>> &cells)
    {
      boost::container::
        small_vector<std::pair<std::pair<double, double>, unsigned int>, 8>
          sorted;
      for (unsigned int i = 0; i < masters.size(); ++i)
        sorted.emplace_back(ends(masters[i].shape), i);
      std::sort(sorted.begin(), sorted.end());

      const auto [slave_lower, slave_upper] = ends(slave);
      for (const auto &[interval, i] : sorted)
        {
          const double lower   = std::max(slave_lower, interval.first);
          const double upper   = std::min(slave_upper, interval.second);
          const double smaller = std::min(slave_upper - slave_lower,
                                          interval.second - interval.first);
          if (upper - lower > overlap_tolerance * smaller)
            cells.push_back({slave_face,
                             masters[i].image.face,
                             masters[i].image.wraps,
                             {{Point<1>(lower), Point<1>(upper)}}});
        }
    }



    /** The outline of a face, counter-clockwise. */
    Polygon
    outline(const FaceShape<3> &shape)
    {
      Polygon polygon;
      for (const unsigned int i : {0, 1, 3, 2})
        if (i < shape.n_vertices())
          polygon.push_back(shape.vertices()[i]);
      if (signed_area(polygon) < 0.)
        std::reverse(polygon.begin(), polygon.end());
      return polygon;
    }



    void
    append_overlap(const unsigned int           slave_face,
                   const FaceShape<3>          &slave,
                   const Masters<3>            &masters,
                   std::vector<OverlapCell<3>> &cells)
    {
      const Polygon slave_outline = outline(slave);
      for (const Projected<3> &master : masters)
        {
          const Polygon common =
            clip_convex_polygon(slave_outline, outline(master.shape));
          if (signed_area(common) <=
              overlap_tolerance *
                std::min(slave.measure(), master.shape.measure()))
            continue;
          for (unsigned int v = 2; v < common.size(); ++v)
            {
              const OverlapCell<3> cell = {
                slave_face,
                master.image.face,
                master.image.wraps,
                {{common[0], common[v - 1], common[v]}}};
              // Vertices that coincide leave triangles without area.
              if (cell.measure() > 0.)
                cells.push_back(cell);
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
  FaceShape<dim>
  project_face(const FacePlane<dim>          &plane,
               const FaultSurface<dim>       &surface,
               const std::vector<Point<dim>> &positions,
               const unsigned int             face)
  {
    const auto         in_space = surface.face_vertices(positions, face);
    const unsigned int n        = surface.n_vertices_of(face);
    std::array<Point<dim - 1>, FaceShape<dim>::max_vertices> vertices;
    for (unsigned int v = 0; v < n; ++v)
      vertices[v] = plane.coordinates(in_space[v]);
    return FaceShape<dim>(vertices, n);
  }



  template <int dim>
  std::vector<OverlapCell<dim>>
  compute_face_overlap(const FaultSurface<dim>       &slave,
                       const std::vector<Point<dim>> &slave_positions,
                       const FaultSurface<dim>       &master,
                       const std::vector<Point<dim>> &master_positions)
  {
    AssertDimension(slave.points.size(), slave_positions.size());
    AssertDimension(master.points.size(), master_positions.size());
    check_senses(slave, slave_positions);
    check_senses(master, master_positions);

    const FaceSearch<dim>         search(slave,
                                 slave_positions,
                                 master,
                                 master_positions);
    std::vector<OverlapCell<dim>> cells;
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      {
        const FacePlane<dim> plane(slave.normal_of(f));
        const auto           images = search.opposite_to(f);
        Masters<dim>         masters;
        for (const MasterImage<dim> &image : images)
          masters.push_back(
            {moved(project_face(plane, master, master_positions, image.face),
                   plane.components(image.shift)),
             image});
        append_overlap(f,
                       project_face(plane, slave, slave_positions, f),
                       masters,
                       cells);
      }
    return cells;
  }



#define STICKSLIP_INSTANTIATE(dim)                                           \
  template struct OverlapCell<dim>;                                          \
  template std::vector<OverlapCell<dim>> compute_face_overlap<dim>(          \
    const FaultSurface<dim> &,                                               \
    const std::vector<Point<dim>> &,                                         \
    const FaultSurface<dim> &,                                               \
    const std::vector<Point<dim>> &);                                        \
  template FaceShape<dim> project_face<dim>(const FacePlane<dim> &,          \
                                            const FaultSurface<dim> &,       \
                                            const std::vector<Point<dim>> &, \
                                            const unsigned int);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
