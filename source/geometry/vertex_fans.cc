// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/vertex_fans.h>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** Give all cells at a vertex that can be reached from the one at place
     * @p begin without a cut the number of a fan. */
    template <int dim>
    void
    collect_fan(const CellFaces<dim>            &faces,
                const std::vector<bool>         &is_cut,
                const unsigned int               vertex,
                const std::vector<unsigned int> &cells,
                const unsigned int               begin,
                const unsigned int               number,
                std::vector<unsigned int>       &fan_of)
    {
      std::vector<unsigned int> next = {begin};
      fan_of[begin]                  = number;
      while (!next.empty())
        {
          const unsigned int cell = cells[next.back()];
          next.pop_back();
          for (const unsigned int f : faces.faces_of_cell(cell))
            {
              const auto &face = faces.faces()[f];
              if (is_cut[f] || !face.is_interior() ||
                  !std::binary_search(face.key.begin(),
                                      face.key.begin() + face.n_vertices,
                                      vertex))
                continue;
              const unsigned int other =
                face.cells[0] == cell ? face.cells[1] : face.cells[0];
              const unsigned int place =
                std::lower_bound(cells.begin(), cells.end(), other) -
                cells.begin();
              if (fan_of[place] == none)
                {
                  fan_of[place] = number;
                  next.push_back(place);
                }
            }
        }
    }
  } // namespace



  template <int dim>
  VertexFans<dim>::VertexFans(const GroupedCells<dim> &mesh,
                              const CellFaces<dim>    &faces,
                              const std::vector<bool> &is_cut)
  {
    std::map<unsigned int, std::vector<unsigned int>> cells_at;
    for (unsigned int f = 0; f < is_cut.size(); ++f)
      if (is_cut[f])
        for (unsigned int v = 0; v < faces.faces()[f].n_vertices; ++v)
          cells_at[faces.faces()[f].ring[v]];
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int v = 0; v < mesh.cells[c].n_vertices; ++v)
        {
          const auto place = cells_at.find(mesh.cells[c].vertices[v]);
          if (place != cells_at.end())
            place->second.push_back(c);
        }

    for (const auto &[vertex, cells] : cells_at)
      {
        std::vector<unsigned int> fan_of(cells.size(), none);
        unsigned int              n = 0;
        for (unsigned int i = 0; i < cells.size(); ++i)
          if (fan_of[i] == none)
            collect_fan(faces, is_cut, vertex, cells, i, n++, fan_of);
        if (n == 1)
          continue;
        number[vertex] = n;
        for (unsigned int i = 0; i < cells.size(); ++i)
          if (fan_of[i] > 0)
            fans[{vertex, cells[i]}] = fan_of[i];
      }
  }



  template <int dim>
  unsigned int
  VertexFans<dim>::fan(const unsigned int cell, const unsigned int vertex) const
  {
    const auto place = fans.find({vertex, cell});
    return place == fans.end() ? 0 : place->second;
  }



  template <int dim>
  unsigned int
  VertexFans<dim>::n_fans(const unsigned int vertex) const
  {
    const auto place = number.find(vertex);
    return place == number.end() ? 1 : place->second;
  }



  template class VertexFans<2>;
  template class VertexFans<3>;
} // namespace StickSlip
