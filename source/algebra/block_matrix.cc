// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/base/large_pages.h>
#include <stickslip/base/make_set.h>

#include <algorithm>
#include <array>

namespace StickSlip
{
  BlockSparsity::BlockSparsity(std::vector<std::vector<unsigned int>> rows)
  {
    std::size_t n_entries = 0;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        rows[i].push_back(i);
        make_set(rows[i]);
        n_entries += rows[i].size();
      }
    row_start.reserve(rows.size() + 1);
    diagonal.reserve(rows.size());
    column.reserve(n_entries);
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const auto own = std::lower_bound(rows[i].begin(), rows[i].end(), i);
        diagonal.push_back(column.size() + (own - rows[i].begin()));
        column.insert(column.end(), rows[i].begin(), rows[i].end());
        row_start.push_back(column.size());
        // Memory of the lists is as large as that of the columns.
        std::vector<unsigned int>().swap(rows[i]);
      }
  }



  std::vector<unsigned int>
  BlockSparsity::coupled_to(const std::vector<unsigned int> &rows) const
  {
    // The diagonal belongs to each row.
    return columns_of_rows(row_start, column, rows);
  }



  unsigned int
  BlockSparsity::n_rows() const
  {
    return row_start.size() - 1;
  }



  unsigned int
  BlockSparsity::position(const unsigned int row, const unsigned int col) const
  {
    const auto begin = column.begin() + row_start[row];
    const auto end   = column.begin() + row_start[row + 1];
    const auto entry = std::lower_bound(begin, end, col);
    Assert(entry != end && *entry == col,
           ExcMessage("The sparsity pattern has no such entry."));
    return entry - column.begin();
  }



  std::size_t
  BlockSparsity::memory_consumption() const
  {
    return sizeof(unsigned int) *
           (row_start.capacity() + column.capacity() + diagonal.capacity());
  }



  template <int n_components, typename Number>
  BlockMatrix<n_components, Number>::BlockMatrix(
    const std::shared_ptr<const BlockSparsity> &sparsity)
    : pattern(sparsity)
  {
    const std::size_t n = sparsity->n_entries() * block_size;
    reserve_on_large_pages(n, entries);
    entries.resize(n);
  }



  template <int n_components, typename Number>
  unsigned int
  BlockMatrix<n_components, Number>::n_rows() const
  {
    return pattern->n_rows();
  }



  template <int n_components, typename Number>
  void
  BlockMatrix<n_components, Number>::set_diagonal_block(
    const unsigned int             row,
    const Tensor<2, n_components> &value)
  {
    Number *values = block(pattern->diagonal[row]);
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        values[c * n_components + d] = value[c][d];
  }



  template <int n_components, typename Number>
  AlignedVector<Number> &
  BlockMatrix<n_components, Number>::values()
  {
    return entries;
  }



  template <int n_components, typename Number>
  Kernels::BlockRows<Number>
  BlockMatrix<n_components, Number>::rows() const
  {
    return {pattern->row_start.data(), pattern->column.data(), entries.data()};
  }



  template <int n_components, typename Number>
  void
  BlockMatrix<n_components, Number>::vmult(NodeValues<Number>       &y,
                                           const NodeValues<Number> &x) const
  {
    update_ghosts(x);
    Kernels::vmult<n_components>(rows(), 0, n_rows(), x.begin(), y.begin());
  }



  template <int n_components, typename Number>
  void
  BlockMatrix<n_components, Number>::residual(NodeValues<Number>       &r,
                                              const NodeValues<Number> &b,
                                              const NodeValues<Number> &x) const
  {
    update_ghosts(x);
    Kernels::residual<n_components>(
      rows(), 0, n_rows(), b.begin(), x.begin(), r.begin());
  }



  template <int n_components, typename Number>
  void
  BlockMatrix<n_components, Number>::subtract_column(
    const unsigned int             node,
    const Tensor<1, n_components> &values,
    NodeValues<Number>            &r) const
  {
    // Copies, since a result may be one of the values for all the compiler
    // knows.
    const Tensor<1, n_components> v        = values;
    Number *const                 residual = r.begin();
    const unsigned int            end      = pattern->row_start[node + 1];
    for (unsigned int p = pattern->row_start[node]; p < end; ++p)
      {
        const Number *A = block(p);
        Number       *target =
          residual + std::size_t(pattern->column[p]) * n_components;
        std::array<Number, n_components> sum;
        for (unsigned int d = 0; d < n_components; ++d)
          sum[d] = target[d];
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            sum[d] -= A[c * n_components + d] * v[c];
        for (unsigned int d = 0; d < n_components; ++d)
          target[d] = sum[d];
      }
  }



  template <int n_components, typename Number>
  void
  BlockMatrix<n_components, Number>::combine(
    const std::vector<std::pair<double, const BlockMatrix *>> &terms,
    const unsigned int                                         begin,
    const unsigned int                                         end)
  {
    const std::size_t first = std::size_t(pattern->row_start[begin]),
                      last  = std::size_t(pattern->row_start[end]);
    std::vector<double>         coefficients;
    std::vector<const Number *> pointers;
    for (const auto &[coefficient, term] : terms)
      {
        Assert(term->pattern == pattern,
               ExcMessage("Matrices of one family share their sparsity."));
        coefficients.push_back(coefficient);
        pointers.push_back(term->block(first));
      }
    Kernels::linear_combination(terms.size(),
                                coefficients.data(),
                                pointers.data(),
                                (last - first) * block_size,
                                block(first));
  }



  template <int n_components, typename Number>
  std::size_t
  BlockMatrix<n_components, Number>::memory_consumption() const
  {
    return sizeof(Number) * entries.size();
  }



  template class BlockMatrix<1, double>;
  template class BlockMatrix<2, double>;
  template class BlockMatrix<3, double>;
  template class BlockMatrix<1, float>;
  template class BlockMatrix<2, float>;
  template class BlockMatrix<3, float>;
} // namespace StickSlip
