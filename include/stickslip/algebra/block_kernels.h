// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_block_kernels_h
#define stickslip_algebra_block_kernels_h

/**
 * The inner loops on nodal block matrices: dim x dim blocks, stored row by row
 * (row-major inside a block), vectors with dim consecutive entries a node.
 * Plain C++ without other headers, so that this file alone may be compiled
 * for the machine's own instruction set.
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
    struct BlockRows
    {
      const unsigned int *row_start;
      const unsigned int *column;
      const double       *values;
    };

    /** y_i = sum_j A_ij x_j for the rows begin <= i < end. */
    template <int dim>
    void
    vmult(const BlockRows   &A,
          const unsigned int begin,
          const unsigned int end,
          const double      *x,
          double            *y);

    /** r_i = b_i - sum_j A_ij x_j for the rows begin <= i < end. */
    template <int dim>
    void
    residual(const BlockRows   &A,
             const unsigned int begin,
             const unsigned int end,
             const double      *b,
             const double      *x,
             double            *r);

    /**
     * Block Gauss-Seidel over the rows begin <= i < end in ascending order:
     * x_i += D_i (b - A x)_i with @p inverse_diagonal D_i, which is zero in
     * the rows and columns of components that must not change.
     */
    template <int dim>
    void
    gauss_seidel_forward(const BlockRows   &A,
                         const double      *inverse_diagonal,
                         const unsigned int begin,
                         const unsigned int end,
                         const double      *b,
                         double            *x);

    /** The same in descending order. */
    template <int dim>
    void
    gauss_seidel_backward(const BlockRows   &A,
                          const double      *inverse_diagonal,
                          const unsigned int begin,
                          const unsigned int end,
                          const double      *b,
                          double            *x);

    /** result = sum_k coefficients[k] * terms[k], entry by entry. */
    void
    linear_combination(const unsigned int   n_terms,
                       const double        *coefficients,
                       const double *const *terms,
                       const unsigned long  size,
                       double              *result);
  } // namespace Kernels
} // namespace StickSlip

#endif
