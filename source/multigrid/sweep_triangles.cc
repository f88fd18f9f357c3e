// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/large_pages.h>
#include <stickslip/multigrid/sweep_triangles.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace StickSlip
{
  template <int n_components, typename Number>
  SweepTriangles<n_components, Number>::SweepTriangles(
    const std::shared_ptr<const BlockSparsity> &sparsity,
    const std::vector<std::uint64_t>           &order)
    : sparsity(sparsity)
  {
    const unsigned int n = sparsity->n_rows();
    lower.row_start.reserve(n + 1);
    upper.row_start.reserve(n + 1);
    first_above.reserve(n);
    const auto when = [&](const unsigned int node) -> std::uint64_t {
      return order.empty() ? node : order[node];
    };
    std::vector<unsigned int> sorted;
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto begin = sparsity->column.begin() + sparsity->row_start[i],
                   end = sparsity->column.begin() + sparsity->row_start[i + 1];
        sorted.clear();
        const auto append_if = [&](const auto &belongs) {
          std::copy_if(begin,
                       end,
                       std::back_inserter(sorted),
                       [&](const unsigned int j) {
                         return belongs(when(j), when(i));
                       });
          return sorted.size();
        };
        const std::size_t n_below  = append_if(std::less<>()),
                          n_before = append_if(std::equal_to<>()),
                          n_above  = append_if(std::greater<>()) - n_before;
        if (sorted_columns.empty() && !std::equal(begin, end, sorted.begin()))
          sorted_columns = sparsity->column;
        if (!sorted_columns.empty())
          std::copy(sorted.begin(),
                    sorted.end(),
                    sorted_columns.begin() + sparsity->row_start[i]);
        lower.row_start.push_back(lower.row_start.back() + n_below);
        upper.row_start.push_back(upper.row_start.back() + n_above);
        first_above.push_back(sparsity->row_start[i + 1] - n_above);
      }
    for (Part *part : {&lower, &upper})
      {
        const std::size_t n = std::size_t(part->row_start.back()) * block_size +
                              Kernels::sweep_padding;
        reserve_on_large_pages(n, part->values);
        part->values.resize(n);
      }
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  SweepTriangles<n_components, Number>::set_row(
    const unsigned int                            i,
    const BlockMatrix<n_components, OtherNumber> &matrix)
  {
    const auto copy =
      [&](Part &part, const unsigned int entry, const unsigned int k) {
        const OtherNumber *block  = matrix.block(k);
        Number            *target = part.values.data() +
                         (std::size_t(part.row_start[i]) + entry) * block_size;
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            target[Kernels::sweep_position<n_components>(c, d)] =
              block[c * n_components + d];
      };
    const unsigned int begin = sparsity->row_start[i],
                       end   = sparsity->row_start[i + 1];
    if (sorted_columns.empty())
      {
        for (unsigned int k = 0; k < lower.n_entries(i); ++k)
          copy(lower, k, begin + k);
        for (unsigned int k = 0; k < upper.n_entries(i); ++k)
          copy(upper, k, first_above[i] + k);
        return;
      }
    // Columns of each part are in the order of those of the row.
    const unsigned int *of_lower = sorted_columns.data() + begin;
    const unsigned int *of_upper = sorted_columns.data() + first_above[i];
    unsigned int        n_below = 0, n_above = 0;
    for (unsigned int k = begin; k < end; ++k)
      {
        const unsigned int j = sparsity->column[k];
        if (n_below < lower.n_entries(i) && of_lower[n_below] == j)
          copy(lower, n_below++, k);
        else if (n_above < upper.n_entries(i) && of_upper[n_above] == j)
          copy(upper, n_above++, k);
      }
  }



  template <int n_components, typename Number>
  Kernels::Triangle<Number>
  SweepTriangles<n_components, Number>::below() const
  {
    return {lower.row_start.data(),
            sparsity->row_start.data(),
            columns().data(),
            lower.values.data()};
  }



  template <int n_components, typename Number>
  Kernels::Triangle<Number>
  SweepTriangles<n_components, Number>::above() const
  {
    return {upper.row_start.data(),
            first_above.data(),
            columns().data(),
            upper.values.data()};
  }



  template <int n_components, typename Number>
  const Number *
  SweepTriangles<n_components, Number>::block_below(const unsigned int i,
                                                    const unsigned int j) const
  {
    const auto begin = columns().begin() + sparsity->row_start[i],
               end   = begin + lower.n_entries(i);
    const auto found = std::find(begin, end, j);
    Assert(found != end, ExcMessage("There is no such coupling."));
    return lower.row(i) + std::size_t(found - begin) * block_size;
  }



  template <int n_components, typename Number>
  std::size_t
  SweepTriangles<n_components, Number>::memory_consumption() const
  {
    std::size_t bytes = sizeof(unsigned int) *
                        (first_above.capacity() + sorted_columns.capacity());
    for (const Part *part : {&lower, &upper})
      bytes += sizeof(unsigned int) * part->row_start.capacity() +
               sizeof(Number) * part->values.capacity();
    return bytes;
  }



#define STICKSLIP_INSTANTIATE(n_components)                            \
  template class SweepTriangles<n_components, float>;                  \
  template class SweepTriangles<n_components, double>;                 \
  template void SweepTriangles<n_components, float>::set_row<float>(   \
    const unsigned int, const BlockMatrix<n_components, float> &);     \
  template void SweepTriangles<n_components, float>::set_row<double>(  \
    const unsigned int, const BlockMatrix<n_components, double> &);    \
  template void SweepTriangles<n_components, double>::set_row<double>( \
    const unsigned int, const BlockMatrix<n_components, double> &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
