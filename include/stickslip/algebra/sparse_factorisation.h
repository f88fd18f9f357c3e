// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_sparse_factorisation_h
#define stickslip_algebra_sparse_factorisation_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/singular_matrix.h>

namespace StickSlip
{
  /**
   * A factorisation of a symmetric positive definite block matrix of one
   * process, with rows and columns of masked components replaced by those of
   * the identity. What depends on the sparsity alone is done once.
   */
  template <int n_components>
  class SparseFactorisation
  {
  public:
    virtual ~SparseFactorisation() = default;

    /** Factorise a matrix. Throws SingularMatrix; another matrix may be tried
     * after that. */
    virtual void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) = 0;

    /** x = A^-1 b, for b that is zero in masked components. */
    virtual void
    solve(NodalVector &x, const NodalVector &b) = 0;
  };
} // namespace StickSlip

#endif
