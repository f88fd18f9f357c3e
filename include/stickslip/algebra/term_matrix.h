// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_term_matrix_h
#define stickslip_algebra_term_matrix_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/symmetric_kernels.h>

#include <vector>

namespace StickSlip
{
  /**
   * A term of an operator: a block matrix that does not change, stored in one
   * of three ways.
   *
   * - As it is.
   * - Symmetric: the diagonal and what is above it, half of the memory. Columns
   *   of ghosts lie behind all others, so that these are whole.
   * - Compact: one number in place of each block in rows whose blocks are all
   *   multiples of the identity. A mass matrix in the jump basis has such rows
   *   alone, but next to nodes with axes of their own.
   */
  template <int n_components>
  class TermMatrix
  {
  public:
    static constexpr unsigned int block_size = n_components * n_components;

    /** No matrix. */
    TermMatrix() = default;

    /** Stored as it is. */
    TermMatrix(BlockMatrix<n_components> matrix);

    /** Symmetric; what @p matrix has below the diagonal is not looked at. */
    static TermMatrix
    symmetric(const BlockMatrix<n_components> &matrix);

    /** Compact; blocks of one component are numbers anyway. */
    static TermMatrix
    compact(const BlockMatrix<n_components> &matrix);

    /** Compact; each block is the identity times a number. */
    static TermMatrix
    of_numbers(BlockMatrix<1> numbers);

    const BlockSparsity &
    sparsity() const
    {
      return *shared_sparsity();
    }

    const std::shared_ptr<const BlockSparsity> &
    shared_sparsity() const
    {
      return pattern;
    }

    unsigned int
    n_rows() const
    {
      return sparsity().n_rows();
    }

    /** True if rows are stored with one number a block. */
    bool
    is_compact() const
    {
      return numbers.shared_sparsity() != nullptr;
    }

    /** True if the diagonal and what is above it are stored. */
    bool
    is_symmetric() const
    {
      return !upper_start.empty();
    }

    /** All blocks, as a matrix of its own. */
    BlockMatrix<n_components>
    block_matrix() const;

    /** The block at a position of a row. */
    Tensor<2, n_components>
    entry(const unsigned int row, const unsigned int position) const;

    Tensor<2, n_components>
    diagonal_block(const unsigned int row) const
    {
      return entry(row, sparsity().diagonal[row]);
    }

    /** The blocks of a row one after the other, as BlockMatrix has them;
     * @p buffer is where they are written to if they are not stored. */
    const double *
    row(const unsigned int i, std::vector<double> &buffer) const;

    /** y = A x. Collective among neighbours, like the next. */
    void
    vmult(NodalVector &y, const NodalVector &x) const;

    /** r = b - A x. */
    void
    residual(NodalVector &r, const NodalVector &b, const NodalVector &x) const;

    /** x . A x over all processes; the matrix is symmetric. Collective. */
    double
    quadratic_form(const NodalVector &x) const;

    /** The rows begin <= i < end of @p target become those of
     * sum_k coefficients[k] * terms[k]; all share one sparsity. */
    static void
    combine(const std::vector<double>     &coefficients,
            const std::vector<TermMatrix> &terms,
            const unsigned int             begin,
            const unsigned int             end,
            BlockMatrix<n_components>     &target);

    /** Bytes of the values; the sparsity is shared. */
    std::size_t
    memory_consumption() const;

  private:
    /** The blocks of a row that is stored with them in a compact matrix; null
     * for other rows. */
    const double *
    stored_blocks(const unsigned int i) const;

    /** The block at a position of a row of a symmetric matrix, from the
     * diagonal on, or the one opposite to it, below the diagonal. */
    const double *
    upper_block(const unsigned int i, const unsigned int position) const
    {
      return upper.data() + block_size * std::size_t(upper_start[i] + position -
                                                     pattern->diagonal[i]);
    }
    const double *
    opposite_block(const unsigned int i, const unsigned int position) const
    {
      return upper.data() +
             block_size * std::size_t(mirror[position - upper_start[i]]);
    }

    /** Call @p action(k, block, is_transposed) for the positions @p k of a row
     * of a symmetric matrix. */
    template <typename Action>
    void
    for_each_block(const unsigned int i, const Action &action) const;

    /** A symmetric matrix for the kernels. */
    Kernels::UpperTriangle
    upper_triangle() const
    {
      return {n_rows(),
              pattern->row_start.data(),
              pattern->diagonal.data(),
              pattern->column.data(),
              upper.data()};
    }

    std::shared_ptr<const BlockSparsity> pattern;

    /** If stored as it is. */
    BlockMatrix<n_components> blocks;

    /** If symmetric: the blocks from the diagonal on, row by row, which of them
     * is the first of each row, and which is on the other side of each entry
     * below the diagonal, row by row. */
    AlignedVector<double>     upper;
    std::vector<unsigned int> upper_start, mirror;

    /** If compact: a number for each block, zero in rows with blocks; these
     * rows, ascending, the positions of their first entries and their blocks.
     */
    BlockMatrix<1>            numbers;
    std::vector<unsigned int> rows_with_blocks;
    std::vector<std::size_t>  first_block;
    std::vector<double>       blocks_of_rows;
  };
} // namespace StickSlip

#endif
