// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_sweep_kernels_h
#define stickslip_algebra_sweep_kernels_h

/**
 * The inner loops of a symmetric multigrid smoother, block Gauss-Seidel forward
 * and backward, on a matrix L + D + U whose parts below and above the diagonal
 * are stored apart from each other: then a sweep that starts from zero reads
 * L only, and the residual after it is that of U alone,
 *
 *   (L + D) x = b   =>   b - A x = -U x,
 *
 * so that both together cost one passage through the matrix. Plain C++ without
 * other headers, like block_kernels.h, and instantiated for float and double.
 *
 * A block of two components is stored row by row, one of three column by
 * column, which fills registers of four numbers best. Arrays of blocks end with
 * sweep_padding numbers more than they need, which are read together with the
 * last block and not used.
 */
namespace StickSlip
{
  namespace Kernels
  {
    constexpr unsigned int sweep_padding = 4;

    /**
     * The blocks on one side of the diagonal, row after row: those of row i
     * are row_start[i] <= k < row_start[i + 1], and its columns begin at
     * column_start[i], so that they may be a part of those of a whole row.
     * Column indices refer to the local numbering of a vector.
     */
    template <typename Number>
    struct Triangle
    {
      const unsigned int *row_start;
      const unsigned int *column_start;
      const unsigned int *column;
      const Number       *values;
    };

    /** The position in a block of the entry in row c, column d. */
    template <int n_components>
    constexpr unsigned int
    sweep_position(const unsigned int c, const unsigned int d)
    {
      return n_components == 3 ? d * n_components + c : c * n_components + d;
    }

    /** x_i = D_i (b - L x)_i for the rows begin <= i < end in ascending order,
     * where D_i is the inverse of the diagonal block, or zero in the rows and
     * columns of components that must not change. */
    template <int n_components, typename Number>
    void
    sweep_from_zero(const Triangle<Number> &lower,
                    const Number           *inverse_diagonal,
                    const unsigned int      begin,
                    const unsigned int      end,
                    const Number           *b,
                    Number                 *x);

    /** r_i = -(U x)_i for the rows 0 <= i < n. */
    template <int n_components, typename Number>
    void
    residual_after_sweep(const Triangle<Number> &upper,
                         const unsigned int      n,
                         const Number           *x,
                         Number                 *r);

    /** x_i = D_i (b - L x - U x)_i for the rows begin <= i < end in ascending
     * order. */
    template <int n_components, typename Number>
    void
    sweep_forward(const Triangle<Number> &lower,
                  const Triangle<Number> &upper,
                  const Number           *inverse_diagonal,
                  const unsigned int      begin,
                  const unsigned int      end,
                  const Number           *b,
                  Number                 *x);

    /** The sweep in descending order. */
    template <int n_components, typename Number>
    void
    sweep_backward(const Triangle<Number> &lower,
                   const Triangle<Number> &upper,
                   const Number           *inverse_diagonal,
                   const unsigned int      begin,
                   const unsigned int      end,
                   const Number           *b,
                   Number                 *x);

    /** s_k = (b - L x)_i for the rows i = rows[k], 0 <= k < n. */
    template <int n_components, typename Number>
    void
    remainder_below(const Triangle<Number> &lower,
                    const unsigned int     *rows,
                    const unsigned int      n,
                    const Number           *b,
                    const Number           *x,
                    Number                 *s);

    /** s_k = (b - L x - U x)_i for these. */
    template <int n_components, typename Number>
    void
    remainder_beside(const Triangle<Number> &lower,
                     const Triangle<Number> &upper,
                     const unsigned int     *rows,
                     const unsigned int      n,
                     const Number           *b,
                     const Number           *x,
                     Number                 *s);
  } // namespace Kernels
} // namespace StickSlip

#endif
