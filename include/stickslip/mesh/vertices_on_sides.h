// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_vertices_on_sides_h
#define stickslip_mesh_vertices_on_sides_h

#include <deal.II/grid/tria.h>

#include <set>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** For each vertex of a mesh, if it is on a boundary face with one of these
   * indicators. */
  template <int dim>
  std::vector<bool>
  vertices_on_sides(const Triangulation<dim>           &mesh,
                    const std::set<types::boundary_id> &sides);

  /** True if a vertex of a cell is marked. */
  template <int dim>
  bool
  has_marked_vertex(const typename Triangulation<dim>::cell_iterator &cell,
                    const std::vector<bool>                          &marks);

  /** Mark the vertices of so many rows of active cells around marked ones. */
  template <int dim>
  void
  mark_rows_around(const Triangulation<dim> &mesh,
                   const unsigned int        n_rows,
                   std::vector<bool>        &marks);
} // namespace StickSlip

#endif
