// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_middle_nodes_h
#define stickslip_multigrid_middle_nodes_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/row_exchange.h>
#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/multigrid/volume_cells.h>

#include <vector>

namespace StickSlip
{
  /**
   * The nodes in the middle of coarse cells that a prolongation moves to where
   * they take the least energy, and what that changes in it and in Galerkin
   * products.
   *
   * A bilinear field that keeps the volume of a coarse cell of quadrilaterals
   * does not keep those of the four cells in it: they differ along both axes.
   * The two components of the node in the middle are what it takes to make
   * them equal. So without it coarse levels lock where a body is nearly
   * incompressible (Schoeberl 1999 has the general case).
   *
   * With T the transfer, of components of nodes, the row of a middle node m,
   * which couples to no other one, becomes
   *
   *   T_m + C_m ,   C_m = -A_mm^-1 (A T)_m   on the columns of T_m,
   *
   * where A is the matrix in which the volume of the node is stiffest. It stays
   * for all combinations of the matrices, and where components are truncated.
   * A process has its own middle nodes, which may be interpolated from coarse
   * nodes of others.
   */
  template <int n_components>
  class MiddleNodes
  {
  public:
    /** None. */
    MiddleNodes() = default;

    /** Middle nodes among those with @p stiff_volumes in these @p matrices that
     * are not nonsmooth; masked are only @p fixed components. The coarse nodes
     * and the sparsity are those of the product. Collective, as are all
     * functions but memory_consumption(). */
    template <typename Matrix>
    MiddleNodes(const TransferMatrix            &transfer,
                const NodePartition             &coarse_nodes,
                const BlockSparsity             &coarse_sparsity,
                const std::vector<Matrix>       &matrices,
                const StiffVolumes              &stiff_volumes,
                const NodeMask                  &fixed,
                const std::vector<unsigned int> &nonsmooth_nodes);

    /** fine += C coarse, of which the ghosts are current. */
    template <typename Number>
    void
    prolongate_add(NodeValues<Number>       &fine,
                   const NodeValues<Number> &coarse) const;

    /** coarse += C^T fine; ghosts of it are zero before and after. */
    template <typename Number>
    void
    restrict_add(NodeValues<Number>       &coarse,
                 const NodeValues<Number> &fine) const;

    /** Add to all rows of the product T^T S A S T what T + C makes of it, where
     * S sets the components masked by @p mask to zero. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    add_to_product(const TransferMatrix                    &transfer,
                   const FineMatrix                        &fine,
                   const NodeMask                          &mask,
                   BlockMatrix<n_components, CoarseNumber> &coarse);

    /** Select rows of the product, by local index, for ghosts as their owners
     * have it. */
    void
    select_rows(const NodePartition     &coarse_nodes,
                const BlockSparsity     &coarse_sparsity,
                const std::vector<bool> &is_selected);

    /** Add this to the selected rows of the product only. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    add_to_selected_rows(const TransferMatrix                    &transfer,
                         const FineMatrix                        &fine,
                         const NodeMask                          &mask,
                         BlockMatrix<n_components, CoarseNumber> &coarse);

    /** Add this to some rows of the product only; for one process. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    add_to_rows(const TransferMatrix                    &transfer,
                const FineMatrix                        &fine,
                const NodeMask                          &mask,
                const std::vector<unsigned int>         &rows,
                BlockMatrix<n_components, CoarseNumber> &coarse);

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    using Block = Tensor<2, n_components>;

    /** A row of blocks. */
    using BlockRow = std::vector<std::pair<unsigned int, Block>>;

    /** (A S T)_i, ascending by column. */
    template <typename Matrix>
    static BlockRow
    product_row(const TransferMatrix &transfer,
                const Matrix         &matrix,
                const NodeMask       &mask,
                const unsigned int    i);

    /** Add the share of the middle node of number @p k, in the rows that @p
     * is_selected, or in all of them if that is empty. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    add_share(const unsigned int                       k,
              const TransferMatrix                    &transfer,
              const FineMatrix                        &fine,
              const NodeMask                          &mask,
              const std::vector<bool>                 &is_selected,
              BlockMatrix<n_components, CoarseNumber> &coarse);

    /** Find the entries of the product in rows of other processes that middle
     * nodes with these rows of A T have a share in. */
    void
    find_ghost_rows(const NodePartition         &coarse_nodes,
                    const BlockSparsity         &coarse_sparsity,
                    const std::vector<BlockRow> &products);

    std::vector<unsigned int> nodes;
    /** C, row by row. */
    std::vector<unsigned int> row_start = {0};
    std::vector<unsigned int> column;
    std::vector<Block>        block;
    /** Shares in rows of other processes, row by row of the ghosts, and their
     * way there, for all rows and for the selected ones. */
    bool                  is_exchanged = false;
    BlockSparsity         ghost_sparsity;
    AlignedVector<double> ghost_values;
    RowExchange           exchange, exchange_of_selected;
    std::vector<bool>     selected;
    /** The nodes with a share in a selected row. */
    std::vector<unsigned int> with_selected;
    /** By coarse node: numbers of the middle nodes with a share in its row. */
    std::vector<unsigned int> first_share;
    std::vector<unsigned int> share;
  };
} // namespace StickSlip

#endif
