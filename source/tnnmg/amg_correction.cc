// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/amg_correction.h>

namespace StickSlip
{
  template <int n_components>
  AMGCorrection<n_components>::AMGCorrection(
    LevelHierarchy<n_components>   &hierarchy,
    const TNNMGParameters          &parameters,
    const std::vector<NodalVector> &near_null_space)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , cycles(/*n_cycles=*/1, near_null_space)
    , cg(hierarchy)
  {}



  template <int n_components>
  bool
  AMGCorrection<n_components>::is_close(
    const std::vector<Tensor<2, n_components>> &new_hessians,
    const NodeMask                             &new_active) const
  {
    if (!cycles.is_set() || version != hierarchy.operator_version() ||
        !active.is_equal(new_active, hierarchy.finest().nodes.n_owned()))
      return false;
    // Cycles are dear to make: a change below the diagonal of the matrix is not
    // worth it.
    const std::vector<unsigned int> &nodes = hierarchy.finest().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double size = hessians[k].norm() +
                            hierarchy.matrix().diagonal_block(nodes[k]).norm();
        // Written so that a NaN is not close.
        if (!((new_hessians[k] - hessians[k]).norm() <=
              parameters.coarse_update_threshold * size))
          return false;
      }
    return true;
  }



  template <int n_components>
  void
  AMGCorrection<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &new_hessians,
    const NodeMask                             &new_active)
  {
    cg.linearise(new_hessians, new_active);
    if (is_close(new_hessians, new_active))
      return;
    version  = hierarchy.operator_version();
    active   = new_active;
    hessians = new_hessians;

    if (!cycles.set_matrix(linearised_matrix(hierarchy, hessians), active))
      throw SingularMatrix("the linearised matrix");
  }



  template <int n_components>
  unsigned int
  AMGCorrection<n_components>::solve(NodalVector &x,
                                     NodalVector &A_x,
                                     NodalVector &r)
  {
    constexpr unsigned int max_steps = 200;

    return cg.solve(
      [&](NodalVector &z, const NodalVector &b) {
        cycles.vmult(z, b);
        active.apply(z);
      },
      max_steps,
      parameters.amg_tolerance,
      x,
      A_x,
      r);
  }



  template class AMGCorrection<1>;
  template class AMGCorrection<2>;
  template class AMGCorrection<3>;
} // namespace StickSlip
