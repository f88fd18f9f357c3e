// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/leaf_cells.h>
#include <stickslip/mesh/tree_order.h>

namespace StickSlip
{
  template <int dim>
  std::vector<unsigned int>
  number_by_trees(DoFHandler<dim> &dofs)
  {
    constexpr types::global_dof_index    none = numbers::invalid_dof_index;
    std::vector<types::global_dof_index> number(dofs.n_dofs(), none);
    types::global_dof_index              n_nodes = 0;
    unsigned int                         n_cells = 0;
    std::vector<unsigned int> cells(dofs.get_triangulation().n_active_cells());
    for_each_leaf(dofs, [&](const auto &cell) {
      cells[cell->active_cell_index()] = n_cells++;
      for (const auto v : cell->vertex_indices())
        if (types::global_dof_index &its = number[cell->vertex_dof_index(v, 0)];
            its == none)
          its = n_nodes++;
    });
    dofs.renumber_dofs(number);
    return cells;
  }



  template decltype(number_by_trees<2>) number_by_trees<2>;
  template decltype(number_by_trees<3>) number_by_trees<3>;
} // namespace StickSlip
