// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/nonsmooth_solver.h>

#include <cmath>

namespace StickSlip
{
  template <int n_components>
  NonsmoothSolver<n_components>::NonsmoothSolver(
    const TNNMGParameters &parameters)
    : parameters(parameters)
  {}



  template <int n_components>
  SolveSummary
  NonsmoothSolver<n_components>::solve(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    SolveSummary summary;
    start(b, w);
    while (!summary.converged &&
           summary.iterations.size() < parameters.max_iterations)
      {
        summary.iterations.push_back(iterate(functional, b, w));
        if (!std::isfinite(summary.iterations.back().correction_norm))
          break;
        const auto last   = summary.iterations.rbegin();
        summary.converged = has_converged(
          *last, summary.iterations.size() > 1 ? &*std::next(last) : nullptr);
      }
    finish(b, w);
    return summary;
  }



  template <int n_components>
  bool
  NonsmoothSolver<n_components>::has_converged(
    const IterationSummary &last,
    const IterationSummary *before) const
  {
    return last.relative_error(before) <= parameters.tolerance;
  }



  template class NonsmoothSolver<1>;
  template class NonsmoothSolver<2>;
  template class NonsmoothSolver<3>;
} // namespace StickSlip
