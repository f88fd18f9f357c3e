// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_linearised_cg_h
#define stickslip_multigrid_linearised_cg_h

#include <stickslip/algebra/operator_sum.h>

#include <functional>

namespace StickSlip
{
  /**
   * Preconditioned conjugate gradients from zero for S (A + H) S x = S r, see
   * LinearCorrection, that give the product A x along with x: A is applied to
   * directions anyway. As it is applied to what the preconditioner gives, and
   * the product of the direction follows from that, a step takes one sum over
   * processes (Chronopoulos and Gear 1989).
   */
  template <int n_components>
  class LinearisedCG
  {
  public:
    /** x = an approximation of (S (A + H) S)^-1 b, symmetric, x = S x. */
    using Preconditioner =
      std::function<void(NodalVector &x, const NodalVector &b)>;

    explicit LinearisedCG(const OperatorSum<n_components> &operators);

    /** See LinearCorrection. */
    void
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active);

    /**
     * Steps until the residual, in the norm of the preconditioner, is expected
     * to be @p reduction times the initial one, if the last step reduces it as
     * the one before; at least @p min_steps, at most @p max_steps. See
     * LinearCorrection for the vectors. Returns the applications of the
     * preconditioner. Collective.
     */
    unsigned int
    solve(const Preconditioner &precondition,
          const unsigned int    min_steps,
          const unsigned int    max_steps,
          const double          reduction,
          NodalVector          &x,
          NodalVector          &A_x,
          NodalVector          &r);

  private:
    const OperatorSum<n_components>     &A;
    std::vector<Tensor<2, n_components>> hessians;
    NodeMask                             active;
    NodalVector direction, A_direction, preconditioned, A_preconditioned;
  };
} // namespace StickSlip

#endif
