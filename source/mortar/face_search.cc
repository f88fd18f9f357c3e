// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/face_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    centre(const FaultSurface<dim>       &surface,
           const std::vector<Point<dim>> &positions,
           const unsigned int             face)
    {
      const auto         vertices = surface.face_vertices(positions, face);
      const unsigned int n        = surface.n_vertices_of(face);
      Tensor<1, dim>     sum;
      for (unsigned int v = 0; v < n; ++v)
        sum += vertices[v];
      return sum / n;
    }



    /** The least and the largest coordinate of all vertices along an axis. */
    template <int dim>
    std::pair<double, double>
    extent(const FaultSurface<dim>       &surface,
           const std::vector<Point<dim>> &positions,
           const unsigned int             axis)
    {
      std::pair<double, double> result = {
        std::numeric_limits<double>::max(),
        std::numeric_limits<double>::lowest()};
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        {
          const auto vertices = surface.face_vertices(positions, f);
          for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
            {
              result.first  = std::min(result.first, vertices[v][axis]);
              result.second = std::max(result.second, vertices[v][axis]);
            }
        }
      return result;
    }
  } // namespace



  template <int dim>
  FaceSearch<dim>::FaceSearch(const FaultSurface<dim>       &slave,
                              const std::vector<Point<dim>> &slave_positions,
                              const FaultSurface<dim>       &master,
                              const std::vector<Point<dim>> &master_positions)
    : slave(slave)
    , slave_positions(slave_positions)
    , master(master)
    , master_positions(master_positions)
    , are_plane(slave.is_plane() && master.is_plane())
    , common_plane(are_plane ? slave.normal : slave.normal_of(0))
    , images(find_images())
    , boxes(find_boxes())
    , tree(pack_rtree_of_indices(boxes))
  {}



  template <int dim>
  std::vector<MasterImage<dim>>
  FaceSearch<dim>::find_images() const
  {
    const Tensor<1, dim - 1> &period = slave.period;
    std::array<int, 2>        first = {}, last = {};
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (period[d] > 0)
        {
          const auto window = extent(slave, slave_positions, d);
          const auto reach  = extent(master, master_positions, d);
          first[d] = std::floor((window.first - reach.second) / period[d]);
          last[d]  = std::ceil((window.second - reach.first) / period[d]);
        }
    std::vector<MasterImage<dim>> result;
    std::array<int, 2>            wraps;
    for (wraps[0] = first[0]; wraps[0] <= last[0]; ++wraps[0])
      for (wraps[1] = first[1]; wraps[1] <= last[1]; ++wraps[1])
        for (unsigned int f = 0; f < master.faces.size(); ++f)
          {
            result.push_back({f, {}, {}});
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                result.back().wraps[d] = wraps[d];
                result.back().shift[d] = wraps[d] * period[d];
              }
          }
    return result;
  }



  template <int dim>
  std::vector<BoundingBox<dim>>
  FaceSearch<dim>::find_boxes() const
  {
    std::vector<BoundingBox<dim>> result;
    for (const MasterImage<dim> &image : images)
      result.push_back(box(master, master_positions, image.face, image.shift));
    return result;
  }



  template <int dim>
  BoundingBox<dim>
  FaceSearch<dim>::box(const FaultSurface<dim>       &surface,
                       const std::vector<Point<dim>> &positions,
                       const unsigned int             face,
                       const Tensor<1, dim>          &shift) const
  {
    const auto   vertices = surface.face_vertices(positions, face);
    const double margin   = are_plane ? 0. : surface.face_size(face);
    Point<dim>   lower, upper;
    for (unsigned int v = 0; v < surface.n_vertices_of(face); ++v)
      {
        Point<dim> x = vertices[v] + shift;
        if (are_plane)
          {
            const Point<dim - 1> in_plane = common_plane.coordinates(x);
            for (unsigned int d = 0; d < dim - 1; ++d)
              x[d] = in_plane[d];
            x[dim - 1] = 0.;
          }
        for (unsigned int d = 0; d < dim; ++d)
          {
            lower[d] = v == 0 ? x[d] : std::min(lower[d], x[d]);
            upper[d] = v == 0 ? x[d] : std::max(upper[d], x[d]);
          }
      }
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] -= margin;
        upper[d] += margin;
      }
    return BoundingBox<dim>(std::make_pair(lower, upper));
  }



  template <int dim>
  boost::container::small_vector<MasterImage<dim>, 8>
  FaceSearch<dim>::opposite_to(const unsigned int slave_face) const
  {
    boost::container::small_vector<std::size_t, 16> candidates;
    tree.query(boost::geometry::index::intersects(
                 box(slave, slave_positions, slave_face, {})),
               std::back_inserter(candidates));
    std::sort(candidates.begin(), candidates.end());
    boost::container::small_vector<MasterImage<dim>, 8> result;
    for (const std::size_t i : candidates)
      if (is_opposite(slave_face, images[i]))
        result.push_back(images[i]);
    return result;
  }



  template <int dim>
  bool
  FaceSearch<dim>::is_opposite(const unsigned int      slave_face,
                               const MasterImage<dim> &image) const
  {
    const Tensor<1, dim> &normal = slave.normal_of(slave_face);
    if (normal * master.normal_of(image.face) > -facing_cosine)
      return false;
    if (are_plane)
      return true;
    const Tensor<1, dim> distance =
      centre(master, master_positions, image.face) + image.shift -
      centre(slave, slave_positions, slave_face);
    return std::abs(distance * normal) <=
           slave.face_size(slave_face) + master.face_size(image.face);
  }



  template class FaceSearch<2>;
  template class FaceSearch<3>;
} // namespace StickSlip
