// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_umfpack_factorisation_h
#define stickslip_algebra_umfpack_factorisation_h

#include <stickslip/algebra/sparse_factorisation.h>

namespace StickSlip
{
  /**
   * Factorisation by UMFPACK, called directly: deal.II's class for it analyses
   * the sparsity anew each time. Solutions are not improved iteratively.
   */
  template <int n_components>
  class UmfpackFactorisation : public SparseFactorisation<n_components>
  {
  public:
    UmfpackFactorisation();

    ~UmfpackFactorisation() override;

    void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) override;

    void
    solve(NodalVector &x, const NodalVector &b) override;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace StickSlip

#endif
