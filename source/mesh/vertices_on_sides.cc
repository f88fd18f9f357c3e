// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/vertices_on_sides.h>

namespace StickSlip
{
  template <int dim>
  std::vector<bool>
  vertices_on_sides(const Triangulation<dim>           &mesh,
                    const std::set<types::boundary_id> &sides)
  {
    std::vector<bool> is_on_side(mesh.n_vertices(), false);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
            for (const auto v : face->vertex_indices())
              is_on_side[face->vertex_index(v)] = true;
    return is_on_side;
  }



  template <int dim>
  bool
  has_marked_vertex(const typename Triangulation<dim>::cell_iterator &cell,
                    const std::vector<bool>                          &marks)
  {
    for (const auto v : cell->vertex_indices())
      if (marks[cell->vertex_index(v)])
        return true;
    return false;
  }



  template <int dim>
  void
  mark_rows_around(const Triangulation<dim> &mesh,
                   const unsigned int        n_rows,
                   std::vector<bool>        &marks)
  {
    for (unsigned int row = 0; row < n_rows; ++row)
      {
        const std::vector<bool> before = marks;
        for (const auto &cell : mesh.active_cell_iterators())
          if (has_marked_vertex<dim>(cell, before))
            for (const auto v : cell->vertex_indices())
              marks[cell->vertex_index(v)] = true;
      }
  }



  template decltype(vertices_on_sides<2>) vertices_on_sides<2>;
  template decltype(vertices_on_sides<3>) vertices_on_sides<3>;
  template decltype(has_marked_vertex<2>) has_marked_vertex<2>;
  template decltype(has_marked_vertex<3>) has_marked_vertex<3>;
  template decltype(mark_rows_around<2>)  mark_rows_around<2>;
  template decltype(mark_rows_around<3>)  mark_rows_around<3>;
} // namespace StickSlip
