// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/manifold.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/fault_shape.h>
#include <stickslip/geometry/grouped_cells.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** The mean of points on a shape, moved onto it. */
    template <int dim>
    class ShapeManifold : public Manifold<dim>
    {
    public:
      explicit ShapeManifold(std::shared_ptr<const FaultShape<dim>> shape)
        : shape(std::move(shape))
      {}

      virtual std::unique_ptr<Manifold<dim>>
      clone() const override
      {
        return std::make_unique<ShapeManifold<dim>>(shape);
      }

      virtual Point<dim>
      get_new_point(const ArrayView<const Point<dim>> &points,
                    const ArrayView<const double>     &weights) const override
      {
        // Both sides of a fault count the vertices of a face in orders of
        // their own, and sums depend on that.
        std::vector<unsigned int> order(points.size());
        for (unsigned int i = 0; i < order.size(); ++i)
          order[i] = i;
        std::sort(order.begin(),
                  order.end(),
                  [&](const unsigned int a, const unsigned int b) {
                    for (unsigned int d = 0; d < dim; ++d)
                      if (points[a][d] != points[b][d])
                        return points[a][d] < points[b][d];
                    return false;
                  });
        Point<dim> mean;
        for (const unsigned int i : order)
          mean += weights[i] * points[i];
        return shape->place(mean);
      }

    private:
      std::shared_ptr<const FaultShape<dim>> shape;
    };



    /** The line in which several surfaces meet. */
    template <int dim>
    class CommonShape : public FaultShape<dim>
    {
    public:
      explicit CommonShape(
        const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes)
        : shapes(shapes)
      {}

      virtual Point<dim>
      place(const Point<dim> &point) const override
      {
        Point<dim> result = point;
        double     moved  = std::numeric_limits<double>::max();
        for (unsigned int i = 0; i < 200; ++i)
          {
            const Point<dim> before = result;
            for (const auto &shape : shapes)
              result = shape->place(result);
            // Steps that do not get shorter are rounding.
            const double step = result.distance(before);
            if (step == 0. || step >= moved)
              break;
            moved = step;
          }
        return result;
      }

    private:
      std::vector<std::shared_ptr<const FaultShape<dim>>> shapes;
    };



    /** Edges between sides of different shapes get a manifold of their own. */
    void
    set_common_shapes(Triangulation<2> &, const SideShapes<2> &)
    {}



    void
    set_common_shapes(Triangulation<3> &cells, const SideShapes<3> &shapes)
    {
      std::map<unsigned int, std::set<types::boundary_id>> sides_of_line;
      for (const auto &face : cells.active_face_iterators())
        if (face->at_boundary() && shapes.count(face->boundary_id()) > 0)
          for (unsigned int l = 0; l < face->n_lines(); ++l)
            sides_of_line[face->line(l)->index()].insert(face->boundary_id());

      // Beyond the indicators of all sides.
      types::manifold_id next = shapes.rbegin()->first + 1000;
      std::map<std::set<types::boundary_id>, types::manifold_id> number;
      for (const auto &face : cells.active_face_iterators())
        if (face->at_boundary())
          for (unsigned int l = 0; l < face->n_lines(); ++l)
            {
              const auto sides = sides_of_line.find(face->line(l)->index());
              if (sides == sides_of_line.end() || sides->second.size() < 2)
                continue;
              const auto [place, is_new] = number.emplace(sides->second, next);
              if (is_new)
                {
                  std::vector<std::shared_ptr<const FaultShape<3>>> several;
                  for (const types::boundary_id side : sides->second)
                    several.push_back(shapes.at(side));
                  cells.set_manifold(next++,
                                     ShapeManifold<3>(
                                       std::make_shared<CommonShape<3>>(
                                         several)));
                }
              face->line(l)->set_manifold_id(place->second);
            }
    }



    /** Size of the smallest face at each vertex on a side: the shortest
     * distance between vertices of one face. */
    template <int dim>
    std::map<unsigned int, double>
    face_sizes(const BodyCells<dim> &body, const types::boundary_id side)
    {
      std::map<unsigned int, double> sizes;
      const auto                     look_at = [&](const auto &faces) {
        for (const auto &face : faces)
          if (face.boundary_id == side)
            for (const unsigned int v : face.vertices)
              for (const unsigned int w : face.vertices)
                if (v != w)
                  {
                    const double length =
                      body.vertices[v].distance(body.vertices[w]);
                    const auto place = sizes.emplace(v, length).first;
                    place->second = std::min(place->second, length);
                  }
      };
      if constexpr (dim == 2)
        look_at(body.boundary.boundary_lines);
      else
        look_at(body.boundary.boundary_quads);
      return sizes;
    }



    /** Three digits, for messages. */
    std::string
    roughly(const double x)
    {
      std::ostringstream out;
      out.precision(3);
      out << x;
      return out.str();
    }



    double
    volume(const std::array<Tensor<1, 2>, 2> &edges)
    {
      return cross_product_2d(edges[0]) * edges[1] * -1.;
    }



    double
    volume(const std::array<Tensor<1, 3>, 3> &edges)
    {
      return cross_product_3d(edges[0], edges[1]) * edges[2];
    }
  } // namespace



  template <int dim>
  Point<dim>
  GraphShape<dim>::place(const Point<dim> &point) const
  {
    Point<dim> result = point;
    result[axis]      = coordinate(point);
    return result;
  }



  template <int dim>
  void
  set_shapes(Triangulation<dim> &cells, const SideShapes<dim> &shapes)
  {
    if (shapes.empty())
      return;
    for (const auto &face : cells.active_face_iterators())
      if (face->at_boundary() && shapes.count(face->boundary_id()) > 0)
        face->set_all_manifold_ids(face->boundary_id());
    for (const auto &[side, shape] : shapes)
      cells.set_manifold(side, ShapeManifold<dim>(shape));
    set_common_shapes(cells, shapes);
  }



  template <int dim>
  bool
  has_shapes(const Triangulation<dim> &cells)
  {
    const std::vector<types::manifold_id> manifolds = cells.get_manifold_ids();
    return std::any_of(manifolds.begin(),
                       manifolds.end(),
                       [](const types::manifold_id id) {
                         return id != numbers::flat_manifold_id;
                       });
  }



  template <int dim>
  void
  move_onto_shapes(
    std::vector<BodyCells<dim>>                               &bodies,
    const FaultTopology                                       &topology,
    const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes)
  {
    for (unsigned int f = 0; f < shapes.size(); ++f)
      {
        if (!shapes[f])
          continue;
        for (const auto &side : topology.faults()[f].sides)
          for (const BodySide &part : side)
            for (const auto &[vertex, size] :
                 face_sizes(bodies[part.body], part.side))
              {
                Point<dim>      &position = bodies[part.body].vertices[vertex];
                const Point<dim> place    = shapes[f]->place(position);
                const double     distance = place.distance(position);
                // Also where the distance is no number.
                if (!(distance <= most_off_shape * size))
                  throw InputError(
                    "The vertex at " + position_text(position) +
                    " on the fault '" + topology.faults()[f].name + "' is " +
                    roughly(distance) +
                    " m off its 'Shape', and its "
                    "smallest face is " +
                    roughly(size) +
                    " m long; it must be closer than a tenth of that.");
                position = place;
              }
      }
  }



  template <int dim>
  SideShapes<dim>
  shapes_of_body(
    const unsigned int                                         body,
    const FaultTopology                                       &topology,
    const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes)
  {
    SideShapes<dim> result;
    for (unsigned int f = 0; f < shapes.size(); ++f)
      if (shapes[f])
        for (const auto &side : topology.faults()[f].sides)
          for (const BodySide &part : side)
            if (part.body == body)
              result[part.side] = shapes[f];
    return result;
  }



  namespace
  {
    /** True if an active cell has a mark, or if there are none. */
    template <int dim>
    bool
    is_marked(const typename Triangulation<dim>::active_cell_iterator &cell,
              const std::vector<bool>                                 &marks)
    {
      return marks.empty() || marks[cell->active_cell_index()];
    }
  } // namespace



  template <int dim>
  void
  straighten_hanging_vertices(Triangulation<dim>      &mesh,
                              const std::vector<bool> &marks)
  {
    const auto straighten_line = [](const auto &line) {
      if (line->has_children())
        line->child(0)->vertex(1) =
          0.5 * (line->vertex(0) + Tensor<1, dim>(line->vertex(1)));
    };
    // Ends of edges may hang on those of larger cells, which come first.
    for (unsigned int level = 0; level + 1 < mesh.n_levels(); ++level)
      for (const auto &cell : mesh.active_cell_iterators_on_level(level))
        for (const auto &face : cell->face_iterators())
          {
            if (!face->has_children() || !is_marked<dim>(cell, marks))
              continue;
            if constexpr (dim == 2)
              straighten_line(face);
            else
              {
                for (unsigned int l = 0; l < face->n_lines(); ++l)
                  straighten_line(face->line(l));
                Tensor<1, dim> mean;
                for (const auto v : face->vertex_indices())
                  mean += face->vertex(v) / face->n_vertices();
                // The last vertex of the first part is in the middle.
                face->child(0)->vertex(face->n_vertices() - 1) =
                  Point<dim>(mean);
              }
          }
  }



  template <int dim>
  void
  refuse_inverted_cells(const Triangulation<dim> &mesh,
                        const std::vector<bool>  &marks)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (is_marked<dim>(cell, marks))
        for (const unsigned int v : cell->vertex_indices())
          {
            std::array<Tensor<1, dim>, dim> edges;
            if (cell->n_vertices() == dim + 1)
              for (unsigned int d = 0; d < dim; ++d)
                edges[d] = cell->vertex(d + 1) - cell->vertex(0);
            else
              for (unsigned int d = 0; d < dim; ++d)
                edges[d] =
                  cell->vertex(v | (1u << d)) - cell->vertex(v & ~(1u << d));
            if (!(volume(edges) > 0.))
              refuse_inverted_cell(Point<dim>(cell->center()));
          }
  }



  template <int dim>
  void
  refuse_inverted_cell(const Point<dim> &centre)
  {
    throw InputError(
      "The cell at " + position_text(centre) +
      " is inverted after refinement, since a fault bends there by more than "
      "cells of the coarse mesh are high; these must be smaller there.");
  }



#define STICKSLIP_INSTANTIATE(dim)                                               \
  template class GraphShape<dim>;                                                \
  template decltype(set_shapes<dim>)       set_shapes<dim>;                      \
  template decltype(has_shapes<dim>)       has_shapes<dim>;                      \
  template decltype(move_onto_shapes<dim>) move_onto_shapes<dim>;                \
  template decltype(shapes_of_body<dim>)   shapes_of_body<dim>;                  \
  template decltype(straighten_hanging_vertices<dim>)                            \
                                               straighten_hanging_vertices<dim>; \
  template decltype(refuse_inverted_cell<dim>) refuse_inverted_cell<dim>;        \
  template decltype(refuse_inverted_cells<dim>) refuse_inverted_cells<dim>;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
