// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

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
        double rz = 0.;
        if (steps == 1)
          direction = preconditioned;
        else
          {
            rz = r * preconditioned;
            if (!(rz > rz_small))
              break;
            direction.sadd(rz / rz_old, 1., preconditioned);
          }
        A.matrix().vmult(A_direction, direction);
        A.add_hessians(A_direction, 1., hessians, direction);
        double curvature = local_product(direction, A_direction);
        if (steps == 1)
          {
            // Both in one message: most corrections are of a single step.
            const auto both =
              sums<2>({{local_product(r, preconditioned), curvature}},
                      r.get_mpi_communicator());
            rz        = both[0];
            curvature = both[1];
            rz_small  = reduction * reduction * rz;
            if (!(rz > 0.))
              break;
          }
        else
          curvature = Utilities::MPI::sum(curvature, r.get_mpi_communicator());
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
