// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/manifold.h>

#include <stickslip/geometry/fault_shape.h>
#include <stickslip/mesh/partial_mesh.h>
#include <stickslip/mesh/red_refinement.h>

#include <algorithm>
#include <map>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** The ends of an edge in rising order. */
    using Edge = std::array<unsigned int, 2>;



    Edge
    make_edge(const unsigned int a, const unsigned int b)
    {
      return {{std::min(a, b), std::max(a, b)}};
    }



    /** The manifolds of edges that have a shape. */
    std::map<Edge, types::manifold_id>
    shaped_edges(const Triangulation<3> &mesh)
    {
      std::map<Edge, types::manifold_id> result;
      if (has_shapes(mesh))
        for (const auto &face : mesh.active_face_iterators())
          if (face->at_boundary())
            for (unsigned int l = 0; l < face->n_lines(); ++l)
              {
                const auto line = face->line(l);
                if (line->manifold_id() != numbers::flat_manifold_id)
                  result[make_edge(line->vertex_index(0),
                                   line->vertex_index(1))] =
                    line->manifold_id();
              }
      return result;
    }



    /** Vertices in the middle of edges, made when they are first asked for. */
    class Middles
    {
    public:
      Middles(const Triangulation<3>                   &mesh,
              const std::map<Edge, types::manifold_id> &shapes)
        : vertices(mesh.get_vertices())
        , straight(vertices)
        , mesh(mesh)
        , shapes(shapes)
      {
        for (unsigned int v = 0; v < vertices.size(); ++v)
          parents.push_back({{v, v}});
      }

      unsigned int
      operator()(const unsigned int a, const unsigned int b)
      {
        const Edge ends            = make_edge(a, b);
        const auto [place, is_new] = number.emplace(ends, vertices.size());
        if (is_new)
          {
            vertices.push_back(middle(ends));
            straight.push_back(
              0.5 * (vertices[ends[0]] + Tensor<1, 3>(vertices[ends[1]])));
            parents.push_back(ends);
          }
        return place->second;
      }

      std::vector<Point<3>> vertices;

      /** Positions with all new vertices in the middle of edges. */
      std::vector<Point<3>> straight;
      std::vector<Edge>     parents;

    private:
      Point<3>
      middle(const Edge &ends) const
      {
        const std::array<Point<3>, 2> points = {
          {vertices[ends[0]], vertices[ends[1]]}};
        const auto shape = shapes.find(ends);
        if (shape == shapes.end())
          return 0.5 * (points[0] + Tensor<1, 3>(points[1]));
        const std::array<double, 2> halves = {{0.5, 0.5}};
        return mesh.get_manifold(shape->second)
          .get_new_point(make_array_view(points.begin(), points.end()),
                         make_array_view(halves.begin(), halves.end()));
      }

      const Triangulation<3>                   &mesh;
      const std::map<Edge, types::manifold_id> &shapes;
      std::map<Edge, unsigned int>              number;
    };



    /** Faces and edges of the finer mesh have the shapes of those of which they
     * are parts. */
    void
    hand_on_shapes(const Triangulation<3>                   &coarse,
                   const std::map<Edge, types::manifold_id> &shapes,
                   const std::vector<Edge>                  &parents,
                   Triangulation<3>                         &fine)
    {
      for (const types::manifold_id id : coarse.get_manifold_ids())
        if (id != numbers::flat_manifold_id)
          fine.set_manifold(id, coarse.get_manifold(id));
      // The side of a face has the number of its shape, edges between sides
      // may have another one.
      for (const auto &face : fine.active_face_iterators())
        if (face->at_boundary() &&
            face->manifold_id() != numbers::flat_manifold_id)
          face->set_all_manifold_ids(face->manifold_id());
      for (const auto &face : fine.active_face_iterators())
        if (face->at_boundary())
          for (unsigned int l = 0; l < face->n_lines(); ++l)
            {
              const unsigned int a = face->line(l)->vertex_index(0),
                                 b = face->line(l)->vertex_index(1);
              for (const auto &[end, middle] : {Edge{{a, b}}, Edge{{b, a}}})
                {
                  const Edge &parent = parents[middle];
                  const auto  shape  = shapes.find(parent);
                  if (shape != shapes.end() &&
                      (parent[0] == end || parent[1] == end))
                    face->line(l)->set_manifold_id(shape->second);
                }
            }
    }



    /** The eight parts of a cell, all of positive volume if it is and edges are
     * straight. */
    std::array<std::array<unsigned int, 4>, 8>
    parts_of(const std::array<unsigned int, 4> &v, Middles &middle)
    {
      const unsigned int m01 = middle(v[0], v[1]), m02 = middle(v[0], v[2]),
                         m03 = middle(v[0], v[3]), m12 = middle(v[1], v[2]),
                         m13 = middle(v[1], v[3]), m23 = middle(v[2], v[3]);

      // The diagonals of the octahedron, and for each the other four vertices
      // around it, such that the first end, two neighbours and the second end
      // are in the order of a cell of positive volume.
      struct Diagonal
      {
        unsigned int                from, to;
        std::array<unsigned int, 4> around;
      };
      const std::array<Diagonal, 3> diagonals = {
        {{m01, m23, {{m02, m03, m13, m12}}},
         {m02, m13, {{m01, m12, m23, m03}}},
         {m03, m12, {{m01, m02, m23, m13}}}}};
      const Diagonal &shortest =
        *std::min_element(diagonals.begin(),
                          diagonals.end(),
                          [&](const Diagonal &a, const Diagonal &b) {
                            const auto length = [&](const Diagonal &d) {
                              return middle.vertices[d.from].distance_square(
                                middle.vertices[d.to]);
                            };
                            return length(a) < length(b);
                          });

      std::array<std::array<unsigned int, 4>, 8> parts = {
        {{{v[0], m01, m02, m03}},
         {{m01, v[1], m12, m13}},
         {{m02, m12, v[2], m23}},
         {{m03, m13, m23, v[3]}}}};
      for (unsigned int i = 0; i < 4; ++i)
        parts[4 + i] = {{shortest.from,
                         shortest.around[i],
                         shortest.around[(i + 1) % 4],
                         shortest.to}};
      // The turning sense around a diagonal depends on which one it is. Where
      // edges have a shape, cells are checked afterwards.
      for (unsigned int i = 4; i < 8; ++i)
        {
          const auto &p = middle.straight;
          if (cross_product_3d(p[parts[i][1]] - p[parts[i][0]],
                               p[parts[i][2]] - p[parts[i][0]]) *
                (p[parts[i][3]] - p[parts[i][0]]) <
              0.)
            std::swap(parts[i][1], parts[i][2]);
        }
      return parts;
    }
  } // namespace



  RedRefinement::RedRefinement(const Triangulation<3>  &coarse,
                               const std::vector<bool> &is_refined)
  {
    Assert(coarse.all_reference_cells_are_simplex() && coarse.n_levels() == 1,
           ExcMessage("Only plain tetrahedra are refined here."));
    const std::map<Edge, types::manifold_id> shapes = shaped_edges(coarse);
    Middles                                  middle(coarse, shapes);
    std::vector<CellData<3>>                 cells;
    SubCellData                              boundary;
    const auto is_left_out = [&is_refined](const auto &cell) {
      return !is_refined.empty() && !is_refined[cell->active_cell_index()];
    };
    for (const auto &cell : coarse.active_cell_iterators())
      {
        if (is_left_out(cell))
          continue;
        std::array<unsigned int, 4> vertices;
        for (unsigned int v = 0; v < 4; ++v)
          vertices[v] = cell->vertex_index(v);
        for (const auto &part : parts_of(vertices, middle))
          {
            CellData<3> data(4);
            std::copy(part.begin(), part.end(), data.vertices.begin());
            data.material_id = cell->material_id();
            cells.push_back(data);
          }
        for (const unsigned int f : cell->face_indices())
          if (const auto face = cell->face(f);
              face->at_boundary() || is_left_out(cell->neighbor(f)))
            {
              const unsigned int a  = face->vertex_index(0),
                                 b  = face->vertex_index(1),
                                 c  = face->vertex_index(2);
              const unsigned int ab = middle(a, b), bc = middle(b, c),
                                 ca = middle(c, a);
              for (const auto &part :
                   {std::array<unsigned int, 3>{{a, ab, ca}},
                    std::array<unsigned int, 3>{{ab, b, bc}},
                    std::array<unsigned int, 3>{{ca, bc, c}},
                    std::array<unsigned int, 3>{{ab, bc, ca}}})
                {
                  CellData<2> data(3);
                  std::copy(part.begin(), part.end(), data.vertices.begin());
                  if (face->at_boundary())
                    {
                      data.boundary_id = face->boundary_id();
                      data.manifold_id = face->manifold_id();
                    }
                  else
                    data.boundary_id = PartialMesh<3>::cut_side;
                  boundary.boundary_quads.push_back(data);
                }
            }
      }
    if (!shapes.empty())
      for (const auto &cell : cells)
        {
          const Point<3> &origin = middle.vertices[cell.vertices[0]];
          std::array<Tensor<1, 3>, 3> edges;
          for (unsigned int i = 0; i < 3; ++i)
            edges[i] = middle.vertices[cell.vertices[i + 1]] - origin;
          if (!(cross_product_3d(edges[0], edges[1]) * edges[2] > 0.))
            refuse_inverted_cell(
              Point<3>(origin + (edges[0] + edges[1] + edges[2]) / 4.));
        }
    const auto refined = std::make_shared<Triangulation<3>>();
    refined->create_triangulation(middle.vertices, cells, boundary);
    if (!shapes.empty())
      hand_on_shapes(coarse, shapes, middle.parents, *refined);
    mesh    = refined;
    parents = middle.parents;
  }
} // namespace StickSlip
