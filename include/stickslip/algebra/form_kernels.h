// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_form_kernels_h
#define stickslip_algebra_form_kernels_h

#include <stickslip/algebra/block_kernels.h>

/**
 * Quadratic forms of nodal block matrices, in plain C++ like block_kernels.h.
 * Instantiated for one to three components.
 */
namespace StickSlip
{
  namespace Kernels
  {
    /**
     * The part of x . A x that the rows of this process give, n_rows of them:
     * added up over all processes it is the whole. A is symmetric, of which
     * only blocks on and above the diagonal are read; @p diagonal: position of
     * that of each row. Columns from n_rows on are ghosts, whose blocks below
     * the diagonal are those of another process.
     */
    template <int n_components>
    double
    quadratic_form(const BlockRows<double> &A,
                   const unsigned int      *diagonal,
                   const unsigned int       n_rows,
                   const double            *x);
  } // namespace Kernels
} // namespace StickSlip

#endif
