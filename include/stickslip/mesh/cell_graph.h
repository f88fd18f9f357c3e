// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_cell_graph_h
#define stickslip_mesh_cell_graph_h

#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Cells, or groups of cells that stay together, as nodes of a graph; an edge
   * joins two that are better owned by the same process.
   */
  class CellGraph
  {
  public:
    /** @p n_cells: of each group. */
    explicit CellGraph(const std::vector<unsigned int> &n_cells);

    /** Add the weight of an edge; one between the same nodes is made heavier.
     */
    void
    add_edge(const unsigned int a,
             const unsigned int b,
             const unsigned int weight);

    /** The part of each group: about as many cells for each part, with little
     * weight between them. The same arguments give the same parts. */
    std::vector<unsigned int>
    parts(const unsigned int n_parts) const;

  private:
    std::vector<unsigned int>                                       n_cells;
    std::vector<std::vector<std::pair<unsigned int, unsigned int>>> neighbours;
  };
} // namespace StickSlip

#endif
