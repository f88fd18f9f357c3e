// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/direct_correction.h>

namespace StickSlip
{
  template <int dim>
  DirectCorrection<dim>::DirectCorrection(
    LevelHierarchy<dim>                      &hierarchy,
    std::unique_ptr<SparseFactorisation<dim>> factorisation)
    : hierarchy(hierarchy)
    , factorisation(std::move(factorisation))
  {}



  template <int dim>
  void
  DirectCorrection<dim>::linearise(
    const std::vector<Tensor<2, dim>> &new_hessians,
    const NodeMask                    &new_active)
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



  template <int dim>
  unsigned int
  DirectCorrection<dim>::solve(NodalVector &x, NodalVector &A_x, NodalVector &r)
  {
    factorisation->solve(x, r);
    active.apply(x);
    hierarchy.matrix().vmult(A_x, x);
    return 1;
  }



  template class DirectCorrection<2>;
  template class DirectCorrection<3>;
} // namespace StickSlip
