// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/nonsmooth_solver.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  NonsmoothSolver<dim>::NonsmoothSolver(const TNNMGParameters &parameters)
    : parameters(parameters)
  {}



  template <int dim>
  SolveSummary
  NonsmoothSolver<dim>::solve(const NonsmoothFunctional<dim> &functional,
                              const NodalVector              &b,
                              NodalVector                    &w)
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



  template <int dim>
  bool
  NonsmoothSolver<dim>::has_converged(const IterationSummary &last,
                                      const IterationSummary *before) const
  {
    return last.relative_error(before) <= parameters.tolerance;
  }



  template class NonsmoothSolver<2>;
  template class NonsmoothSolver<3>;
} // namespace StickSlip
