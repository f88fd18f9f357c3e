// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_nodal_prolongation_h
#define stickslip_mesh_nodal_prolongation_h

#include <stickslip/algebra/packed_rows.h>
#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/mesh/mesh_level.h>

namespace StickSlip
{
  /**
   * Some rows of the prolongation between the nodal bases of two levels, in
   * global numbers of nodes.
   */
  class NodalProlongation
  {
  public:
    /**
     * The rows of the owned nodes of the level @p fine: the values there of the
     * basis functions of @p coarse, whose meshes differ by at most one
     * refinement of each cell, or are not nested. In the latter case nodes
     * outside of the coarse cells have the values next to them. Rows of hanging
     * nodes are empty.
     */
    template <int dim>
    NodalProlongation(const MeshLevel<dim> &coarse, const MeshLevel<dim> &fine);

    /** The rows of @p own_rows, which have to stay where they are, and those of
     * the @p wanted nodes of others, which are asked for them. @p fine: the
     * owned nodes. Collective. */
    NodalProlongation(const NodalProlongation &own_rows,
                      const NodePartition     &fine,
                      const IndexSet          &wanted);

    /** The row of a fine node, which must be one of those above. */
    GlobalRow
    row(const types::global_dof_index fine_node) const;

  private:
    const NodalProlongation            *own_rows = nullptr;
    IndexSet                            fine_nodes;
    PackedRows<types::global_dof_index> rows;
  };
} // namespace StickSlip

#endif
