// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_level_description_h
#define stickslip_multigrid_level_description_h

#include <stickslip/algebra/galerkin_product.h>
#include <stickslip/algebra/operator_sum.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /** For each owned node the number of the matrix in which its volume is
   * stiff, or numbers::invalid_unsigned_int; empty if there is no such node. */
  using StiffVolumes = std::vector<unsigned int>;

  /**
   * A level of a multigrid method and the way to the next coarser one. On a
   * coarse level a component of a nonsmooth node is truncated if it is at all
   * fine nonsmooth nodes around.
   *
   * Nodes may have axes of their own, which may turn from node to node and from
   * level to level; components, fixed and truncated ones too, are along these.
   */
  template <int n_components>
  struct LevelDescription : Unknowns
  {
    /** The axes of the nodes, as in @p to_coarser of this level and of the next
     * finer one. */
    LocalFrames frames;

    /** The transfer to the next coarser level, whose nodes are its coarse
     * nodes; empty on the coarsest level. */
    std::shared_ptr<GalerkinProduct<n_components>> to_coarser;

    /** Nodes of nearly incompressible bodies in the plane, by the terms of the
     * operator; on the finest level only. */
    StiffVolumes stiff_volumes;
  };

  /*
   * Second derivatives at the nonsmooth nodes, and the truncation of their
   * components, on a level and on the next coarser one. All functions are
   * collective.
   */

  /**
   * The rows of a level that these can touch, by local index of the node, for
   * ghosts as their owners have it: rows of the nonsmooth nodes and of nodes
   * coupled to them. @p sparsity is that of the level's matrix.
   */
  template <int n_components>
  std::vector<bool>
  find_strip(const LevelDescription<n_components> &level,
             const BlockSparsity                  &sparsity);

  /**
   * The rows of the strip below a @p finer level: also the rows that see a row
   * of @p finer_strip.
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
