// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/multigrid_correction.h>

namespace StickSlip
{
  template <int dim>
  MultigridCorrection<dim>::MultigridCorrection(
    LevelHierarchy<dim>   &hierarchy,
    const TNNMGParameters &parameters)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , cg(hierarchy)
  {
    hierarchy.set_smoothing_sweeps(parameters.smoothing_sweeps);
    hierarchy.set_coarse_update_threshold(parameters.coarse_update_threshold);
    hierarchy.set_coarse_solver(parameters.coarse_solver);
  }



  template <int dim>
  void
  MultigridCorrection<dim>::linearise(
    const std::vector<Tensor<2, dim>> &hessians,
    const NodeMask                    &active)
  {
    cg.linearise(hessians, active);
    hierarchy.linearise(hessians, active);
  }



  template <int dim>
  unsigned int
  MultigridCorrection<dim>::solve(NodalVector &x,
                                  NodalVector &A_x,
                                  NodalVector &r)
  {
    return cg.solve([&](NodalVector       &z,
                        const NodalVector &b) { hierarchy.v_cycle(z, b); },
                    parameters.cycles_per_correction,
                    /*reduction=*/0.,
                    x,
                    A_x,
                    r);
  }



  template class MultigridCorrection<2>;
  template class MultigridCorrection<3>;
} // namespace StickSlip
