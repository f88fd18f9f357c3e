// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_fault_stiffness_h
#define stickslip_problem_fault_stiffness_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/problem/spatial_problem.h>

#include <vector>

namespace StickSlip
{
  /**
   * The stiffness of the bodies against slip of some nodes, Pa/m: a unit of
   * shear traction along the first axis of the faults at all these nodes over
   * the mean slip that it causes there, in static equilibrium with all other
   * nodes of faults stuck and driven sides held. It is what the stiffness of
   * the spring is to a slider; of a crack of length l in a large body it is
   * 4 G* / (pi l).
   *
   * @param slips One entry for each slave node; nodes off contact do not count.
   *
   * Returns zero if no node slips, or if only they hold a body. Changes the
   * combination of matrices of the problem. Collective.
   */
  template <int dim, int n_components = dim>
  double
  slip_stiffness(SpatialProblem<dim, n_components> &problem,
                 const FaultNodes<dim>             &faults,
                 const std::vector<bool>           &slips);
} // namespace StickSlip

#endif
