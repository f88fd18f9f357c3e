// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/red_refinement.h>

#include <algorithm>
#include <map>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** Vertices in the middle of edges, made when they are first asked for. */
    class Middles
    {
    public:
      explicit Middles(const std::vector<Point<3>> &coarse_vertices)
        : vertices(coarse_vertices)
      {
        for (unsigned int v = 0; v < vertices.size(); ++v)
          parents.push_back({{v, v}});
      }

      unsigned int
      operator()(const unsigned int a, const unsigned int b)
      {
        const std::array<unsigned int, 2> ends = {
          {std::min(a, b), std::max(a, b)}};
        const auto [place, is_new] = number.emplace(ends, vertices.size());
        if (is_new)
          {
            vertices.push_back(0.5 * (vertices[a] + Tensor<1, 3>(vertices[b])));
            parents.push_back(ends);
          }
        return place->second;
      }

      std::vector<Point<3>>                    vertices;
      std::vector<std::array<unsigned int, 2>> parents;

    private:
      std::map<std::array<unsigned int, 2>, unsigned int> number;
    };



    /** The eight parts of a cell, all of positive volume if it is. */
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
      // The turning sense around a diagonal depends on which one it is.
      for (unsigned int i = 4; i < 8; ++i)
        {
          const auto &p = middle.vertices;
          if (cross_product_3d(p[parts[i][1]] - p[parts[i][0]],
                               p[parts[i][2]] - p[parts[i][0]]) *
                (p[parts[i][3]] - p[parts[i][0]]) <
              0.)
            std::swap(parts[i][1], parts[i][2]);
        }
      return parts;
    }
  } // namespace



  RedRefinement::RedRefinement(const Triangulation<3> &coarse)
  {
    Assert(coarse.all_reference_cells_are_simplex() && coarse.n_levels() == 1,
           ExcMessage("Only plain tetrahedra are refined here."));
    Middles                  middle(coarse.get_vertices());
    std::vector<CellData<3>> cells;
    SubCellData              boundary;
    for (const auto &cell : coarse.active_cell_iterators())
      {
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
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
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
                  data.boundary_id = face->boundary_id();
                  boundary.boundary_quads.push_back(data);
                }
            }
      }
    const auto refined = std::make_shared<Triangulation<3>>();
    refined->create_triangulation(middle.vertices, cells, boundary);
    mesh    = refined;
    parents = middle.parents;
  }
} // namespace StickSlip
