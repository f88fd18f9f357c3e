// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_middle_nodes_h
#define stickslip_multigrid_middle_nodes_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
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
   * All is local: middle nodes are those that couple to own nodes and are
   * interpolated from own coarse nodes only.
   */
  template <int n_components>
  class MiddleNodes
  {
  public:
    /** None. */
    MiddleNodes() = default;

    /** Middle nodes among those with @p stiff_volumes in these @p matrices that
     * are not nonsmooth; masked are only @p fixed components. @p n_coarse:
     * number of owned coarse nodes. */
    template <typename Matrix>
    MiddleNodes(const TransferMatrix            &transfer,
                const unsigned int               n_coarse,
                const std::vector<Matrix>       &matrices,
                const StiffVolumes              &stiff_volumes,
                const NodeMask                  &fixed,
                const std::vector<unsigned int> &nonsmooth_nodes);

    /** fine += C coarse. */
    template <typename Number>
    void
    prolongate_add(NodeValues<Number>       &fine,
                   const NodeValues<Number> &coarse) const;

    /** coarse += C^T fine. */
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
                   BlockMatrix<n_components, CoarseNumber> &coarse) const;

    /** Add this to some rows of the product only. */
    template <typename FineMatrix, typename CoarseNumber>
    void
    add_to_rows(const TransferMatrix                    &transfer,
                const FineMatrix                        &fine,
                const NodeMask                          &mask,
                const std::vector<unsigned int>         &rows,
                BlockMatrix<n_components, CoarseNumber> &coarse) const;

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
              BlockMatrix<n_components, CoarseNumber> &coarse) const;

    std::vector<unsigned int> nodes;
    /** C, row by row. */
    std::vector<unsigned int> row_start = {0};
    std::vector<unsigned int> column;
    std::vector<Block>        block;
    /** By coarse node: numbers of the middle nodes with a share in its row. */
    std::vector<unsigned int> first_share;
    std::vector<unsigned int> share;
  };
} // namespace StickSlip

#endif
