// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_block_matrix_h
#define stickslip_algebra_block_matrix_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/tensor.h>

#include <stickslip/algebra/block_kernels.h>
#include <stickslip/algebra/node_partition.h>

#include <memory>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The couplings between nodes: for each owned row the local indices of its
   * columns in ascending order. Every row holds its diagonal.
   */
  struct BlockSparsity
  {
    std::vector<unsigned int> row_start = {0};
    std::vector<unsigned int> column;
    /** Position of each row's diagonal entry. */
    std::vector<unsigned int> diagonal;

    BlockSparsity() = default;

    /** The sparsity with these sorted or unsorted lists of columns; the
     * diagonal is added. */
    explicit BlockSparsity(std::vector<std::vector<unsigned int>> rows);

    unsigned int
    n_rows() const;

    std::size_t
    n_entries() const
    {
      return column.size();
    }

    /** Position of the entry (row, column); it must exist. */
    unsigned int
    position(const unsigned int row, const unsigned int column) const;

    /** The columns of some rows, these themselves among them, in ascending
     * order. */
    std::vector<unsigned int>
    coupled_to(const std::vector<unsigned int> &rows) const;

    std::size_t
    memory_consumption() const;
  };

  /**
   * A square matrix over the nodes of a level, with square blocks of
   * n_components rows (1, 2 or 3): rows of the owned nodes, columns of owned
   * and ghost nodes. Matrices in single precision serve as preconditioners;
   * their entries are read and written as double.
   */
  template <int n_components, typename Number = double>
  class BlockMatrix
  {
  public:
    static constexpr unsigned int block_size = n_components * n_components;

    BlockMatrix() = default;

    explicit BlockMatrix(const std::shared_ptr<const BlockSparsity> &sparsity);

    const BlockSparsity &
    sparsity() const
    {
      return *pattern;
    }

    const std::shared_ptr<const BlockSparsity> &
    shared_sparsity() const
    {
      return pattern;
    }

    unsigned int
    n_rows() const;

    /** The block of the entry at a position, row by row. */
    Number *
    block(const unsigned int position)
    {
      return entries.data() + std::size_t(position) * block_size;
    }

    const Number *
    block(const unsigned int position) const
    {
      return entries.data() + std::size_t(position) * block_size;
    }

    /** The block at a position of a row, as TermMatrix has it. */
    Tensor<2, n_components>
    entry(const unsigned int /*row*/, const unsigned int position) const
    {
      const Number           *values = block(position);
      Tensor<2, n_components> result;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          result[c][d] = values[c * n_components + d];
      return result;
    }

    Tensor<2, n_components>
    diagonal_block(const unsigned int row) const
    {
      return entry(row, pattern->diagonal[row]);
    }

    void
    set_diagonal_block(const unsigned int             row,
                       const Tensor<2, n_components> &value);

    AlignedVector<Number> &
    values();

    const AlignedVector<Number> &
    values() const
    {
      return entries;
    }

    Kernels::BlockRows<Number>
    rows() const;

    /** The blocks of a row one after the other, as TermMatrix has them. */
    const Number *
    row(const unsigned int i, std::vector<double> & /*buffer*/) const
    {
      return block(pattern->row_start[i]);
    }

    /** y = A x. Collective among neighbours, like the next. */
    void
    vmult(NodeValues<Number> &y, const NodeValues<Number> &x) const;

    /** r = b - A x. */
    void
    residual(NodeValues<Number>       &r,
             const NodeValues<Number> &b,
             const NodeValues<Number> &x) const;

    /** r -= A e for an owned node's @p values in e and zeros elsewhere, where A
     * is symmetric: ghosts in r get their parts, to be sent to their owners. */
    void
    subtract_column(const unsigned int             node,
                    const Tensor<1, n_components> &values,
                    NodeValues<Number>            &r) const;

    /** The rows begin <= i < end of this matrix become those of a sum of
     * matrices times coefficients; all share one sparsity. */
    void
    combine(const std::vector<std::pair<double, const BlockMatrix *>> &terms,
            const unsigned int                                         begin,
            const unsigned int                                         end);

    /** Bytes of the values; the sparsity is shared. */
    std::size_t
    memory_consumption() const;

  private:
    std::shared_ptr<const BlockSparsity> pattern;
    AlignedVector<Number>                entries;
  };
} // namespace StickSlip

#endif
