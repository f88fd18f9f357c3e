// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_volume_cells_h
#define stickslip_multigrid_volume_cells_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/multigrid/level_description.h>

#include <vector>

namespace StickSlip
{
  /** Nodes that all couple to each other, in ascending order. */
  using NodePatch = std::vector<unsigned int>;

  /** The stiff volumes, in any of @p n_terms, of the owned nodes of the next
   * coarser level: of those from which a node with one is interpolated.
   * Collective. */
  StiffVolumes
  coarsen_stiff_volumes(const StiffVolumes   &fine,
                        const TransferMatrix &prolongation,
                        const NodePartition  &coarse_nodes,
                        const unsigned int    n_terms);

  /**
   * The largest sets of owned nodes, not wholly @p fixed ones, that all couple
   * to each other, which are the cells of a mesh; those of them that have a
   * node with a stiff volume, ascending by their first nodes.
   */
  std::vector<NodePatch>
  find_stiff_cells(const BlockSparsity &sparsity,
                   const NodeMask      &fixed,
                   const StiffVolumes  &stiff_volumes);
} // namespace StickSlip

#endif
