// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/transfer_matrix.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace StickSlip
{
  namespace
  {
    using RowRange = TransferMatrix::RowRange;



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



    /** True if a row has axes of its own or a column that has. */
    bool
    is_turned(const TransferMatrix::Compressed &A,
              const unsigned int                i,
              const LocalFrames                &row_frames,
              const LocalFrames                &column_frames)
    {
      return row_frames.find(i) != nullptr ||
             std::any_of(A.column.begin() + A.row_start[i],
                         A.column.begin() + A.row_start[i + 1],
                         [&](const unsigned int j) {
                           return column_frames.find(j) != nullptr;
                         });
    }



    /** The first @p n_rows rows by what their products take. */
    std::vector<RowRange>
    find_ranges(const TransferMatrix::Compressed &A,
                const unsigned int                n_rows,
                const LocalFrames                &row_frames,
                const LocalFrames                &column_frames)
    {
      // As many copied rows as are worth an interruption of others.
      constexpr unsigned int least_copied = 8;
      const bool have_axes = !row_frames.empty() || !column_frames.empty();
      const auto kind      = [&](const unsigned int i) {
        if (have_axes && is_turned(A, i, row_frames, column_frames))
          return RowRange::turned;
        const unsigned int k = A.row_start[i];
        return A.row_start[i + 1] == k + 1 && A.value[k] == 1. ?
                      RowRange::copied :
                      RowRange::summed;
      };
      std::vector<RowRange> ranges;
      for (unsigned int i = 0; i < n_rows;)
        {
          RowRange range = {i, i + 1, kind(i)};
          if (range.kind == RowRange::copied)
            {
              range.column = A.column[A.row_start[i]];
              while (range.end < n_rows &&
                     kind(range.end) == RowRange::copied &&
                     A.column[A.row_start[range.end]] ==
                       range.column + (range.end - i))
                ++range.end;
              if (range.end - i < least_copied)
                range.kind = RowRange::summed;
            }
          if (range.kind == RowRange::summed && !ranges.empty() &&
              ranges.back().kind == RowRange::summed)
            ranges.back().end = range.end;
          else
            ranges.push_back(range);
          i = range.end;
        }
      return ranges;
    }



    /** The rows begin <= i < end of y = A x or y += A x, with a fixed number of
     * components. */
    template <int components, bool add, typename Number>
    void
    multiply(const TransferMatrix::Compressed &A,
             const unsigned int                begin,
             const unsigned int                end,
             const Number                     *x,
             Number                           *y)
    {
      for (unsigned int i = begin; i < end; ++i)
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
    copy_rows(const Number *x, const std::size_t n_entries, Number *y)
    {
      if (!add)
        std::copy_n(x, n_entries, y);
      else
        for (std::size_t i = 0; i < n_entries; ++i)
          y[i] += x[i];
    }



    /** The row i of y = R^T A Q x, or += that, with the axes R of rows and Q of
     * columns. */
    template <int components, bool add, typename Number>
    void
    multiply_turned_row(const TransferMatrix::Compressed &A,
                        const unsigned int                i,
                        const LocalFrames                &row_frames,
                        const LocalFrames                &column_frames,
                        const Number                     *x,
                        Number                           *y)
    {
      double in_space[components] = {};
      for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
        {
          const Number *x_j = x + std::size_t(A.column[k]) * components;
          if (const double *Q = column_frames.find(A.column[k]))
            for (int c = 0; c < components; ++c)
              for (int d = 0; d < components; ++d)
                in_space[c] += A.value[k] * Q[c * components + d] * x_j[d];
          else
            for (int c = 0; c < components; ++c)
              in_space[c] += A.value[k] * x_j[c];
        }
      const double *R   = row_frames.find(i);
      Number       *y_i = y + std::size_t(i) * components;
      for (int c = 0; c < components; ++c)
        {
          double value = (R == nullptr ? in_space[c] : 0.);
          if (R != nullptr)
            for (int d = 0; d < components; ++d)
              value += R[d * components + c] * in_space[d];
          y_i[c] = (add ? Number(y_i[c] + value) : Number(value));
        }
    }



    /** Rows of y = R^T A Q x or y += R^T A Q x with the axes R of rows and Q of
     * columns. */
    template <bool add, typename Number>
    void
    multiply(const TransferMatrix::Compressed &A,
             const std::vector<RowRange>      &ranges,
             const LocalFrames                &row_frames,
             const LocalFrames                &column_frames,
             const NodeValues<Number>         &x,
             NodeValues<Number>               &y,
             const unsigned int                components)
    {
      Assert(row_frames.empty() || row_frames.n_components() == components,
             ExcDimensionMismatch(row_frames.n_components(), components));
      Assert(column_frames.empty() ||
               column_frames.n_components() == components,
             ExcDimensionMismatch(column_frames.n_components(), components));
      const auto multiply_all = [&](const auto size) {
        constexpr int n = decltype(size)::value;
        for (const RowRange &range : ranges)
          switch (range.kind)
            {
              case RowRange::summed:
                multiply<n, add>(
                  A, range.begin, range.end, x.begin(), y.begin());
                break;
              case RowRange::copied:
                copy_rows<add>(x.begin() + std::size_t(range.column) * n,
                               std::size_t(range.end - range.begin) * n,
                               y.begin() + std::size_t(range.begin) * n);
                break;
              case RowRange::turned:
                multiply_turned_row<n, add>(A,
                                            range.begin,
                                            row_frames,
                                            column_frames,
                                            x.begin(),
                                            y.begin());
                break;
            }
      };
      switch (components)
        {
          case 1:
            multiply_all(std::integral_constant<int, 1>());
            break;
          case 2:
            multiply_all(std::integral_constant<int, 2>());
            break;
          case 3:
            multiply_all(std::integral_constant<int, 3>());
            break;
          default:
            Assert(false, ExcMessage("One to three components a node."));
        }
    }
  } // namespace



  TransferMatrix::TransferMatrix(const std::vector<GlobalRow> &rows,
                                 const NodePartition          &fine,
                                 const NodePartition          &coarse,
                                 const LocalFrames            &row_frames,
                                 const LocalFrames            &column_frames)
    : n_owned_rows(fine.n_owned())
    , frames_of_rows(row_frames)
    , frames_of_columns(column_frames)
  {
    Assert(rows.size() == fine.n_owned() || rows.size() == fine.n_local(),
           ExcDimensionMismatch(rows.size(), fine.n_local()));
    by_row.row_start.reserve(rows.size() + 1);
    for (const GlobalRow &row : rows)
      append_row(row, coarse);
    by_row.column.shrink_to_fit();
    by_row.value.shrink_to_fit();
    by_column  = transpose_of(by_row, n_owned_rows, coarse.n_local());
    row_ranges = find_ranges(by_row, n_owned_rows, row_frames, column_frames);
    column_ranges =
      find_ranges(by_column, n_columns(), column_frames, row_frames);
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
    multiply<false>(by_row,
                    row_ranges,
                    frames_of_rows,
                    frames_of_columns,
                    coarse,
                    fine,
                    components);
  }



  template <typename Number>
  void
  TransferMatrix::prolongate_add(NodeValues<Number>       &fine,
                                 const NodeValues<Number> &coarse,
                                 const unsigned int        components) const
  {
    update_ghosts(coarse);
    multiply<true>(by_row,
                   row_ranges,
                   frames_of_rows,
                   frames_of_columns,
                   coarse,
                   fine,
                   components);
  }



  template <typename Number>
  void
  TransferMatrix::restrict_to(NodeValues<Number>       &coarse,
                              const NodeValues<Number> &fine,
                              const unsigned int        components) const
  {
    // The owned fine nodes' shares, to own coarse nodes and to ghosts.
    multiply<false>(by_column,
                    column_ranges,
                    frames_of_columns,
                    frames_of_rows,
                    fine,
                    coarse,
                    components);
    add_ghosts_to_owners(coarse);
  }



  std::size_t
  TransferMatrix::memory_consumption() const
  {
    return 2 *
             (by_row.column.size() * (sizeof(unsigned int) + sizeof(double))) +
           sizeof(unsigned int) *
             (by_row.row_start.size() + by_column.row_start.size()) +
           sizeof(RowRange) * (row_ranges.size() + column_ranges.size());
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
