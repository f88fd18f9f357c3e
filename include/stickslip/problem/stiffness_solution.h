// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_stiffness_solution_h
#define stickslip_problem_stiffness_solution_h

#include <stickslip/problem/spatial_problem.h>

namespace StickSlip
{
  /**
   * Solve K w = load, in the jump basis, for the components that are active in
   * @p active; all others stay as they are in @p w. By CG with a V-cycle, until
   * the residual has fallen by the factor @p reduction.
   *
   * Returns the number of iterations. Throws SingularCoarseMatrix if nothing
   * holds a body, SolverControl::NoConvergence after 1000 iterations. Changes
   * the operator and its linearisation. Collective.
   */
  template <int dim, int n_components>
  unsigned int
  solve_stiffness(SpatialProblem<dim, n_components> &problem,
                  const NodeMask                    &active,
                  const NodalVector                 &load,
                  const double                       reduction,
                  NodalVector                       &w);
} // namespace StickSlip

#endif
