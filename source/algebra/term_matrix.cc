// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/term_matrix.h>

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
    : blocks(std::move(matrix))
  {}



  template <int n_components>
  TermMatrix<n_components>
  TermMatrix<n_components>::compact(const BlockMatrix<n_components> &matrix)
  {
    if (n_components == 1)
      return matrix;
    const BlockSparsity &sparsity = matrix.sparsity();
    BlockMatrix<1>       numbers(matrix.shared_sparsity());
    TermMatrix           result;
    for (unsigned int i = 0; i < matrix.n_rows(); ++i)
      {
        const unsigned int begin = sparsity.row_start[i],
                           end   = sparsity.row_start[i + 1];
        if (has_multiples_of_identity(matrix, i))
          {
            for (unsigned int k = begin; k < end; ++k)
              *numbers.block(k) = *matrix.block(k);
            continue;
          }
        result.rows_with_blocks.push_back(i);
        result.first_block.push_back(result.blocks_of_rows.size());
        result.blocks_of_rows.insert(result.blocks_of_rows.end(),
                                     matrix.block(begin),
                                     matrix.block(end));
      }
    result.numbers = std::move(numbers);
    return result;
  }



  template <int n_components>
  TermMatrix<n_components>
  TermMatrix<n_components>::of_numbers(BlockMatrix<1> numbers)
  {
    TermMatrix result;
    if constexpr (n_components == 1)
      result.blocks = std::move(numbers);
    else
      result.numbers = std::move(numbers);
    return result;
  }



  template <int n_components>
  const BlockMatrix<n_components> &
  TermMatrix<n_components>::block_matrix() const
  {
    AssertThrow(!is_compact(), ExcMessage("The blocks are not stored."));
    return blocks;
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
    if (!is_compact())
      return blocks.entry(row, position);
    Tensor<2, n_components> result;
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
  void
  TermMatrix<n_components>::vmult(NodalVector &y, const NodalVector &x) const
  {
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
    const BlockSparsity &pattern = sparsity();
    for (unsigned int k = 0; k < rows_with_blocks.size(); ++k)
      {
        const unsigned int i     = rows_with_blocks[k];
        const double      *block = blocks_of_rows.data() + first_block[k];
        for (unsigned int m = pattern.row_start[i];
             m < pattern.row_start[i + 1];
             ++m, block += block_size)
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              y.begin()[i * n_components + c] +=
                block[c * n_components + d] *
                x.begin()[pattern.column[m] * n_components + d];
      }
  }



  template <int n_components>
  void
  TermMatrix<n_components>::residual(NodalVector       &r,
                                     const NodalVector &b,
                                     const NodalVector &x) const
  {
    if (!is_compact())
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
      if (!terms[t].is_compact())
        stored.emplace_back(coefficients[t], &terms[t].blocks);
    target.combine(stored, begin, end);
    const BlockSparsity &pattern = target.sparsity();
    for (unsigned int t = 0; t < terms.size(); ++t)
      {
        const TermMatrix &term = terms[t];
        if (!term.is_compact())
          continue;
        const double       a     = coefficients[t];
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
           sizeof(unsigned int) * rows_with_blocks.capacity() +
           sizeof(std::size_t) * first_block.capacity() +
           sizeof(double) * blocks_of_rows.capacity();
  }



  template class TermMatrix<1>;
  template class TermMatrix<2>;
  template class TermMatrix<3>;
} // namespace StickSlip
