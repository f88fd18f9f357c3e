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
        summary.converged = has_converged(summary.iterations.back());
      }
    finish(b, w);
    return summary;
  }



  template <int dim>
  bool
  NonsmoothSolver<dim>::has_converged(const IterationSummary &summary) const
  {
    return summary.relative_correction() <= parameters.tolerance;
  }



  template class NonsmoothSolver<2>;
  template class NonsmoothSolver<3>;
} // namespace StickSlip
