// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_impact_h
#define stickslip_time_impact_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/problem/spatial_problem.h>

#include <vector>

namespace StickSlip
{
  /**
   * Let sides that touch neither part nor approach: velocities @p w of the
   * jump basis become the next ones, in the norm of the mass, whose normal
   * jump vanishes at the nodes that are @p touching; those that are prescribed
   * stay. This is what an inelastic impact does, and keeps the pressure from
   * oscillating from step to step. Returns the kinetic energy that it takes,
   * J, never negative.
   *
   * Solved by CG to a relative residual of 1e-12; the mass needs about fifty
   * iterations at most. Nothing happens where all these jumps are zero. Throws
   * SolverControl::NoConvergence. Collective.
   */
  template <int dim, int n_components = dim>
  double
  stop_impacts(const SpatialProblem<dim, n_components> &problem,
               const FaultNodes<dim>                   &faults,
               const std::vector<bool>                 &touching,
               NodalVector                             &w);
} // namespace StickSlip

#endif
