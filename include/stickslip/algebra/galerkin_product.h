// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_galerkin_product_h
#define stickslip_algebra_galerkin_product_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/row_exchange.h>
#include <stickslip/algebra/term_matrix.h>
#include <stickslip/algebra/transfer_matrix.h>

namespace StickSlip
{
  /**
   * The products P^T A P of block matrices with one transfer matrix P acting
   * on each component, or T^T A T with T = R_f^T P R_c where nodes have axes of
   * their own. The sparsity of the product and the messages between
   * processes are found once; its values can be computed for all or for some
   * of its rows, so that a local change of A costs only the rows that see it.
   *
   * Each process forms the share of its own rows of A; what belongs to coarse
   * nodes of others is sent to these and added there. Matrices may be in single
   * or double precision; sums are formed in double precision.
   *
   * Masks are of components along the axes of the nodes. The blocks of S A S
   * are turned to the axes of space, multiplied with scalars there, and turned
   * to the axes of the coarse nodes.
   */
  template <int n_components>
  class GalerkinProduct
  {
  public:
    GalerkinProduct() = default;

    /**
     * @param fine_nodes The partition of the nodes of A.
     * @param fine The sparsity of A.
     * @param prolongation The rows of P, one for each local fine node, in
     * global numbers of the coarse nodes.
     * @param owned_coarse The coarse nodes of this process.
     * @param fine_frames The axes of the fine nodes.
     * @param coarse_frames Those of the coarse nodes.
     *
     * Collective.
     */
    GalerkinProduct(const NodePartition            &fine_nodes,
                    const BlockSparsity            &fine,
                    const std::vector<GlobalRow>   &prolongation,
                    const IndexSet                 &owned_coarse,
                    const LocalFrames              &fine_frames   = {},
                    const NodeFrames<n_components> &coarse_frames = {});

    /** The coarse nodes; ghosts are the columns of P and of the product. */
    const NodePartition &
    coarse_nodes() const
    {
      return nodes;
    }

    /** P, with rows for owned and ghost fine nodes, and the axes of nodes. */
    const TransferMatrix &
    prolongation() const
    {
      return transfer;
    }

    /** The axes of the coarse nodes and their ghosts. */
    const LocalFrames &
    coarse_frames() const
    {
      return transfer.column_frames();
    }

    const std::shared_ptr<const BlockSparsity> &
    coarse_sparsity() const
    {
      return sparsity;
    }

    /**
     * All rows of coarse = T^T (S A S) T, where S sets the components masked
     * by @p fine_mask to zero; the mask must hold for ghosts too. A is a
     * BlockMatrix or a TermMatrix. Collective. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    compute(const FineMatrix                        &fine,
            const NodeMask                          &fine_mask,
            BlockMatrix<n_components, CoarseNumber> &coarse);

    /**
     * Choose the rows of compute_selected_rows(), by the local index of the
     * coarse node; ghosts are selected where their owners have them selected.
     * Collective.
     */
    void
    select_rows(const std::vector<bool> &is_selected);

    /** The selected rows of the product only. Collective. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    compute_selected_rows(const FineMatrix                        &fine,
                          const NodeMask                          &fine_mask,
                          BlockMatrix<n_components, CoarseNumber> &coarse);

    /** The coarse rows, in ascending order, to which the given rows of S A S
     * contribute. */
    std::vector<unsigned int>
    rows_from(const std::vector<unsigned int> &fine_rows) const;

    /** The given rows of the product only. On one process. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    compute_rows(const FineMatrix                        &fine,
                 const NodeMask                          &fine_mask,
                 const std::vector<unsigned int>         &coarse_rows,
                 BlockMatrix<n_components, CoarseNumber> &coarse);

    std::size_t
    memory_consumption() const;

  private:
    /** Coarse rows to compute, by local index, and how those of ghosts reach
     * their owners. */
    struct Rows
    {
      std::vector<unsigned int> owned, ghosts;
      RowExchange               exchange;
    };

    Rows
    make_rows(const std::vector<bool> &is_selected) const;

    template <typename FineMatrix, typename CoarseNumber>
    void
    compute(const FineMatrix                        &fine,
            const NodeMask                          &fine_mask,
            const Rows                              &rows,
            BlockMatrix<n_components, CoarseNumber> &coarse);

    /** The share of this process in one coarse row, whose entries are those of
     * @p target in row @p target_row. */
    template <typename FineMatrix, typename TargetNumber>
    void
    compute_row(const FineMatrix    &fine,
                const NodeMask      &fine_mask,
                const unsigned int   row,
                const BlockSparsity &target,
                const unsigned int   target_row,
                TargetNumber        *values);

    /** This share with or without axes of nodes. */
    template <bool with_frames, typename FineMatrix, typename TargetNumber>
    void
    compute_row_with(const FineMatrix    &fine,
                     const NodeMask      &fine_mask,
                     const unsigned int   row,
                     const BlockSparsity &target,
                     const unsigned int   target_row,
                     TargetNumber        *values);

    NodePartition                        nodes;
    TransferMatrix                       transfer;
    std::shared_ptr<const BlockSparsity> sparsity;
    /** The share of this process in the rows of ghosts. */
    BlockSparsity         ghost_sparsity;
    AlignedVector<double> ghost_values;
    Rows                  all, selected;

    /** Work space: P^T A for one coarse row, as a list of fine columns, a row
     * of A, and the row of the product. */
    std::vector<double>       row_values, fine_blocks;
    std::vector<unsigned int> row_columns;
    std::vector<int>          row_position;
    std::vector<unsigned int> coarse_position;
    std::vector<double>       coarse_values;
  };
} // namespace StickSlip

#endif
