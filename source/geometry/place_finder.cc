// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/geometry/place_finder.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** Values of the basis functions of a patch at unit coordinates. */
    std::vector<double>
    basis(const std::vector<double> &at, const bool is_simplex)
    {
      const unsigned int d = at.size();
      if (is_simplex)
        {
          std::vector<double> values = {1.};
          for (const double x : at)
            {
              values[0] -= x;
              values.push_back(x);
            }
          return values;
        }
      std::vector<double> values(std::size_t(1) << d, 1.);
      for (unsigned int v = 0; v < values.size(); ++v)
        for (unsigned int i = 0; i < d; ++i)
          values[v] *= ((v >> i) & 1u) ? at[i] : 1. - at[i];
      return values;
    }



    /** Derivatives of the basis functions along a unit axis. */
    std::vector<double>
    derivatives(const std::vector<double> &at,
                const bool                 is_simplex,
                const unsigned int         axis)
    {
      const unsigned int d = at.size();
      if (is_simplex)
        {
          std::vector<double> values(d + 1, 0.);
          values[0]        = -1.;
          values[axis + 1] = 1.;
          return values;
        }
      std::vector<double> values(std::size_t(1) << d, 1.);
      for (unsigned int v = 0; v < values.size(); ++v)
        for (unsigned int i = 0; i < d; ++i)
          {
            const bool upper = (v >> i) & 1u;
            values[v] *= i == axis ? (upper ? 1. : -1.) :
                         upper     ? at[i] :
                                     1. - at[i];
          }
      return values;
    }



    template <int dim>
    Point<dim>
    combine(const std::vector<double>     &values,
            const std::vector<Point<dim>> &points)
    {
      Point<dim> result;
      for (unsigned int v = 0; v < points.size(); ++v)
        result += values[v] * points[v];
      return result;
    }



    /** Unit coordinates moved into the unit cell. */
    void
    clamp(std::vector<double> &at, const bool is_simplex)
    {
      if (!is_simplex)
        {
          for (double &x : at)
            x = std::min(std::max(x, 0.), 1.);
          return;
        }
      double first = 1., sum = 0.;
      for (const double x : at)
        first -= x;
      sum = std::max(first, 0.);
      for (double &x : at)
        sum += x = std::max(x, 0.);
      for (double &x : at)
        x /= sum;
    }



    template <int dim>
    double
    diameter(const std::vector<Point<dim>> &points)
    {
      double result = 0.;
      for (const auto &a : points)
        for (const auto &b : points)
          result = std::max(result, a.distance(b));
      return result;
    }
  } // namespace



  template <int dim>
  struct PlaceFinder<dim>::Tree
  {
    using Box = std::pair<BoundingBox<dim>, unsigned int>;
    decltype(pack_rtree(std::vector<Box>())) boxes;
  };



  template <int dim>
  PlaceFinder<dim>::PlaceFinder(const Triangulation<dim> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      {
        patches.push_back({{}, {}, dim, cell->n_vertices() == dim + 1});
        for (const auto v : cell->vertex_indices())
          {
            patches.back().vertices.push_back(cell->vertex_index(v));
            patches.back().points.push_back(cell->vertex(v));
          }
      }
    make_tree();
  }



  template <int dim>
  PlaceFinder<dim>::PlaceFinder(const Triangulation<dim> &mesh,
                                const types::boundary_id  side)
  {
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == side)
        {
          patches.push_back({{}, {}, dim - 1, face->n_vertices() == dim});
          for (unsigned int v = 0; v < face->n_vertices(); ++v)
            {
              patches.back().vertices.push_back(face->vertex_index(v));
              patches.back().points.push_back(face->vertex(v));
            }
        }
    make_tree();
  }



  template <int dim>
  PlaceFinder<dim>::PlaceFinder(
    const std::vector<std::vector<unsigned int>> &faces,
    const std::vector<Point<dim>>                &points)
  {
    for (const std::vector<unsigned int> &face : faces)
      {
        patches.push_back({face, {}, dim - 1, face.size() == dim});
        for (const unsigned int v : face)
          patches.back().points.push_back(points[v]);
      }
    make_tree();
  }



  template <int dim>
  void
  PlaceFinder<dim>::make_tree()
  {
    std::vector<typename Tree::Box> boxes;
    for (unsigned int i = 0; i < patches.size(); ++i)
      {
        boxes.emplace_back(BoundingBox<dim>(patches[i].points), i);
        boxes.back().first.extend(1e-8 * diameter(patches[i].points));
      }
    const auto result = std::make_shared<Tree>();
    result->boxes     = pack_rtree(boxes);
    tree              = result;
  }



  template <int dim>
  typename PlaceFinder<dim>::Place
  PlaceFinder<dim>::place_in(const Patch &patch, const Point<dim> &point)
  {
    const unsigned int  d = patch.structdim;
    std::vector<double> at(d, patch.is_simplex ? 1. / (d + 1) : 0.5);
    // Gauss-Newton's method; one step is enough for a simplex.
    for (unsigned int step = 0; step < (patch.is_simplex ? 1 : 20); ++step)
      {
        const Tensor<1, dim> defect =
          point - combine(basis(at, patch.is_simplex), patch.points);
        std::vector<Tensor<1, dim>> tangents;
        for (unsigned int i = 0; i < d; ++i)
          tangents.emplace_back(
            combine(derivatives(at, patch.is_simplex, i), patch.points));
        FullMatrix<double> matrix(d, d);
        Vector<double>     right(d), change(d);
        for (unsigned int i = 0; i < d; ++i)
          {
            right[i] = tangents[i] * defect;
            for (unsigned int j = 0; j < d; ++j)
              matrix(i, j) = tangents[i] * tangents[j];
          }
        matrix.gauss_jordan();
        matrix.vmult(change, right);
        for (unsigned int i = 0; i < d; ++i)
          // Far outside the map of a quadrilateral may fold over.
          at[i] = patch.is_simplex ?
                    at[i] + change[i] :
                    std::min(std::max(at[i] + change[i], -0.5), 1.5);
        if (change.linfty_norm() < 1e-13)
          break;
      }
    clamp(at, patch.is_simplex);
    const std::vector<double> values = basis(at, patch.is_simplex);

    Place place;
    place.distance = combine(values, patch.points).distance(point);
    place.size     = diameter(patch.points);
    for (unsigned int v = 0; v < values.size(); ++v)
      if (values[v] > 1e-10)
        place.values.emplace_back(patch.vertices[v], values[v]);
    return place;
  }



  template <int dim>
  typename PlaceFinder<dim>::Place
  PlaceFinder<dim>::find(const Point<dim> &point) const
  {
    Place best;
    best.distance      = std::numeric_limits<double>::infinity();
    const auto try_all = [&](const std::vector<typename Tree::Box> &boxes) {
      for (const auto &box : boxes)
        {
          const Patch &patch = patches[box.second];
          const Place  place = place_in(patch, point);
          if (place.distance < best.distance)
            best = place;
        }
    };
    std::vector<typename Tree::Box> found;
    tree->boxes.query(boost::geometry::index::intersects(point),
                      std::back_inserter(found));
    try_all(found);
    if (best.distance < 1e-9 * best.size)
      return best;
    // Outside: boxes by rising distance, as long as they may hold what is
    // nearer.
    for (auto box = tree->boxes.qbegin(
           boost::geometry::index::nearest(point, patches.size()));
         box != tree->boxes.qend() &&
         boost::geometry::distance(point, box->first) <= best.distance;
         ++box)
      try_all({*box});
    return best;
  }



  template class PlaceFinder<2>;
  template class PlaceFinder<3>;
} // namespace StickSlip
