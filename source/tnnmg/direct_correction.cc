// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/direct_correction.h>

namespace StickSlip
{
  template <int n_components>
  DirectCorrection<n_components>::DirectCorrection(
    LevelHierarchy<n_components>                      &hierarchy,
    std::unique_ptr<SparseFactorisation<n_components>> factorisation)
    : hierarchy(hierarchy)
    , factorisation(std::move(factorisation))
  {}



  template <int n_components>
  void
  DirectCorrection<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &new_hessians,
    const NodeMask                             &new_active)
  {
    if (is_factorised && version == hierarchy.operator_version() &&
        hessians == new_hessians &&
        active.is_equal(new_active, hierarchy.finest().nodes.n_owned()))
      return;
    is_factorised = false;
    version       = hierarchy.operator_version();
    hessians      = new_hessians;
    active        = new_active;

    factorisation->set_matrix(linearised_matrix(hierarchy, hessians), active);
    is_factorised = true;
  }



  template <int n_components>
  unsigned int
  DirectCorrection<n_components>::solve(NodalVector &x,
                                        NodalVector &A_x,
                                        NodalVector &r)
  {
    factorisation->solve(x, r);
    active.apply(x);
    hierarchy.matrix().vmult(A_x, x);
    return 1;
  }



  template class DirectCorrection<1>;
  template class DirectCorrection<2>;
  template class DirectCorrection<3>;
} // namespace StickSlip
