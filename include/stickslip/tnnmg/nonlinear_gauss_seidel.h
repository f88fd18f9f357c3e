// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nonlinear_gauss_seidel_h
#define stickslip_tnnmg_nonlinear_gauss_seidel_h

#include <stickslip/algebra/operator_sum.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>

namespace StickSlip
{
  /**
   * One sweep of block Gauss-Seidel in ascending order for the minimisation of
   *
   *   1/2 w . A w - b . w + phi(w)
   *
   * over the components that are not fixed: exact minimisation node after
   * node, by the inverse of the diagonal block where phi has no term and by
   * phi's own local minimiser where it has one, or, unless @p is_everywhere, at
   * the latter only. The residual @p r = b - A w follows, so that such a sweep
   * reads few rows. On one process the energy never increases. On several each
   * acts on its own nodes, with the values of the others as they were before
   * the sweep: that the energy does not increase is for the caller to see to.
   * Collective among neighbours.
   */
  template <int n_components>
  void
  nonlinear_gauss_seidel(const OperatorSum<n_components>         &operators,
                         const NonsmoothFunctional<n_components> &functional,
                         const bool                               is_everywhere,
                         NodalVector                             &w,
                         NodalVector                             &r);
} // namespace StickSlip

#endif
