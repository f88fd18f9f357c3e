// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_level_description_h
#define stickslip_multigrid_level_description_h

#include <stickslip/algebra/galerkin_product.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * What the solver is told of one level.
   */
  template <int n_components>
  struct LevelDescription
  {
    NodePartition nodes;

    /** Leads to the next coarser level, whose nodes are its coarse nodes; empty
     * on the coarsest level. */
    std::shared_ptr<GalerkinProduct<n_components>> to_coarser;

    /** The components that never take part, of owned nodes and ghosts. */
    NodeMask fixed;

    /**
     * The owned nodes with a nonsmooth term, in ascending order; on the coarser
     * levels the nodes that stand for such nodes. A component of such a
     * coarse node is truncated if it is at all its fine neighbours of the
     * same kind.
     */
    std::vector<unsigned int> nonsmooth_nodes;
  };

  /*
   * What the second derivatives at the nonsmooth nodes, and the truncation of
   * their components, mean for a level and for the next coarser one. All
   * functions are collective.
   */

  /**
   * The rows of a level that they can touch, by local index of the node, for
   * ghosts as their owners have it: those of the nonsmooth nodes and of nodes
   * coupled to them. @p sparsity is that of the level's matrix.
   */
  template <int n_components>
  std::vector<bool>
  find_strip(const LevelDescription<n_components> &level,
             const BlockSparsity                  &sparsity);

  /**
   * The same where there is a @p finer level: also the rows that see a row of
   * @p finer_strip.
   */
  template <int n_components>
  std::vector<bool>
  find_strip(const LevelDescription<n_components> &level,
             const BlockSparsity                  &sparsity,
             const LevelDescription<n_components> &finer,
             const std::vector<bool>              &finer_strip);

  /**
   * The components that take part on the level @p coarse where those of
   * @p fine_mask do on the level @p fine.
   */
  template <int n_components>
  NodeMask
  coarsen_mask(const LevelDescription<n_components> &coarse,
               const LevelDescription<n_components> &fine,
               const NodeMask                       &fine_mask);
} // namespace StickSlip

#endif
