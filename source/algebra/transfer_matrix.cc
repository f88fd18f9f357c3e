// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/transfer_matrix.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    TransferMatrix::Compressed
    transpose_of(const TransferMatrix::Compressed &A,
                 const unsigned int                n_columns)
    {
      TransferMatrix::Compressed T;
      T.row_start.assign(n_columns + 1, 0);
      for (const unsigned int c : A.column)
        ++T.row_start[c + 1];
      for (unsigned int c = 0; c < n_columns; ++c)
        T.row_start[c + 1] += T.row_start[c];
      T.column.resize(A.column.size());
      T.value.resize(A.column.size());
      std::vector<unsigned int> next(T.row_start.begin(),
                                     T.row_start.end() - 1);
      for (unsigned int i = 0; i + 1 < A.row_start.size(); ++i)
        for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
          {
            const unsigned int position = next[A.column[k]]++;
            T.column[position]          = i;
            T.value[position]           = A.value[k];
          }
      return T;
    }



    /** y = A x or y += A x, with a fixed number of components. */
    template <int components, bool add>
    void
    multiply(const TransferMatrix::Compressed &A, const double *x, double *y)
    {
      for (unsigned int i = 0; i + 1 < A.row_start.size(); ++i)
        {
          double sum[components] = {};
          for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
            for (int c = 0; c < components; ++c)
              sum[c] +=
                A.value[k] * x[std::size_t(A.column[k]) * components + c];
          for (int c = 0; c < components; ++c)
            if (add)
              y[std::size_t(i) * components + c] += sum[c];
            else
              y[std::size_t(i) * components + c] = sum[c];
        }
    }



    template <bool add>
    void
    multiply(const TransferMatrix::Compressed &A,
             const NodalVector                &x,
             NodalVector                      &y,
             const unsigned int                components)
    {
      switch (components)
        {
          case 1:
            multiply<1, add>(A, x.begin(), y.begin());
            break;
          case 2:
            multiply<2, add>(A, x.begin(), y.begin());
            break;
          case 3:
            multiply<3, add>(A, x.begin(), y.begin());
            break;
          default:
            Assert(false, ExcMessage("One to three components a node."));
        }
    }
  } // namespace



  TransferMatrix::TransferMatrix(const std::vector<Row> &rows,
                                 const unsigned int      n_columns)
  {
    constexpr double negligible = 1e-14;
    by_row.row_start.reserve(rows.size() + 1);
    Row row;
    for (const Row &unsorted : rows)
      {
        row = unsorted;
        std::sort(row.begin(), row.end());
        for (unsigned int k = 0; k < row.size();)
          {
            const unsigned int column = row[k].first;
            double             sum    = 0;
            for (; k < row.size() && row[k].first == column; ++k)
              sum += row[k].second;
            Assert(column < n_columns, ExcMessage("Column out of range."));
            if (std::abs(sum) > negligible)
              {
                by_row.column.push_back(column);
                by_row.value.push_back(sum);
              }
          }
        by_row.row_start.push_back(by_row.column.size());
      }
    by_column = transpose_of(by_row, n_columns);
  }



  TransferMatrix
  TransferMatrix::identity(const unsigned int n)
  {
    std::vector<Row> rows(n);
    for (unsigned int i = 0; i < n; ++i)
      rows[i] = {{i, 1.}};
    return TransferMatrix(rows, n);
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



  TransferMatrix
  TransferMatrix::operator*(const TransferMatrix &right) const
  {
    AssertDimension(n_columns(), right.n_rows());
    std::vector<Row> rows(n_rows());
    for (unsigned int i = 0; i < n_rows(); ++i)
      for (unsigned int k = by_row.row_start[i]; k < by_row.row_start[i + 1];
           ++k)
        {
          const unsigned int j = by_row.column[k];
          for (unsigned int m = right.by_row.row_start[j];
               m < right.by_row.row_start[j + 1];
               ++m)
            rows[i].emplace_back(right.by_row.column[m],
                                 by_row.value[k] * right.by_row.value[m]);
        }
    return TransferMatrix(rows, right.n_columns());
  }



  void
  TransferMatrix::prolongate(NodalVector       &fine,
                             const NodalVector &coarse,
                             const unsigned int components) const
  {
    multiply<false>(by_row, coarse, fine, components);
  }



  void
  TransferMatrix::prolongate_add(NodalVector       &fine,
                                 const NodalVector &coarse,
                                 const unsigned int components) const
  {
    multiply<true>(by_row, coarse, fine, components);
  }



  void
  TransferMatrix::restrict_to(NodalVector       &coarse,
                              const NodalVector &fine,
                              const unsigned int components) const
  {
    multiply<false>(by_column, fine, coarse, components);
  }



  std::size_t
  TransferMatrix::memory_consumption() const
  {
    return 2 *
             (by_row.column.size() * (sizeof(unsigned int) + sizeof(double))) +
           sizeof(unsigned int) *
             (by_row.row_start.size() + by_column.row_start.size());
  }



  const TransferMatrix::Compressed &
  TransferMatrix::matrix() const
  {
    return by_row;
  }



  const TransferMatrix::Compressed &
  TransferMatrix::transpose() const
  {
    return by_column;
  }
} // namespace StickSlip
