// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_unit_numbers_h
#define stickslip_mesh_unit_numbers_h

#include <deal.II/dofs/dof_handler.h>

#include <stickslip/mesh/mesh_share.h>
#include <stickslip/mesh/node_numbers.h>

#include <vector>

namespace StickSlip
{
  /** Numbers that nodes and cells of a share have in the whole mesh, which are
   * those that one process gives them: tree by tree, nodes in the order of the
   * first cell that has them. What is not real has none. */
  struct UnitNumbers
  {
    NodeNumbers nodes;

    /** The number of cells of the whole mesh, and that of each active cell. */
    unsigned int              n_cells = 0;
    std::vector<unsigned int> cells;
  };

  /**
   * The numbers of a @p share, from one degree of freedom at each vertex of its
   * mesh. A node belongs to the least owner of the units of the cells that have
   * it as a vertex. Processes count what is in their units, and ask each other
   * for the numbers of what is around them. Collective.
   */
  template <int dim>
  UnitNumbers
  number_share(const MeshShare<dim>  &share,
               const DoFHandler<dim> &dofs,
               const MPI_Comm        &communicator);
} // namespace StickSlip

#endif
