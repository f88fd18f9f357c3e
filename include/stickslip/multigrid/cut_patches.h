// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_cut_patches_h
#define stickslip_multigrid_cut_patches_h

#include <stickslip/algebra/row_exchange.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The patches that have nodes of several processes. Each is relaxed by the
   * last of these, which fetches the entries of the matrix that it does not
   * have, one after the other on a process. Processes whose nodes couple take
   * turns: else each would change a volume as if the other did not, and it
   * would be as wrong as before.
   *
   * All functions are collective.
   */
  template <int n_components, typename Number>
  class CutPatches
  {
  public:
    /** None. */
    CutPatches() = default;

    /** The patches among the nodes of a level; @p sparsity is that of its
     * matrix, and the other arguments are as in find_stiff_cells(). */
    CutPatches(const NodePartition &nodes,
               const BlockSparsity &sparsity,
               const NodeMask      &fixed,
               const StiffVolumes  &stiff_volumes);

    /** Return if there are none on any process. */
    bool
    are_empty() const
    {
      return n_turns == 0;
    }

    /** Take over a matrix, of which the @p active components take part. */
    template <typename OtherNumber>
    void
    set_matrix(const BlockMatrix<n_components, OtherNumber> &matrix,
               const NodeMask                               &active);

    /** Relax the patches, from zero. The level's own smoother, which must have
     * patches, knows residuals; @p r is for these. */
    void
    relax_from_zero(
      NodeValues<Number>                           &x,
      NodeValues<Number>                           &r,
      const NodeValues<Number>                     &b,
      const BlockGaussSeidel<n_components, Number> &of_level) const;

    /** Relax the patches, from any x, in this or in reverse order. */
    void
    relax(const bool                                    is_forward,
          NodeValues<Number>                           &x,
          NodeValues<Number>                           &r,
          const NodeValues<Number>                     &b,
          const BlockGaussSeidel<n_components, Number> &of_level) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    /** Find the order in which processes act. */
    void
    find_turns(const NodePartition &nodes, const BlockSparsity &level_sparsity);

    /** The turn of number @p turn, for a residual whose ghosts are not current.
     */
    void
    take_turn(const unsigned int        turn,
              const bool                is_forward,
              NodeValues<Number>       &x,
              const NodeValues<Number> &r) const;

    /** The residual in the rows that are members here or elsewhere. */
    void
    find_residual(const NodeValues<Number>                     &x,
                  NodeValues<Number>                           &r,
                  const NodeValues<Number>                     &b,
                  const BlockGaussSeidel<n_components, Number> &of_level) const;

    /** Turns of all processes, none if there are no such patches, and that of
     * this one. */
    unsigned int n_turns = 0, own_turn = 0;

    /** Nodes of the patches of this process by local index on the level,
     * ascending, and the couplings between them, by their places here. */
    std::vector<unsigned int>            members;
    std::shared_ptr<const BlockSparsity> sparsity;
    /** The place of an entry: a position in the matrix on the level or among
     * the fetched entries. */
    struct Source
    {
      unsigned int position;
      bool         is_fetched, is_transposed;
    };
    /** One for each coupling. */
    std::vector<Source> sources;

    /** Owned nodes that are members on any process. */
    std::vector<unsigned int> members_anywhere;

    RowExchange           exchange;
    AlignedVector<double> fetched;

    BlockGaussSeidel<n_components, Number> smoother;
    mutable NodeValues<Number>             rhs, solution, change;
  };
} // namespace StickSlip

#endif
