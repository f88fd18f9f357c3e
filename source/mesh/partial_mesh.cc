// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/partial_mesh.h>

namespace StickSlip
{
  namespace
  {
    /** True if both cells of a face have it as a whole, and are kept. */
    template <int dim>
    bool
    is_between_kept(
      const typename Triangulation<dim>::active_cell_iterator &cell,
      const unsigned int                                       face,
      const std::vector<bool>                                 &is_kept)
    {
      if (cell->at_boundary(face))
        return false;
      const auto neighbour = cell->neighbor(face);
      return neighbour->is_active() && neighbour->level() == cell->level() &&
             is_kept[neighbour->active_cell_index()];
    }
  } // namespace



  template <int dim>
  PartialMesh<dim>::PartialMesh(const Triangulation<dim> &whole,
                                const std::vector<bool>  &is_kept)
  {
    AssertDimension(is_kept.size(), whole.n_active_cells());
    std::vector<unsigned int>      number(whole.n_vertices(),
                                     numbers::invalid_unsigned_int);
    std::vector<Point<dim>>        points;
    std::vector<CellData<dim>>     kept;
    std::vector<CellData<dim - 1>> sides;
    for (const auto &cell : whole.active_cell_iterators())
      if (is_kept[cell->active_cell_index()])
        {
          kept.emplace_back(cell->n_vertices());
          cells.push_back(cell->active_cell_index());
          for (const auto v : cell->vertex_indices())
            {
              unsigned int &vertex = number[cell->vertex_index(v)];
              if (vertex == numbers::invalid_unsigned_int)
                {
                  vertex = vertices.size();
                  vertices.push_back(cell->vertex_index(v));
                  points.push_back(cell->vertex(v));
                }
              kept.back().vertices[v] = vertex;
            }
          for (const auto f : cell->face_indices())
            {
              if (is_between_kept<dim>(cell, f, is_kept))
                continue;
              const auto face = cell->face(f);
              sides.emplace_back(face->n_vertices());
              for (const auto v : face->vertex_indices())
                sides.back().vertices[v] = number[face->vertex_index(v)];
              sides.back().boundary_id =
                cell->at_boundary(f) ? face->boundary_id() : cut_side;
            }
        }

    SubCellData side_data;
    if constexpr (dim == 2)
      side_data.boundary_lines = sides;
    else
      side_data.boundary_quads = sides;
    const auto part = std::make_shared<Triangulation<dim>>();
    part->create_triangulation(points, kept, side_data);
    mesh = part;
  }



  template struct PartialMesh<2>;
  template struct PartialMesh<3>;
} // namespace StickSlip
