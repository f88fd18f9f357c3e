// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <stickslip/multigrid/linearised_operator.h>
#include <stickslip/problem/stiffness_solution.h>

namespace StickSlip
{
  template <int dim, int n_components>
  unsigned int
  solve_stiffness(SpatialProblem<dim, n_components> &problem,
                  const NodeMask                    &active,
                  const NodalVector                 &load,
                  const double                       reduction,
                  NodalVector                       &w)
  {
    constexpr unsigned int max_iterations = 1000;

    LevelHierarchy<n_components> &hierarchy = problem.hierarchy();

    std::vector<double> coefficients(3, 0.);
    coefficients[SpatialProblem<dim, n_components>::stiffness] = 1.;
    problem.combine(coefficients);
    hierarchy.linearise(std::vector<Tensor<2, n_components>>(
                          hierarchy.finest().nonsmooth_nodes.size()),
                        active);

    NodalVector residual = problem.make_vector(), change = residual;
    problem.operators().matrix().residual(residual, load, w);
    active.apply(residual);
    // Without a load nothing is solved, and the control has no last step.
    if (!(residual.l2_norm() > 0.))
      return 0;
    SolverControl control(max_iterations, reduction * residual.l2_norm());
    SolverCG<NodalVector>(control).solve(
      LinearisedOperator<n_components>{hierarchy},
      change,
      residual,
      CyclePreconditioner<n_components>{hierarchy});
    w += change;
    return control.last_step();
  }



  template decltype(solve_stiffness<2, 1>) solve_stiffness<2, 1>;
  template decltype(solve_stiffness<2, 2>) solve_stiffness<2, 2>;
  template decltype(solve_stiffness<3, 3>) solve_stiffness<3, 3>;
} // namespace StickSlip
