// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "amg_correction.h"

namespace Measure
{
  template <int dim>
  AMGCorrection<dim>::AMGCorrection(
    OperatorSum<dim>               &operators,
    const TNNMGParameters          &parameters,
    const std::vector<NodalVector> &near_null_space)
    : operators(operators)
    , parameters(parameters)
    , cycles(/*n_cycles=*/1, near_null_space)
    , cg(operators)
  {}



  template <int dim>
  bool
  AMGCorrection<dim>::is_close(const std::vector<Tensor<2, dim>> &new_hessians,
                               const NodeMask &new_active) const
  {
    if (!cycles.is_set() || version != operators.version() ||
        !active.is_equal(new_active, operators.unknowns().nodes.n_owned()))
      return false;
    // Cycles are dear to make: a change below the diagonal of the matrix is not
    // worth it.
    const std::vector<unsigned int> &nodes =
      operators.unknowns().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double size = hessians[k].norm() +
                            operators.matrix().diagonal_block(nodes[k]).norm();
        // Written so that a NaN is not close.
        if (!((new_hessians[k] - hessians[k]).norm() <=
              parameters.coarse_update_threshold * size))
          return false;
      }
    return true;
  }



  template <int dim>
  bool
  AMGCorrection<dim>::linearise(const std::vector<Tensor<2, dim>> &new_hessians,
                                const NodeMask                    &new_active)
  {
    cg.linearise(new_hessians, new_active);
    if (is_close(new_hessians, new_active))
      return false;
    version  = operators.version();
    active   = new_active;
    hessians = new_hessians;

    bool is_set = false;
    operators.with_hessians(hessians, [&](const BlockMatrix<dim> &linearised) {
      is_set = cycles.set_matrix(linearised, active);
    });
    if (!is_set)
      throw SingularMatrix("the linearised matrix");
    return false;
  }



  template <int dim>
  unsigned int
  AMGCorrection<dim>::solve(NodalVector &x,
                            NodalVector &A_x,
                            NodalVector &r,
                            const double,
                            const bool)
  {
    constexpr unsigned int min_steps = 1, max_steps = 200;
    constexpr double       reduction = 1e-2;

    return cg.solve(
      [&](NodalVector &z, const NodalVector &b) {
        cycles.vmult(z, b);
        active.apply(z);
      },
      min_steps,
      max_steps,
      reduction,
      x,
      A_x,
      r);
  }



  template class AMGCorrection<2>;
  template class AMGCorrection<3>;
} // namespace Measure
