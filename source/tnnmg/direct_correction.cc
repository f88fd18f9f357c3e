// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/direct_correction.h>

namespace StickSlip
{
  template <int n_components>
  DirectCorrection<n_components>::DirectCorrection(
    OperatorSum<n_components>                         &operators,
    std::unique_ptr<SparseFactorisation<n_components>> factorisation)
    : operators(operators)
    , factorisation(std::move(factorisation))
  {}



  template <int n_components>
  bool
  DirectCorrection<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &new_hessians,
    const NodeMask                             &new_active)
  {
    if (is_factorised && version == operators.version() &&
        hessians == new_hessians &&
        active.is_equal(new_active, operators.unknowns().nodes.n_owned()))
      return false;
    is_factorised = false;
    version       = operators.version();
    hessians      = new_hessians;
    active        = new_active;
    operators.with_hessians(hessians,
                            [&](const BlockMatrix<n_components> &linearised) {
                              factorisation->set_matrix(linearised, active);
                            });
    is_factorised = true;
    return false;
  }



  template <int n_components>
  unsigned int
  DirectCorrection<n_components>::solve(NodalVector &x,
                                        NodalVector &A_x,
                                        NodalVector &r,
                                        const double,
                                        const bool)
  {
    factorisation->solve(x, r);
    active.apply(x);
    operators.matrix().vmult(A_x, x);
    return 1;
  }



  template class DirectCorrection<1>;
  template class DirectCorrection<2>;
  template class DirectCorrection<3>;
} // namespace StickSlip
