// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_sweep_turns_h
#define stickslip_multigrid_sweep_turns_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/some_ghosts.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The order in which processes relax their nodes in a sweep of Gauss-Seidel,
   * so that it is one of the whole matrix: no two nodes that couple and belong
   * to different processes are relaxed at the same time. Processes that did so
   * would both correct the same error, and where couplings are strong, the
   * sweep would not converge.
   *
   * A unit is a node, a line or a patch, whose nodes are relaxed at once. Units
   * that couple to no other process all have the first turn. The others of a
   * process make a piece for each set of processes that they couple to, or one
   * piece if units overlap, and pieces that couple have different turns. Turns
   * are as many as processes meet at a corner, or some more, while most nodes
   * at borders have one of the first two.
   *
   * M. F. Adams, A distributed memory unstructured Gauss-Seidel algorithm for
   * multigrid smoothers, Proceedings of SC2001, describes such an order.
   */
  class SweepTurns
  {
  public:
    using Range = std::pair<unsigned int, unsigned int>;

    /** No nodes. */
    SweepTurns() = default;

    /**
     * Find the turns; collective.
     *
     * @param nodes One that has not been set is of one process alone.
     * @param sparsity The couplings of the owned nodes. What couples on one
     * process couples on the other.
     * @param units The owned nodes of each unit; empty if each node is one.
     * Each owned node is in one at least.
     * @param may_overlap True if nodes may be in several units.
     */
    SweepTurns(const NodePartition                          &nodes,
               const BlockSparsity                          &sparsity,
               const std::vector<std::vector<unsigned int>> &units,
               const bool                                    may_overlap);

    /** One at least, and the same on all processes. */
    unsigned int
    n_turns() const
    {
      return turns.size();
    }

    /** The units first <= u < second of a turn, in ascending order. */
    const std::vector<Range> &
    units(const unsigned int turn) const
    {
      return turns[turn].units;
    }

    /** The turn of a node, owned or a ghost that an owned one couples to. */
    unsigned int
    turn_of(const unsigned int node) const
    {
      return of_node.empty() ? 0 : of_node[node];
    }

    /** Fetch the ghosts of @p x that have been relaxed in this turn. Collective
     * among neighbours. */
    template <typename Number>
    void
    update_ghosts(const NodeValues<Number> &x, const unsigned int turn) const
    {
      turns[turn].read.update(x);
    }

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    struct Turn
    {
      std::vector<Range> units;
      /** Ghosts that are relaxed in it and read here. */
      SomeGhosts read;
    };
    std::vector<Turn> turns = {Turn()};
    /** For local nodes, or empty if there is but one turn. */
    std::vector<std::uint8_t> of_node;
  };
} // namespace StickSlip

#endif
