// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_turned_blocks_h
#define stickslip_algebra_turned_blocks_h

#include <algorithm>

namespace StickSlip
{
  /*
   * Blocks of n rows and columns, row by row, whose rows and columns are turned
   * between the axes of space and those of nodes.
   */

  /** C += A B for blocks row by row. */
  template <int n, typename Number>
  inline void
  add_product(const double *A, const Number *B, double *C)
  {
    for (int c = 0; c < n; ++c)
      for (int e = 0; e < n; ++e)
        for (int d = 0; d < n; ++d)
          C[c * n + d] += A[c * n + e] * B[e * n + d];
  }



  /** The block A becomes R^T A: its rows, vectors in space before, follow
   * the axes R. */
  template <int n>
  inline void
  turn_rows(double *A, const double *R)
  {
    double result[n * n] = {};
    for (int c = 0; c < n; ++c)
      for (int e = 0; e < n; ++e)
        for (int d = 0; d < n; ++d)
          result[c * n + d] += R[e * n + c] * A[e * n + d];
    std::copy_n(result, n * n, A);
  }



  /** The block A becomes A R^T, whose columns are in space, or A R, whose
   * columns follow the axes R. */
  template <int n, bool to_space>
  inline void
  turn_columns(double *A, const double *R)
  {
    double result[n * n] = {};
    for (int c = 0; c < n; ++c)
      for (int d = 0; d < n; ++d)
        for (int e = 0; e < n; ++e)
          result[c * n + d] +=
            A[c * n + e] * (to_space ? R[d * n + e] : R[e * n + d]);
    std::copy_n(result, n * n, A);
  }
} // namespace StickSlip

#endif
