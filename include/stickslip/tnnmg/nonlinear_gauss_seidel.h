// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nonlinear_gauss_seidel_h
#define stickslip_tnnmg_nonlinear_gauss_seidel_h

#include <stickslip/algebra/operator_sum.h>
#include <stickslip/multigrid/sweep_turns.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>

namespace StickSlip
{
  /**
   * Block Gauss-Seidel for the minimisation of
   *
   *   1/2 w . A w - b . w + phi(w)
   *
   * over the components that are not fixed: exact minimisation node after node,
   * by the inverse of the diagonal block where phi has no term and by phi's own
   * local minimiser where it has one, so that the energy never increases.
   * Nodes follow in ascending order, on several processes in turns
   * (sweep_turns.h).
   */
  template <int n_components>
  class NonlinearGaussSeidel
  {
  public:
    /** Collective. */
    explicit NonlinearGaussSeidel(const OperatorSum<n_components> &operators);

    /** One sweep over all nodes or, unless @p is_everywhere, over the nonsmooth
     * ones. The residual @p r = b - A w follows, so that such a sweep reads few
     * rows. Collective among neighbours. */
    void
    sweep(const NonsmoothFunctional<n_components> &functional,
          const bool                               is_everywhere,
          NodalVector                             &w,
          NodalVector                             &r) const;

  private:
    const OperatorSum<n_components> &operators;
    SweepTurns                       turns;
    /** Ghosts that nonsmooth nodes couple to. */
    SomeGhosts beside_nonsmooth_nodes;
  };
} // namespace StickSlip

#endif
