// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_node_positions_h
#define stickslip_output_node_positions_h

#include <stickslip/output/fault_layout.h>
#include <stickslip/output/table_columns.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Reference positions of the nodes of all faults as tables have them, m: x
   * and in three dimensions y; where a fault of the scene is not level, all
   * other coordinates, and in two dimensions the way along the fault
   * (arc_lengths()).
   */
  template <int dim>
  class NodePositions
  {
  public:
    /** @p shapes: one entry a fault. */
    explicit NodePositions(const std::vector<FaultLayout<dim>> &shapes);

    /** Columns of the position of @p what: titles are @p name and _x, _y, _z
     * and _arc_length, as far as they are there. */
    TableColumns
    columns(const std::string &name, const std::string &what) const;

    /** Numbers in the columns of a position. */
    const std::vector<double> &
    at(const unsigned int fault, const unsigned int node) const
    {
      return positions[fault][node];
    }

  private:
    bool                                          are_level;
    std::vector<std::vector<std::vector<double>>> positions;
  };
} // namespace StickSlip

#endif
