// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_volume_cells_h
#define stickslip_multigrid_volume_cells_h

#include <stickslip/algebra/operator_sum.h>
#include <stickslip/algebra/transfer_matrix.h>

#include <vector>

namespace StickSlip
{
  /** Nodes that all couple to each other, in ascending order. */
  using NodePatch = std::vector<unsigned int>;

  /** For each owned node the number of the matrix in which its volume is
   * stiff, or numbers::invalid_unsigned_int; empty if there is no such node. */
  using StiffVolumes = std::vector<unsigned int>;

  /**
   * The nodes of nearly incompressible bodies in the plane, found from matrices
   * with the @p sparsity. The softest motion of the nodes of a cell among fixed
   * neighbours is a vortex around it, which keeps the volumes of all cells if
   * only the mean over each counts. With A the part of a matrix at these nodes,
   * of n components, and S its sum over equal components, which knows the
   * shapes of the cells alone, the ratio
   *
   *   n lambda_min(A) / lambda_min(S) <= 1
   *
   * is no less than 2 mu / (lambda + 3 mu) inside of an elastic body: 0.44 at
   * nu = 0.3, 0.17 at 0.45, and 0.04 at 0.49, which vortices take. Cells count
   * from 0.1 downwards; where several matrices do, the one with the least ratio
   * is the node's.
   *
   * A sample of the nodes tells if there are any. In three dimensions and out
   * of the plane nothing is looked for.
   */
  template <typename Matrix>
  StiffVolumes
  find_stiff_volumes(const BlockSparsity             &sparsity,
                     const std::vector<Matrix>       &matrices,
                     const NodeMask                  &fixed,
                     const std::vector<unsigned int> &nonsmooth_nodes);

  /** The stiff volumes of the @p n_coarse owned nodes of the next coarser
   * level: of those from which a node with one is interpolated. */
  StiffVolumes
  coarsen_stiff_volumes(const StiffVolumes   &fine,
                        const TransferMatrix &prolongation,
                        const unsigned int    n_coarse);

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
