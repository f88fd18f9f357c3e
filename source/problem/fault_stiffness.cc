// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_control.h>

#include <stickslip/problem/fault_stiffness.h>
#include <stickslip/problem/stiffness_solution.h>

#include <set>

namespace StickSlip
{
  template <int dim, int n_components>
  double
  slip_stiffness(SpatialProblem<dim, n_components> &problem,
                 const FaultNodes<dim>             &faults,
                 const std::vector<bool>           &slips)
  {
    constexpr double reduction = 1e-6;

    const LevelDescription<n_components> &finest = problem.hierarchy().finest();

    std::set<unsigned int> free_nodes;
    NodalVector            load = problem.make_vector();
    for (const unsigned int k : faults.owned_contact())
      if (slips[k])
        {
          free_nodes.insert(faults.node(k));
          load.local_element(faults.node(k) * n_components) =
            faults.weights()[k];
        }
    double area = 0.;
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (slips[k] && faults.in_contact(k))
        area += faults.weights()[k];
    if (area == 0.)
      return 0.;
    NodeMask active = finest.fixed;
    for (const unsigned int p : finest.nonsmooth_nodes)
      if (free_nodes.count(p) == 0)
        active.mask_node(p);
      else if (n_components == dim && active.is_active(p, dim - 1))
        active.mask(p, dim - 1);

    NodalVector w = problem.make_vector();
    try
      {
        solve_stiffness(problem, active, load, reduction, w);
      }
    catch (const SolverControl::NoConvergence &)
      {
        return 0.;
      }
    catch (const SingularCoarseMatrix &)
      {
        return 0.;
      }
    const std::vector<Tensor<1, dim - 1>> slip = faults.tangential_jumps(w);
    double                                sum  = 0.;
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (slips[k] && faults.in_contact(k))
        sum += faults.weights()[k] * slip[k][0];
    return sum > 0. ? area / sum : 0.;
  }



#define STICKSLIP_INSTANTIATE(dim, n_components)     \
  template double slip_stiffness<dim, n_components>( \
    SpatialProblem<dim, n_components> &,             \
    const FaultNodes<dim> &,                         \
    const std::vector<bool> &);

  STICKSLIP_INSTANTIATE(2, 1)
  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
} // namespace StickSlip
