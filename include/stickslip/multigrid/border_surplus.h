// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_border_surplus_h
#define stickslip_multigrid_border_surplus_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/tensor.h>

#include <stickslip/algebra/block_matrix.h>

#include <vector>

namespace StickSlip
{
  /**
   * A part S of the diagonal by which Gauss-Seidel relaxes more cautiously at
   * nodes that couple to those of other processes. All processes relax at the
   * same time, and the cycle stays a positive definite preconditioner if
   * D + 2 S - C is positive definite, where D are the diagonal blocks and C the
   * couplings between processes; without S it is not in three dimensions where
   * cells are twice as wide as thick and the borders are level.
   *
   * S_i = s_i D_i, with s_i = max(0, rho_i - 1) / 2 and rho_i the sum of the
   * 2-norms of D_i^{-1} C_ij, by which the theorem of Gershgorin bounds
   * D^{-1} C. A larger S, up to that of the l1 smoother, takes more iterations.
   * Lines of nodes have diagonal blocks that are weak for what is constant
   * along them: rho_i is the 2-norm of the sum of D_i^{-1} C_ij then, and 0.2
   * is there in place of 1, which measurements have shown to be best.
   *
   * A. H. Baker, R. D. Falgout, T. V. Kolev and U. M. Yang, Multigrid smoothers
   * for ultraparallel computing, SIAM J. Sci. Comput. 33 (2011).
   */
  template <int n_components, typename Number>
  class BorderSurplus
  {
  public:
    /** None. */
    BorderSurplus() = default;

    /** None yet in the rows that couple to ghosts. */
    BorderSurplus(const BlockSparsity &sparsity, const bool has_lines);

    bool
    is_empty() const
    {
      return rows.empty();
    }

    bool
    has_row(const unsigned int i) const;

    /** Set that of a row from its diagonal block, the inverse of this, which
     * may leave out components, and the couplings to ghosts; return 1 + s_i. */
    double
    set(const unsigned int                          i,
        const Tensor<2, n_components>              &block,
        const Tensor<2, n_components>              &inverse,
        const std::vector<Tensor<2, n_components>> &couplings);

    /** r += S x, of owned nodes. */
    void
    add_product(const Number *x, Number *r) const;

    /** b + S x in the @p n_values entries of owned nodes, which is b itself if
     * there is no S. */
    const Number *
    shifted(const Number *b, const Number *x, const std::size_t n_values) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    bool                      has_lines = false;
    std::vector<unsigned int> rows;
    /** One after the other, row by row. */
    AlignedVector<Number>         blocks;
    mutable AlignedVector<Number> right_hand_side;
  };
} // namespace StickSlip

#endif
