// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/transfer_matrix.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    /** The transpose of the first @p n_rows rows. */
    TransferMatrix::Compressed
    transpose_of(const TransferMatrix::Compressed &A,
                 const unsigned int                n_rows,
                 const unsigned int                n_columns)
    {
      TransferMatrix::Compressed T;
      T.row_start.assign(n_columns + 1, 0);
      for (unsigned int k = 0; k < A.row_start[n_rows]; ++k)
        ++T.row_start[A.column[k] + 1];
      for (unsigned int c = 0; c < n_columns; ++c)
        T.row_start[c + 1] += T.row_start[c];
      T.column.resize(T.row_start.back());
      T.value.resize(T.row_start.back());
      std::vector<unsigned int> next(T.row_start.begin(),
                                     T.row_start.end() - 1);
      for (unsigned int i = 0; i < n_rows; ++i)
        for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
          {
            const unsigned int position = next[A.column[k]]++;
            T.column[position]          = i;
            T.value[position]           = A.value[k];
          }
      return T;
    }



    /** The first @p n_rows rows of y = A x or y += A x, with a fixed number of
     * components. */
    template <int components, bool add, typename Number>
    void
    multiply(const TransferMatrix::Compressed &A,
             const unsigned int                n_rows,
             const Number                     *x,
             Number                           *y)
    {
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          Number sum[components] = {};
          for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
            for (int c = 0; c < components; ++c)
              sum[c] += Number(A.value[k]) *
                        x[std::size_t(A.column[k]) * components + c];
          for (int c = 0; c < components; ++c)
            if (add)
              y[std::size_t(i) * components + c] += sum[c];
            else
              y[std::size_t(i) * components + c] = sum[c];
        }
    }



    template <bool add, typename Number>
    void
    multiply(const TransferMatrix::Compressed &A,
             const unsigned int                n_rows,
             const NodeValues<Number>         &x,
             NodeValues<Number>               &y,
             const unsigned int                components)
    {
      switch (components)
        {
          case 1:
            multiply<1, add>(A, n_rows, x.begin(), y.begin());
            break;
          case 2:
            multiply<2, add>(A, n_rows, x.begin(), y.begin());
            break;
          case 3:
            multiply<3, add>(A, n_rows, x.begin(), y.begin());
            break;
          default:
            Assert(false, ExcMessage("One to three components a node."));
        }
    }
  } // namespace



  TransferMatrix::TransferMatrix(const std::vector<GlobalRow> &rows,
                                 const NodePartition          &fine,
                                 const NodePartition          &coarse)
    : n_owned_rows(fine.n_owned())
  {
    Assert(rows.size() == fine.n_owned() || rows.size() == fine.n_local(),
           ExcDimensionMismatch(rows.size(), fine.n_local()));
    by_row.row_start.reserve(rows.size() + 1);
    for (const GlobalRow &row : rows)
      append_row(row, coarse);
    by_column = transpose_of(by_row, n_owned_rows, coarse.n_local());
  }



  void
  TransferMatrix::append_row(const GlobalRow     &global,
                             const NodePartition &coarse)
  {
    constexpr double                             negligible = 1e-14;
    std::vector<std::pair<unsigned int, double>> row;
    row.reserve(global.size());
    for (const auto &entry : global)
      row.emplace_back(coarse.local_index(entry.first), entry.second);
    std::sort(row.begin(), row.end());
    for (unsigned int k = 0; k < row.size();)
      {
        const unsigned int column = row[k].first;
        double             sum    = 0;
        for (; k < row.size() && row[k].first == column; ++k)
          sum += row[k].second;
        if (std::abs(sum) > negligible)
          {
            by_row.column.push_back(column);
            by_row.value.push_back(sum);
          }
      }
    by_row.row_start.push_back(by_row.column.size());
  }



  unsigned int
  TransferMatrix::n_rows() const
  {
    return by_row.row_start.size() - 1;
  }



  unsigned int
  TransferMatrix::n_columns() const
  {
    return by_column.row_start.size() - 1;
  }



  template <typename Number>
  void
  TransferMatrix::prolongate(NodeValues<Number>       &fine,
                             const NodeValues<Number> &coarse,
                             const unsigned int        components) const
  {
    update_ghosts(coarse);
    multiply<false>(by_row, n_owned_rows, coarse, fine, components);
  }



  template <typename Number>
  void
  TransferMatrix::prolongate_add(NodeValues<Number>       &fine,
                                 const NodeValues<Number> &coarse,
                                 const unsigned int        components) const
  {
    update_ghosts(coarse);
    multiply<true>(by_row, n_owned_rows, coarse, fine, components);
  }



  template <typename Number>
  void
  TransferMatrix::restrict_to(NodeValues<Number>       &coarse,
                              const NodeValues<Number> &fine,
                              const unsigned int        components) const
  {
    // The owned fine nodes' shares, to own coarse nodes and to ghosts.
    multiply<false>(by_column, n_columns(), fine, coarse, components);
    add_ghosts_to_owners(coarse);
  }



  std::size_t
  TransferMatrix::memory_consumption() const
  {
    return 2 *
             (by_row.column.size() * (sizeof(unsigned int) + sizeof(double))) +
           sizeof(unsigned int) *
             (by_row.row_start.size() + by_column.row_start.size());
  }



#define STICKSLIP_INSTANTIATE(Number)                                          \
  template void TransferMatrix::prolongate<Number>(NodeValues<Number> &,       \
                                                   const NodeValues<Number> &, \
                                                   const unsigned int) const;  \
  template void TransferMatrix::prolongate_add<Number>(                        \
    NodeValues<Number> &, const NodeValues<Number> &, const unsigned int)      \
    const;                                                                     \
  template void TransferMatrix::restrict_to<Number>(                           \
    NodeValues<Number> &, const NodeValues<Number> &, const unsigned int)      \
    const;

  STICKSLIP_INSTANTIATE(double)
  STICKSLIP_INSTANTIATE(float)
} // namespace StickSlip
