// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_galerkin_product_h
#define stickslip_algebra_galerkin_product_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/transfer_matrix.h>

namespace StickSlip
{
  /**
   * The products P^T A P of block matrices with one transfer matrix P acting
   * on each component. The sparsity of the product is found once; its values
   * can be computed for all or for some of its rows, so that a change of A
   * near the faults costs only the rows that see it.
   */
  template <int dim>
  class GalerkinProduct
  {
  public:
    GalerkinProduct() = default;

    /** The transfer matrix must outlive this object. */
    GalerkinProduct(const TransferMatrix &transfer, const BlockSparsity &fine);

    const std::shared_ptr<const BlockSparsity> &
    coarse_sparsity() const;

    /**
     * All rows of coarse = P^T (S A S) P, where S sets the components masked
     * by @p fine_mask to zero.
     */
    void
    compute(const BlockMatrix<dim> &fine,
            const NodeMask         &fine_mask,
            BlockMatrix<dim>       &coarse);

    /** The same for the given rows of the coarse matrix only. */
    void
    compute_rows(const BlockMatrix<dim>          &fine,
                 const NodeMask                  &fine_mask,
                 const std::vector<unsigned int> &coarse_rows,
                 BlockMatrix<dim>                &coarse);

  private:
    void
    compute_row(const BlockMatrix<dim> &fine,
                const NodeMask         &fine_mask,
                const unsigned int      row,
                BlockMatrix<dim>       &coarse);

    const TransferMatrix                *transfer = nullptr;
    std::shared_ptr<const BlockSparsity> sparsity;

    /** Work space: P^T A for one coarse row, as a list of fine columns. */
    std::vector<double>       row_values;
    std::vector<unsigned int> row_columns;
    std::vector<int>          row_position;
    std::vector<unsigned int> coarse_position;
  };
} // namespace StickSlip

#endif
