// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/local_products.h>
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
    , A_preconditioned(direction)
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
                                    const unsigned int    min_steps,
                                    const unsigned int    max_steps,
                                    const double          reduction,
                                    NodalVector          &x,
                                    NodalVector          &A_x,
                                    NodalVector          &r)
  {
    double       rz_first = 0., rz_before = 0., curvature = 0.;
    unsigned int steps   = 0;
    bool         is_last = max_steps == 0;
    while (!is_last)
      {
        precondition(preconditioned, r);
        const bool is_first = steps == 0;
        ++steps;
        A.matrix().vmult(A_preconditioned, preconditioned);
        A.add_hessians(A_preconditioned, 1., hessians, preconditioned);
        const auto [rz, square, mixed] =
          sums<3>({{local_product(r, preconditioned),
                    local_product(preconditioned, A_preconditioned),
                    is_first ? 0. :
                               local_product(preconditioned, A_direction)}},
                  r.get_mpi_communicator());
        if (is_first)
          rz_first = rz;
        // By so much the step before has reduced the square of the norm.
        const double beta = is_first ? 0. : rz / rz_before;
        curvature = square + 2. * beta * mixed + beta * beta * curvature;
        if (!(rz > 0.) || !(curvature > 0.))
          {
            if (is_first)
              {
                x   = 0.;
                A_x = 0.;
              }
            break;
          }
        const double length = rz / curvature;
        if (is_first)
          {
            direction.swap(preconditioned);
            A_direction.swap(A_preconditioned);
            x.equ(length, direction);
            A_x.equ(length, A_direction);
          }
        else
          {
            direction.sadd(beta, 1., preconditioned);
            A_direction.sadd(beta, 1., A_preconditioned);
            x.add(length, direction);
            A_x.add(length, A_direction);
          }
        rz_before = rz;
        is_last =
          steps >= max_steps || (steps >= min_steps && !is_first &&
                                 beta * rz <= reduction * reduction * rz_first);
        // Nothing needs the residual of the last step.
        if (!is_last)
          {
            r.add(-length, A_direction);
            active.apply(r);
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
