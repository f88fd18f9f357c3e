// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_block_kernels_h
#define stickslip_algebra_block_kernels_h

/**
 * The inner loops on nodal block matrices: square blocks of n_components rows,
 * stored row by row, and vectors with n_components consecutive entries a node.
 * Plain C++ without other headers, so that this file alone may be compiled
 * for the machine's own instruction set. Instantiated for one to three
 * components, float and double.
 */
namespace StickSlip
{
  namespace Kernels
  {
    /**
     * A block matrix in compressed row storage as the kernels see it. Column
     * indices refer to the local numbering of a vector: owned nodes first,
     * ghost nodes behind.
     */
    template <typename Number>
    struct BlockRows
    {
      const unsigned int *row_start;
      const unsigned int *column;
      const Number       *values;
    };

    /** y_i = sum_j A_ij x_j for the rows begin <= i < end. */
    template <int n_components, typename Number>
    void
    vmult(const BlockRows<Number> &A,
          const unsigned int       begin,
          const unsigned int       end,
          const Number            *x,
          Number                  *y);

    /** y_i = sum_j A_ij x_j for the first @p n rows of a matrix of numbers. */
    template <int n_components, typename Number>
    void
    vmult_by_numbers(const BlockRows<Number> &A,
                     const unsigned int       n,
                     const Number            *x,
                     Number                  *y);

    /** r_i = b_i - sum_j A_ij x_j for the rows begin <= i < end. */
    template <int n_components, typename Number>
    void
    residual(const BlockRows<Number> &A,
             const unsigned int       begin,
             const unsigned int       end,
             const Number            *b,
             const Number            *x,
             Number                  *r);

    /** Add factor times the identity times a number to each of @p n blocks. */
    template <int n_components, typename Number>
    void
    add_numbers(const Number        factor,
                const Number       *numbers,
                const unsigned long n,
                Number             *blocks);

    /** result = sum_k coefficients[k] * terms[k], entry by entry. */
    template <typename Number>
    void
    linear_combination(const unsigned int   n_terms,
                       const double        *coefficients,
                       const Number *const *terms,
                       const unsigned long  size,
                       Number              *result);
  } // namespace Kernels
} // namespace StickSlip

#endif
