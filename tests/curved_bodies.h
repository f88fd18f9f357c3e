// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_curved_bodies_h
#define stickslip_tests_curved_bodies_h

#include <stickslip/geometry/coarse_body.h>
#include <stickslip/geometry/fault_shape.h>
#include <stickslip/geometry/smooth_shape.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace StickSlip::Tests
{
  /** Bodies before any refinement, and what is between them. */
  template <int dim>
  struct ShapedBodies
  {
    std::vector<BodyCells<dim>> cells;
    FaultTopology               topology;

    /** The bodies with the shapes of all faults, refined so many times. */
    std::vector<CoarseBody<dim>>
    coarse(const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes,
           const unsigned int uniform_refinements,
           const unsigned int refinement_passes = 0) const
    {
      std::vector<BodyCells<dim>> moved = cells;
      move_onto_shapes(moved, topology, shapes);
      std::vector<CoarseBody<dim>> result;
      for (unsigned int b = 0; b < cells.size(); ++b)
        {
          const auto mesh = moved[b].triangulation();
          set_shapes(*mesh, shapes_of_body(b, topology, shapes));
          result.emplace_back();
          result[b].cells               = mesh;
          result[b].side_names          = cells[b].side_names;
          result[b].uniform_refinements = uniform_refinements;
          result[b].refinement_passes   = refinement_passes;
        }
      return result;
    }

    /** With a smooth curve through the vertices of all faults. */
    std::vector<CoarseBody<dim>>
    smooth(const unsigned int uniform_refinements,
           const unsigned int refinement_passes = 0) const
    {
      std::vector<std::shared_ptr<const FaultShape<dim>>> shapes;
      for (const Fault &fault : topology.faults())
        shapes.push_back(smooth_shape<dim>(cells, fault));
      return coarse(shapes, uniform_refinements, refinement_passes);
    }
  };



  /** Cells of a grid of two parameters, of which the first may close upon
   * itself; the side at the lower end of parameter d has the indicator 2 d, at
   * the upper end 2 d + 1. Quadrilaterals, or two triangles for each. */
  inline BodyCells<2>
  mapped_grid(const unsigned int n_first,
              const unsigned int n_second,
              const std::function<Point<2>(const double, const double)> &map,
              const bool is_closed    = false,
              const bool of_triangles = false)
  {
    BodyCells<2>       body;
    const unsigned int row = is_closed ? n_first : n_first + 1;
    const auto number      = [&](const unsigned int i, const unsigned int j) {
      return j * row + i % row;
    };
    for (unsigned int j = 0; j <= n_second; ++j)
      for (unsigned int i = 0; i < row; ++i)
        body.vertices.push_back(map(static_cast<double>(i) / n_first,
                                    static_cast<double>(j) / n_second));
    const auto add = [&](const std::vector<unsigned int> &vertices) {
      CellData<2> cell(vertices.size());
      cell.vertices = vertices;
      body.cells.push_back(cell);
    };
    for (unsigned int j = 0; j < n_second; ++j)
      for (unsigned int i = 0; i < n_first; ++i)
        {
          const unsigned int a = number(i, j), b = number(i + 1, j),
                             c = number(i, j + 1), d = number(i + 1, j + 1);
          if (!of_triangles)
            add({a, b, c, d});
          else if (body.vertices[b].distance(body.vertices[c]) <
                   (1. - 1e-12) * body.vertices[a].distance(body.vertices[d]))
            {
              add({a, b, c});
              add({b, d, c});
            }
          else
            {
              add({a, b, d});
              add({a, d, c});
            }
        }
    const auto add_face = [&](const unsigned int       a,
                              const unsigned int       b,
                              const types::boundary_id side) {
      CellData<1> face(2);
      face.vertices    = {a, b};
      face.boundary_id = side;
      body.boundary.boundary_lines.push_back(face);
    };
    for (unsigned int i = 0; i < n_first; ++i)
      {
        add_face(number(i, 0), number(i + 1, 0), 2);
        add_face(number(i, n_second), number(i + 1, n_second), 3);
      }
    for (unsigned int j = 0; j < n_second && !is_closed; ++j)
      {
        add_face(number(0, j), number(0, j + 1), 0);
        add_face(number(n_first, j), number(n_first, j + 1), 1);
      }
    return body;
  }



  /** A lower and an upper layer of height one half and length one, whose common
   * side is on a curve of elevation f(x). */
  inline ShapedBodies<2>
  two_layers_at(const std::function<double(const double)> &f,
                const unsigned int                         n_below,
                const unsigned int                         n_above,
                const unsigned int                         n_high,
                const bool                                 of_triangles = false)
  {
    ShapedBodies<2> result;
    result.cells    = {mapped_grid(
                      n_below,
                      n_high,
                      [&](const double x, const double s) {
                        return Point<2>(x, s * f(x) - (1. - s) * 0.5);
                      },
                      false,
                      of_triangles),
                       mapped_grid(
                      n_above,
                      n_high,
                      [&](const double x, const double s) {
                        return Point<2>(x, (1. - s) * f(x) + s * 0.5);
                      },
                      false,
                      of_triangles)};
    result.topology = stack_topology<2>({"lower", "upper"}, {"main"});
    return result;
  }



  /** A ring in a ring about the origin, of radii a < b < c, with @p n_inner and
   * @p n_outer faces around, the fault between them. */
  inline ShapedBodies<2>
  two_rings(const std::array<double, 3> &radii,
            const unsigned int           n_inner,
            const unsigned int           n_outer,
            const unsigned int           n_radial,
            const bool                   of_triangles = false)
  {
    const auto ring =
      [&](const unsigned int n, const double inner, const double outer) {
        return mapped_grid(
          n,
          n_radial,
          [=](const double s, const double t) {
            // Clockwise, so that cells are positive.
            const double angle  = -2. * numbers::PI * s,
                         radius = inner + t * (outer - inner);
            return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
          },
          /*is_closed=*/true,
          of_triangles);
      };
    ShapedBodies<2> result;
    result.cells    = {ring(n_inner, radii[0], radii[1]),
                       ring(n_outer, radii[1], radii[2])};
    result.topology = stack_topology<2>({"inner", "outer"}, {"main"});
    return result;
  }
} // namespace StickSlip::Tests

#endif
