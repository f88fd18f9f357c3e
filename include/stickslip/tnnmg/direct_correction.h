// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_direct_correction_h
#define stickslip_tnnmg_direct_correction_h

#include <stickslip/algebra/sparse_factorisation.h>
#include <stickslip/tnnmg/linear_correction.h>

namespace StickSlip
{
  /**
   * The exact solution by a sparse factorisation, which makes TNNMG what is
   * commonly called a semismooth Newton method with a direct solver, globalised
   * by the nonlinear smoother and the line search. On one process.
   */
  template <int n_components>
  class DirectCorrection : public LinearCorrection<n_components>
  {
  public:
    DirectCorrection(
      OperatorSum<n_components>                         &operators,
      std::unique_ptr<SparseFactorisation<n_components>> factorisation);

    bool
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active) override;

    unsigned int
    solve(NodalVector &x,
          NodalVector &A_x,
          NodalVector &r,
          const double norm,
          const bool   is_outdated) override;

  private:
    OperatorSum<n_components>                         &operators;
    std::unique_ptr<SparseFactorisation<n_components>> factorisation;

    /** The linearisation that the factors belong to, if there are any. */
    bool                                 is_factorised = false;
    unsigned long                        version       = 0;
    std::vector<Tensor<2, n_components>> hessians;
    NodeMask                             active;
  };
} // namespace StickSlip

#endif
