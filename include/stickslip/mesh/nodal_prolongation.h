// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_nodal_prolongation_h
#define stickslip_mesh_nodal_prolongation_h

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
    NodalProlongation() = default;

    /**
     * The rows of the @p wanted nodes of the level @p fine: the values there of
     * the basis functions of @p coarse, whose meshes differ by at most one
     * refinement of each cell, or are not nested. In the latter case nodes
     * outside of the coarse cells have the values next to them. Each process
     * finds the rows of its own nodes, and asks for others. Collective.
     */
    template <int dim>
    NodalProlongation(const MeshLevel<dim> &coarse,
                      const MeshLevel<dim> &fine,
                      const IndexSet       &wanted);

    /** The row of a fine node, which must be among the wanted ones. */
    GlobalRow
    row(const types::global_dof_index fine_node) const;

    /** The fine nodes that have a row here. */
    const IndexSet &
    rows() const
    {
      return fine_nodes;
    }

    /** The coarse nodes in any row here. */
    IndexSet
    columns(const types::global_dof_index n_coarse) const;

  private:
    IndexSet                             fine_nodes;
    std::vector<unsigned int>            row_start = {0};
    std::vector<types::global_dof_index> column;
    std::vector<double>                  value;
  };
} // namespace StickSlip

#endif
