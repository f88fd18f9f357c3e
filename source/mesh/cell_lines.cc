// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/mesh/cell_lines.h>

#include <algorithm>
#include <array>

namespace StickSlip
{
  namespace
  {
    /** Cells that are so many times as long along all other axes are in lines:
     * from here on neighbours couple as strongly as find_strong_lines() asks
     * for. */
    template <int dim>
    constexpr double least_aspect = (dim == 2 ? 2.9 : 4.1);



    /** The axis of a cell along which its nodes are relaxed in lines, or the
     * dimension if there is none. */
    template <int dim>
    unsigned int
    line_axis(const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      if (!cell->reference_cell().is_hyper_cube())
        return dim;
      std::array<double, dim> extent;
      for (unsigned int d = 0; d < dim; ++d)
        extent[d] =
          cell->face(2 * d)->center().distance(cell->face(2 * d + 1)->center());
      const unsigned int axis =
        std::min_element(extent.begin(), extent.end()) - extent.begin();
      for (unsigned int d = 0; d < dim; ++d)
        if (d != axis && extent[d] < least_aspect<dim> * extent[axis])
          return dim;
      return axis;
    }



    /** All that hangs together with a thing, nearest first. */
    std::vector<unsigned int>
    by_distance(const std::vector<std::vector<unsigned int>> &neighbours,
                const unsigned int                            start,
                std::vector<unsigned int>                    &last_start)
    {
      std::vector<unsigned int> reached = {start};
      last_start[start]                 = start;
      for (unsigned int k = 0; k < reached.size(); ++k)
        for (const unsigned int next : neighbours[reached[k]])
          if (last_start[next] != start)
            {
              last_start[next] = start;
              reached.push_back(next);
            }
      return reached;
    }
  } // namespace



  template <int dim>
  bool
  is_across_line(const typename Triangulation<dim>::active_cell_iterator &cell,
                 const unsigned int                                       face)
  {
    return line_axis<dim>(cell) == face / 2;
  }



  template <int dim>
  bool
  has_lines(const Triangulation<dim> &cells)
  {
    for (const auto &cell : cells.active_cell_iterators())
      if (line_axis<dim>(cell) < dim)
        return true;
    return false;
  }



  template <int dim>
  std::vector<CellPair>
  neighbouring_cells(const BodyMesh<dim> &body, const bool in_lines)
  {
    std::vector<unsigned int> axis;
    if (in_lines)
      for (const auto &cell : body.triangulation().active_cell_iterators())
        axis.push_back(line_axis<dim>(cell));
    std::vector<CellPair> pairs;
    for (const auto &cell : body.triangulation().active_cell_iterators())
      for (const auto face : cell->face_indices())
        if (!cell->at_boundary(face))
          {
            // Each pair once: from the finer cell if there is one. Behind a
            // face of finer cells, the neighbour is not active.
            const auto         neighbour = cell->neighbor(face);
            const bool         is_finer  = cell->neighbor_is_coarser(face);
            const unsigned int here      = cell->active_cell_index();
            if (!neighbour->is_active() ||
                !(is_finer || here < neighbour->active_cell_index()))
              continue;
            const unsigned int there = neighbour->active_cell_index();
            if (in_lines)
              {
                if (axis[here] != face / 2)
                  continue;
                const unsigned int face_there =
                  is_finer ? cell->neighbor_of_coarser_neighbor(face).first :
                             cell->neighbor_of_neighbor(face);
                if (axis[there] != face_there / 2)
                  continue;
              }
            pairs.emplace_back(here, there);
          }
    return pairs;
  }



  std::vector<unsigned int>
  pieces_of_lines(const unsigned int           n,
                  const std::vector<CellPair> &pairs,
                  const unsigned int           longest)
  {
    std::vector<std::vector<unsigned int>> neighbours(n);
    for (const auto &[a, b] : pairs)
      {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
      }
    std::vector<unsigned int> numbers(n, numbers::invalid_unsigned_int),
      last_start(n, numbers::invalid_unsigned_int);
    unsigned int n_pieces = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        if (numbers[i] != numbers::invalid_unsigned_int)
          continue;
        // From one end to the other.
        const std::vector<unsigned int> line =
          by_distance(neighbours,
                      by_distance(neighbours, i, last_start).back(),
                      last_start);
        const std::size_t its_pieces = (line.size() + longest - 1) / longest;
        for (unsigned int k = 0; k < line.size(); ++k)
          numbers[line[k]] = n_pieces + k * its_pieces / line.size();
        n_pieces += its_pieces;
      }
    return numbers;
  }



  template std::vector<CellPair>
  neighbouring_cells(const BodyMesh<2> &, const bool);
  template std::vector<CellPair>
  neighbouring_cells(const BodyMesh<3> &, const bool);
  template bool
  is_across_line<2>(const typename Triangulation<2>::active_cell_iterator &,
                    const unsigned int);
  template bool
  is_across_line<3>(const typename Triangulation<3>::active_cell_iterator &,
                    const unsigned int);
  template decltype(has_lines<2>) has_lines<2>;
  template decltype(has_lines<3>) has_lines<3>;
} // namespace StickSlip
