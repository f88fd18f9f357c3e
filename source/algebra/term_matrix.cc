// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/term_matrix.h>
#include <stickslip/base/large_pages.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** True if all blocks of a row are multiples of the identity, to the last
     * bit. */
    template <int n_components>
    bool
    has_multiples_of_identity(const BlockMatrix<n_components> &matrix,
                              const unsigned int               row)
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      for (unsigned int k = sparsity.row_start[row];
           k < sparsity.row_start[row + 1];
           ++k)
        {
          const double *block = matrix.block(k);
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              if (block[c * n_components + d] != (c == d ? block[0] : 0.))
                return false;
        }
      return true;
    }
  } // namespace



  template <int n_components>
  TermMatrix<n_components>::TermMatrix(BlockMatrix<n_components> matrix)
    : pattern(matrix.shared_sparsity())
    , blocks(std::move(matrix))
  {}



  template <int n_components>
  TermMatrix<n_components>
  TermMatrix<n_components>::symmetric(const BlockMatrix<n_components> &matrix)
  {
    const BlockSparsity &sparsity = matrix.sparsity();
    TermMatrix           result;
    result.pattern = matrix.shared_sparsity();
    result.upper_start.reserve(matrix.n_rows() + 1);
    result.upper_start.push_back(0);
    for (unsigned int i = 0; i < matrix.n_rows(); ++i)
      result.upper_start.push_back(result.upper_start.back() +
                                   sparsity.row_start[i + 1] -
                                   sparsity.diagonal[i]);
    const std::size_t n_upper =
      std::size_t(result.upper_start.back()) * block_size;
    reserve_on_large_pages(n_upper, result.upper);
    result.upper.resize_fast(n_upper);
    result.mirror.reserve(sparsity.n_entries() - result.upper_start.back());
    for (unsigned int i = 0; i < matrix.n_rows(); ++i)
      {
        std::copy(matrix.block(sparsity.diagonal[i]),
                  matrix.block(sparsity.row_start[i + 1]),
                  result.upper.data() +
                    std::size_t(result.upper_start[i]) * block_size);
        for (unsigned int k = sparsity.row_start[i]; k < sparsity.diagonal[i];
             ++k)
          {
            const unsigned int j = sparsity.column[k];
            result.mirror.push_back(result.upper_start[j] +
                                    sparsity.position(j, i) -
                                    sparsity.diagonal[j]);
          }
      }
    return result;
  }



  template <int n_components>
  template <typename Action>
  void
  TermMatrix<n_components>::for_each_block(const unsigned int i,
                                           const Action      &action) const
  {
    const unsigned int diagonal = pattern->diagonal[i];
    for (unsigned int k = pattern->row_start[i]; k < diagonal; ++k)
      action(k, opposite_block(i, k), true);
    for (unsigned int k = diagonal; k < pattern->row_start[i + 1]; ++k)
      action(k, upper_block(i, k), false);
  }



  template <int n_components>
  TermMatrix<n_components>
  TermMatrix<n_components>::compact(const BlockMatrix<n_components> &matrix)
  {
    if (n_components == 1)
      return matrix;
    const BlockSparsity &sparsity = matrix.sparsity();
    BlockMatrix<1>       numbers(matrix.shared_sparsity());
    TermMatrix           result;
    std::size_t          n_stored = 0;
    for (unsigned int i = 0; i < matrix.n_rows(); ++i)
      {
        const unsigned int begin = sparsity.row_start[i],
                           end   = sparsity.row_start[i + 1];
        if (has_multiples_of_identity(matrix, i))
          for (unsigned int k = begin; k < end; ++k)
            *numbers.block(k) = *matrix.block(k);
        else
          {
            result.rows_with_blocks.push_back(i);
            result.first_block.push_back(n_stored);
            n_stored += std::size_t(end - begin) * block_size;
          }
      }
    result.blocks_of_rows.reserve(n_stored);
    for (const unsigned int i : result.rows_with_blocks)
      result.blocks_of_rows.insert(result.blocks_of_rows.end(),
                                   matrix.block(sparsity.row_start[i]),
                                   matrix.block(sparsity.row_start[i + 1]));
    result.pattern = matrix.shared_sparsity();
    result.numbers = std::move(numbers);
    return result;
  }



  template <int n_components>
  TermMatrix<n_components>
  TermMatrix<n_components>::of_numbers(BlockMatrix<1> numbers)
  {
    TermMatrix result;
    result.pattern = numbers.shared_sparsity();
    if constexpr (n_components == 1)
      result.blocks = std::move(numbers);
    else
      result.numbers = std::move(numbers);
    return result;
  }



  template <int n_components>
  BlockMatrix<n_components>
  TermMatrix<n_components>::block_matrix() const
  {
    BlockMatrix<n_components> result(pattern);
    std::vector<double>       buffer;
    for (unsigned int i = 0; i < n_rows(); ++i)
      {
        const double *blocks_of_row = row(i, buffer);
        double       *target        = result.block(pattern->row_start[i]);
        std::copy_n(blocks_of_row,
                    result.block(pattern->row_start[i + 1]) - target,
                    target);
      }
    return result;
  }



  template <int n_components>
  const double *
  TermMatrix<n_components>::stored_blocks(const unsigned int i) const
  {
    const auto found =
      std::lower_bound(rows_with_blocks.begin(), rows_with_blocks.end(), i);
    return found == rows_with_blocks.end() || *found != i ?
             nullptr :
             blocks_of_rows.data() +
               first_block[found - rows_with_blocks.begin()];
  }



  template <int n_components>
  Tensor<2, n_components>
  TermMatrix<n_components>::entry(const unsigned int row,
                                  const unsigned int position) const
  {
    Tensor<2, n_components> result;
    if (is_symmetric())
      {
        const bool    is_lower = position < pattern->diagonal[row];
        const double *block =
          is_lower ? opposite_block(row, position) : upper_block(row, position);
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            result[c][d] = is_lower ? block[d * n_components + c] :
                                      block[c * n_components + d];
        return result;
      }
    if (!is_compact())
      return blocks.entry(row, position);
    if (const double *stored = stored_blocks(row))
      {
        const double *block =
          stored +
          std::size_t(position - sparsity().row_start[row]) * block_size;
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            result[c][d] = block[c * n_components + d];
      }
    else
      for (unsigned int c = 0; c < n_components; ++c)
        result[c][c] = *numbers.block(position);
    return result;
  }



  template <int n_components>
  const double *
  TermMatrix<n_components>::row(const unsigned int   i,
                                std::vector<double> &buffer) const
  {
    const unsigned int begin = sparsity().row_start[i],
                       end   = sparsity().row_start[i + 1];
    if (is_symmetric())
      {
        buffer.resize(std::size_t(end - begin) * block_size);
        double *target = buffer.data();
        for_each_block(i,
                       [&](const unsigned int,
                           const double *block,
                           const bool    is_transposed) {
                         for (unsigned int c = 0; c < n_components; ++c)
                           for (unsigned int d = 0; d < n_components; ++d)
                             *target++ = is_transposed ?
                                           block[d * n_components + c] :
                                           block[c * n_components + d];
                       });
        return buffer.data();
      }
    if (!is_compact())
      return blocks.block(begin);
    if (const double *stored = stored_blocks(i))
      return stored;
    buffer.assign(std::size_t(end - begin) * block_size, 0.);
    double *block = buffer.data();
    for (unsigned int k = begin; k < end; ++k, block += block_size)
      for (unsigned int c = 0; c < n_components; ++c)
        block[c * (n_components + 1)] = *numbers.block(k);
    return buffer.data();
  }



  template <int n_components>
  double
  TermMatrix<n_components>::quadratic_form(const NodalVector &x) const
  {
    AssertThrow(is_symmetric(), ExcMessage("The matrix is not symmetric."));
    update_ghosts(x);
    return Utilities::MPI::sum(
      Kernels::quadratic_form<n_components>(upper_triangle(), x.begin()),
      x.get_mpi_communicator());
  }



  template <int n_components>
  void
  TermMatrix<n_components>::vmult(NodalVector &y, const NodalVector &x) const
  {
    if (is_symmetric())
      {
        update_ghosts(x);
        Kernels::symmetric_vmult<n_components>(upper_triangle(),
                                               x.begin(),
                                               y.begin());
        return;
      }
    if (!is_compact())
      {
        blocks.vmult(y, x);
        return;
      }
    update_ghosts(x);
    Kernels::vmult_by_numbers<n_components>(numbers.rows(),
                                            n_rows(),
                                            x.begin(),
                                            y.begin());
    for (unsigned int k = 0; k < rows_with_blocks.size(); ++k)
      {
        const unsigned int i     = rows_with_blocks[k];
        const double      *block = blocks_of_rows.data() + first_block[k];
        for (unsigned int m = pattern->row_start[i];
             m < pattern->row_start[i + 1];
             ++m, block += block_size)
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              y.begin()[i * n_components + c] +=
                block[c * n_components + d] *
                x.begin()[pattern->column[m] * n_components + d];
      }
  }



  template <int n_components>
  void
  TermMatrix<n_components>::residual(NodalVector       &r,
                                     const NodalVector &b,
                                     const NodalVector &x) const
  {
    if (!is_compact() && !is_symmetric())
      {
        blocks.residual(r, b, x);
        return;
      }
    vmult(r, x);
    const unsigned int n = n_rows() * n_components;
    for (unsigned int i = 0; i < n; ++i)
      r.begin()[i] = b.begin()[i] - r.begin()[i];
  }



  template <int n_components>
  void
  TermMatrix<n_components>::combine(const std::vector<double>     &coefficients,
                                    const std::vector<TermMatrix> &terms,
                                    const unsigned int             begin,
                                    const unsigned int             end,
                                    BlockMatrix<n_components>     &target)
  {
    AssertDimension(coefficients.size(), terms.size());
    std::vector<std::pair<double, const BlockMatrix<n_components> *>> stored;
    for (unsigned int t = 0; t < terms.size(); ++t)
      if (!terms[t].is_compact() && !terms[t].is_symmetric())
        stored.emplace_back(coefficients[t], &terms[t].blocks);
    target.combine(stored, begin, end);
    const BlockSparsity &pattern = target.sparsity();
    for (unsigned int t = 0; t < terms.size(); ++t)
      {
        const TermMatrix &term = terms[t];
        const double      a    = coefficients[t];
        if (term.is_symmetric())
          for (unsigned int i = begin; i < end; ++i)
            term.for_each_block(
              i,
              [&](const unsigned int k,
                  const double      *block,
                  const bool         is_transposed) {
                double *sum = target.block(k);
                for (unsigned int c = 0; c < n_components; ++c)
                  for (unsigned int d = 0; d < n_components; ++d)
                    sum[c * n_components + d] +=
                      a * (is_transposed ? block[d * n_components + c] :
                                           block[c * n_components + d]);
              });
        if (!term.is_compact())
          continue;
        const unsigned int first = pattern.row_start[begin],
                           last  = pattern.row_start[end];
        Kernels::add_numbers<n_components>(a,
                                           term.numbers.block(first),
                                           last - first,
                                           target.block(first));
        for (auto i = std::lower_bound(term.rows_with_blocks.begin(),
                                       term.rows_with_blocks.end(),
                                       begin);
             i != term.rows_with_blocks.end() && *i < end;
             ++i)
          {
            const double *block =
              term.blocks_of_rows.data() +
              term.first_block[i - term.rows_with_blocks.begin()];
            double           *row = target.block(pattern.row_start[*i]);
            const std::size_t size =
              target.block(pattern.row_start[*i + 1]) - row;
            for (std::size_t k = 0; k < size; ++k)
              row[k] += a * block[k];
          }
      }
  }



  template <int n_components>
  std::size_t
  TermMatrix<n_components>::memory_consumption() const
  {
    return blocks.memory_consumption() + numbers.memory_consumption() +
           sizeof(double) * upper.capacity() +
           sizeof(unsigned int) * (upper_start.capacity() + mirror.capacity() +
                                   rows_with_blocks.capacity()) +
           sizeof(std::size_t) * first_block.capacity() +
           sizeof(double) * blocks_of_rows.capacity();
  }



  template class TermMatrix<1>;
  template class TermMatrix<2>;
  template class TermMatrix<3>;
} // namespace StickSlip
