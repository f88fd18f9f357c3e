// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_leaf_cells_h
#define stickslip_mesh_leaf_cells_h

#include <cstdint>

namespace StickSlip
{
  /**
   * Call @p visit(leaf, path) on the active cells below a cell, or on itself,
   * the children of each in turn. The path has a one, and then the number of
   * the child on each level in as many bits as the dimension.
   */
  template <typename Cell, typename Visitor>
  void
  for_each_leaf_below(const Cell         &cell,
                      const Visitor      &visit,
                      const std::uint64_t path = 1)
  {
    if (cell->is_active())
      visit(cell, path);
    else
      for (unsigned int child = 0; child < cell->n_children(); ++child)
        for_each_leaf_below(cell->child(child),
                            visit,
                            (path << Cell::AccessorType::dimension) + child);
  }



  /**
   * Call @p visit(cell) on the active cells of a Triangulation or a DoFHandler,
   * tree by tree. This order follows from what the cells are, that of deal.II
   * also from how they were made.
   */
  template <typename Cells, typename Visitor>
  void
  for_each_leaf(const Cells &cells, const Visitor &visit)
  {
    for (auto cell = cells.begin(0); cell != cells.end(0); ++cell)
      for_each_leaf_below(typename Cells::cell_iterator(cell),
                          [&](const auto &leaf, const std::uint64_t) {
                            visit(leaf);
                          });
  }
} // namespace StickSlip

#endif
