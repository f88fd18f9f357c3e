// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/multigrid/line_factors.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    template <int n_components, typename Number>
    Tensor<2, n_components>
    read_block(const Number *values)
    {
      Tensor<2, n_components> block;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          block[c][d] = values[c * n_components + d];
      return block;
    }



    template <int n_components, typename Number>
    void
    write_block(const Tensor<2, n_components> &block, Number *values)
    {
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          values[c * n_components + d] = block[c][d];
    }



    /** Set rows and columns of components that do not take part to zero. */
    template <int n_components>
    void
    mask_block(Tensor<2, n_components> &block,
               const unsigned int       rows,
               const unsigned int       columns)
    {
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          if (!((rows >> c) & (columns >> d) & 1u))
            block[c][d] = 0.;
    }



    /**
     * The inverse of a pivot in the components that take part, zero in the
     * others. A pivot that is no more than what rounding leaves of the diagonal
     * block of the matrix is replaced by this.
     */
    template <int n_components>
    Tensor<2, n_components>
    invert_pivot(Tensor<2, n_components>        pivot,
                 const Tensor<2, n_components> &diagonal,
                 const unsigned int             components,
                 const double                   precision)
    {
      const auto takes_part = [&](const unsigned int c) {
        return (components >> c) & 1u;
      };
      for (unsigned int c = 0; c < n_components; ++c)
        if (takes_part(c) && !(pivot[c][c] > precision * diagonal[c][c]))
          {
            pivot = diagonal;
            break;
          }
      mask_block(pivot, components, components);
      for (unsigned int c = 0; c < n_components; ++c)
        if (!takes_part(c))
          pivot[c][c] = 1.;
      Tensor<2, n_components> result = invert(pivot);
      for (unsigned int c = 0; c < n_components; ++c)
        if (!takes_part(c))
          result[c][c] = 0.;
      return result;
    }
  } // namespace



  template <int n_components, typename Number>
  LineFactors<n_components, Number>::LineFactors(
    const BlockSparsity         &sparsity,
    const std::vector<NodeLine> &node_lines)
  {
    if (node_lines.empty())
      return;
    const unsigned int n = sparsity.n_rows();
    line.assign(n, numbers::invalid_unsigned_int);
    place.assign(n, 0);
    components.assign(n, 0);
    diagonal.resize(std::size_t(n) * block_size);
    inverse_pivot.resize(std::size_t(n) * block_size);
    std::size_t n_blocks = 0;
    for (const NodeLine &nodes : node_lines)
      {
        Line next;
        next.nodes       = nodes;
        next.width       = 0;
        next.first_block = n_blocks;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            line[nodes[i]]  = lines.size();
            place[nodes[i]] = i;
          }
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int k = sparsity.row_start[nodes[i]];
               k < sparsity.row_start[nodes[i] + 1];
               ++k)
            {
              const unsigned int j = sparsity.column[k];
              if (j < n && line[j] == lines.size() && place[j] < i)
                next.width = std::max(next.width, i - place[j]);
            }
        n_blocks += next.width * nodes.size();
        lines.push_back(std::move(next));
      }
    band.assign(n_blocks * block_size, Number(0.));
    factor.assign(n_blocks * block_size, Number(0.));
  }



  template <int n_components, typename Number>
  unsigned int
  LineFactors<n_components, Number>::longest() const
  {
    std::size_t result = 0;
    for (const Line &one : lines)
      result = std::max(result, one.nodes.size());
    return result;
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  LineFactors<n_components, Number>::set_row(
    const unsigned int                            node,
    const BlockMatrix<n_components, OtherNumber> &matrix)
  {
    Line                &its_line = lines[line[node]];
    const BlockSparsity &sparsity = matrix.sparsity();
    its_line.is_current           = false;
    for (unsigned int k = sparsity.row_start[node];
         k < sparsity.row_start[node + 1];
         ++k)
      {
        const unsigned int j = sparsity.column[k];
        if (j < line.size() && line[j] == line[node] && place[j] < place[node])
          std::copy_n(matrix.block(k),
                      block_size,
                      band.begin() + band_position(its_line,
                                                   place[node],
                                                   place[node] - place[j] - 1));
      }
  }



  template <int n_components, typename Number>
  void
  LineFactors<n_components, Number>::set_diagonal(const unsigned int node,
                                                  const Block       &block,
                                                  const NodeMask    &active)
  {
    lines[line[node]].is_current = false;
    components[node]             = active.active_components(node);
    write_block(block, diagonal.data() + std::size_t(node) * block_size);
  }



  template <int n_components, typename Number>
  void
  LineFactors<n_components, Number>::factorise()
  {
    for (Line &one : lines)
      if (!one.is_current)
        {
          factorise(one);
          one.is_current = true;
        }
  }



  template <int n_components, typename Number>
  void
  LineFactors<n_components, Number>::factorise(const Line &one)
  {
    // Row i of L D is A_ij - sum_m (L D)_im L_jm^T, m < j < i.
    const double       precision = std::numeric_limits<Number>::epsilon();
    const unsigned int width     = one.width;
    std::vector<Block> L(one.nodes.size() * width), inverse(one.nodes.size());
    std::vector<Block> LD(width);
    for (unsigned int i = 0; i < one.nodes.size(); ++i)
      {
        const unsigned int node  = one.nodes[i];
        Block              pivot = read_block<n_components>(diagonal.data() +
                                               std::size_t(node) * block_size);
        const Block        block = pivot;
        for (unsigned int k = std::min(width, i); k-- > 0;)
          {
            const unsigned int j     = i - 1 - k;
            Block             &entry = LD[k];
            entry =
              read_block<n_components>(band.data() + band_position(one, i, k));
            mask_block(entry, components[node], components[one.nodes[j]]);
            for (unsigned int m = std::min(i, width); m-- > k + 1;)
              {
                // The node m + 1 places before i is m - k places before j.
                entry -= LD[m] * transpose(L[j * width + (m - k - 1)]);
              }
            L[i * width + k] = entry * inverse[j];
            write_block(L[i * width + k],
                        factor.data() + band_position(one, i, k));
            pivot -= L[i * width + k] * transpose(entry);
          }
        inverse[i] = invert_pivot(pivot, block, components[node], precision);
        write_block(inverse[i],
                    inverse_pivot.data() + std::size_t(node) * block_size);
      }
  }



  template <int n_components, typename Number>
  void
  LineFactors<n_components, Number>::solve(const unsigned int l,
                                           Number            *values) const
  {
    const Line        &one = lines[l];
    const unsigned int n   = one.nodes.size();
    for (unsigned int i = 1; i < n; ++i)
      {
        Number *x = values + std::size_t(i) * n_components;
        for (unsigned int k = 0; k < std::min(one.width, i); ++k)
          {
            const Number *L = factor.data() + band_position(one, i, k);
            const Number *y = x - (k + 1) * n_components;
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                x[c] -= L[c * n_components + d] * y[d];
          }
      }
    for (unsigned int i = n; i-- > 0;)
      {
        Number       *x = values + std::size_t(i) * n_components;
        const Number *D =
          inverse_pivot.data() + std::size_t(one.nodes[i]) * block_size;
        Number result[n_components];
        for (unsigned int c = 0; c < n_components; ++c)
          {
            result[c] = 0.;
            for (unsigned int d = 0; d < n_components; ++d)
              result[c] += D[c * n_components + d] * x[d];
          }
        for (unsigned int k = 0; k < std::min(one.width, n - 1 - i); ++k)
          {
            const Number *L = factor.data() + band_position(one, i + k + 1, k);
            const Number *y = x + (k + 1) * n_components;
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                result[c] -= L[d * n_components + c] * y[d];
          }
        for (unsigned int c = 0; c < n_components; ++c)
          x[c] = result[c];
      }
  }



  template <int n_components, typename Number>
  std::size_t
  LineFactors<n_components, Number>::memory_consumption() const
  {
    std::size_t bytes =
      sizeof(unsigned int) * (line.capacity() + place.capacity()) +
      components.capacity() +
      sizeof(Number) * (diagonal.capacity() + inverse_pivot.capacity() +
                        band.capacity() + factor.capacity());
    for (const Line &one : lines)
      bytes += sizeof(Line) + sizeof(unsigned int) * one.nodes.capacity();
    return bytes;
  }



#define STICKSLIP_INSTANTIATE(n_components)                         \
  template class LineFactors<n_components, float>;                  \
  template class LineFactors<n_components, double>;                 \
  template void LineFactors<n_components, float>::set_row<float>(   \
    const unsigned int, const BlockMatrix<n_components, float> &);  \
  template void LineFactors<n_components, float>::set_row<double>(  \
    const unsigned int, const BlockMatrix<n_components, double> &); \
  template void LineFactors<n_components, double>::set_row<double>( \
    const unsigned int, const BlockMatrix<n_components, double> &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
