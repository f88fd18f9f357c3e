// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/dofs/dof_tools.h>

#include <stickslip/mesh/hanging_nodes.h>

namespace StickSlip
{
  namespace
  {
    /** The vertices in the middle of edges and faces of cells that are not
     * real. */
    template <int dim>
    std::vector<bool>
    middles_of_stand_ins(const Triangulation<dim> &mesh,
                         const std::vector<bool>  &is_real)
    {
      std::vector<bool> result(mesh.n_vertices(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        if (!is_real[cell->active_cell_index()])
          {
            for (unsigned int l = 0; l < cell->n_lines(); ++l)
              if (cell->line(l)->has_children())
                result[cell->line(l)->child(0)->vertex_index(1)] = true;
            if constexpr (dim == 3)
              for (const auto &face : cell->face_iterators())
                if (face->has_children())
                  result[face->child(0)->vertex_index(3)] = true;
          }
      return result;
    }
  } // namespace



  template <int dim>
  void
  add_hanging_nodes(const DoFHandler<dim>     &dofs,
                    const std::vector<bool>   &is_real,
                    AffineConstraints<double> &constraints)
  {
    const std::vector<bool> is_middle =
      middles_of_stand_ins(dofs.get_triangulation(), is_real);
    std::vector<bool> is_left_out(dofs.n_dofs(), false);
    for (const auto &cell : dofs.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        if (is_middle[cell->vertex_index(v)])
          is_left_out[cell->vertex_dof_index(v, 0)] = true;

    AffineConstraints<double> hanging;
    DoFTools::make_hanging_node_constraints(dofs, hanging);
    for (const auto &line : hanging.get_lines())
      if (!is_left_out[line.index])
        {
          constraints.add_line(line.index);
          constraints.add_entries(line.index, line.entries);
        }
  }



  template decltype(add_hanging_nodes<2>) add_hanging_nodes<2>;
  template decltype(add_hanging_nodes<3>) add_hanging_nodes<3>;
} // namespace StickSlip
