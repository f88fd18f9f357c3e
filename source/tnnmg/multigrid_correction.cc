// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/multigrid_correction.h>

#include <algorithm>

namespace StickSlip
{
  template <int n_components>
  MultigridCorrection<n_components>::MultigridCorrection(
    LevelHierarchy<n_components> &hierarchy,
    const TNNMGParameters        &parameters)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , cg(hierarchy.operators())
  {
    hierarchy.set_smoothing_sweeps(
      static_cast<unsigned int>(parameters.smoothing_sweeps));
    hierarchy.set_coarse_update_threshold(parameters.coarse_update_threshold);
    hierarchy.set_coarse_solver(parameters.coarse_solver);
    hierarchy.set_cycle_precision(parameters.cycle_precision);
  }



  template <int n_components>
  void
  MultigridCorrection<n_components>::start()
  {
    n_solved = 0;
  }



  template <int n_components>
  bool
  MultigridCorrection<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &hessians,
    const NodeMask                             &active)
  {
    cg.linearise(hessians, active);
    return hierarchy.linearise_finest_level(hessians, active);
  }



  template <int n_components>
  unsigned int
  MultigridCorrection<n_components>::solve(NodalVector &x,
                                           NodalVector &A_x,
                                           NodalVector &r,
                                           const double norm,
                                           const bool   is_outdated)
  {
    hierarchy.linearise_coarse_levels(is_outdated);
    const bool is_single     = n_solved++ < parameters.single_cycle_corrections;
    const unsigned int least = is_single ? 1 : parameters.cycles_per_correction;
    const unsigned int most  = is_single || parameters.linear_reduction == 1. ?
                                 least :
                                 std::max(least, 100u);
    return cg.solve(
      [&](NodalVector &z, const NodalVector &b) {
        hierarchy.v_cycle(z, b, norm);
      },
      least,
      most,
      parameters.linear_reduction,
      x,
      A_x,
      r);
  }



  template <int n_components>
  std::vector<KeptLinearisation<n_components>>
  MultigridCorrection<n_components>::kept_linearisations() const
  {
    return {hierarchy.kept_linearisation()};
  }



  template <int n_components>
  void
  MultigridCorrection<n_components>::recall(
    const KeptLinearisation<n_components> &kept)
  {
    hierarchy.recall(kept);
  }



  template class MultigridCorrection<1>;
  template class MultigridCorrection<2>;
  template class MultigridCorrection<3>;
} // namespace StickSlip
