// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_dense_symmetric_h
#define stickslip_algebra_dense_symmetric_h

#include <stickslip/algebra/singular_matrix.h>

#include <cstddef>
#include <vector>

namespace StickSlip
{
  /*
   * Products with dense symmetric matrices and their factors, by BLAS and
   * LAPACK. Matrices of n rows are arrays of n * n numbers, row by row, of
   * which the upper triangle is read.
   */

  /** y = factor * A x. */
  void
  multiply_symmetric(std::vector<double>       &y,
                     const double               factor,
                     const std::vector<double> &A,
                     const std::vector<double> &x);

  /** y = A x with the upper left part of a matrix, of as many rows as x has,
   * whose rows begin @p stride numbers after each other. */
  void
  multiply_symmetric_part(std::vector<double>       &y,
                          const double              *A,
                          const std::size_t          stride,
                          const std::vector<double> &x);

  /** y = A x with @p n_rows rows of as many numbers as x has, which begin
   * @p stride numbers after each other. */
  void
  multiply_rows(std::vector<double>       &y,
                const unsigned int         n_rows,
                const double              *A,
                const std::size_t          stride,
                const std::vector<double> &x);

  /** y += factor * x, for @p n numbers. */
  void
  add_multiple(double            *y,
               const double       factor,
               const double      *x,
               const unsigned int n);

  /** Replace A by its Cholesky factors. Throws SingularMatrix, called
   * @p name, unless it is positive definite. */
  void
  factorise_symmetric(std::vector<double> &A,
                      const unsigned int   n,
                      const char          *name);

  /** Replace b by A^-1 b. */
  void
  solve_factorised(const std::vector<double> &factors, std::vector<double> &b);
} // namespace StickSlip

#endif
