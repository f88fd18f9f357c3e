// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/linearised_cg.h>

namespace StickSlip
{
  template <int n_components>
  LinearisedCG<n_components>::LinearisedCG(
    const OperatorSum<n_components> &operators)
    : A(operators)
    , direction(operators.unknowns().nodes.make_vector())
    , A_direction(direction)
    , preconditioned(direction)
  {}



  template <int n_components>
  void
  LinearisedCG<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &new_hessians,
    const NodeMask                             &new_active)
  {
    hessians = new_hessians;
    active   = new_active;
  }



  template <int n_components>
  unsigned int
  LinearisedCG<n_components>::solve(const Preconditioner &precondition,
                                    const unsigned int    max_steps,
                                    const double          reduction,
                                    NodalVector          &x,
                                    NodalVector          &A_x,
                                    NodalVector          &r)
  {
    x                   = 0.;
    A_x                 = 0.;
    double       rz_old = 0., rz_small = 0.;
    unsigned int steps = 0;
    while (steps < max_steps)
      {
        precondition(preconditioned, r);
        ++steps;
        const double rz = r * preconditioned;
        if (!(rz > rz_small))
          break;
        if (steps == 1)
          {
            direction = preconditioned;
            rz_small  = reduction * reduction * rz;
          }
        else
          direction.sadd(rz / rz_old, 1., preconditioned);
        A.matrix().vmult(A_direction, direction);
        A.add_hessians(A_direction, 1., hessians, direction);
        const double curvature = direction * A_direction;
        if (!(curvature > 0.))
          break;
        const double length = rz / curvature;
        x.add(length, direction);
        A_x.add(length, A_direction);
        rz_old = rz;
        // Nothing needs the residual of the last step.
        if (steps < max_steps)
          {
            active.apply(A_direction);
            r.add(-length, A_direction);
          }
      }
    // Until here the product is (A + H) x.
    A.add_hessians(A_x, -1., hessians, x);
    return steps;
  }



  template class LinearisedCG<1>;
  template class LinearisedCG<2>;
  template class LinearisedCG<3>;
} // namespace StickSlip
