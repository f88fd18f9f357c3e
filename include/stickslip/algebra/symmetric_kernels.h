// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_symmetric_kernels_h
#define stickslip_algebra_symmetric_kernels_h

/**
 * Products with symmetric nodal block matrices, in plain C++ like
 * block_kernels.h. Instantiated for one to three components.
 */
namespace StickSlip
{
  namespace Kernels
  {
    /**
     * The rows of a process of a symmetric matrix: the columns of all entries,
     * where those of each row end, the position of its diagonal, and the blocks
     * from the diagonal on, row by row. Columns from n_rows on are ghosts,
     * whose blocks below the diagonal are those of another process.
     */
    struct UpperTriangle
    {
      unsigned int        n_rows;
      const unsigned int *row_start, *diagonal, *column;
      const double       *values;
    };

    /** y = A x. */
    template <int n_components>
    void
    symmetric_vmult(const UpperTriangle &A, const double *x, double *y);

    /** The part of x . A x that the rows of this process give: added up over
     * all processes it is the whole. */
    template <int n_components>
    double
    quadratic_form(const UpperTriangle &A, const double *x);
  } // namespace Kernels
} // namespace StickSlip

#endif
