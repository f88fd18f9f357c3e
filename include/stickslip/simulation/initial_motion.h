// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_motion_h
#define stickslip_simulation_initial_motion_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Let the faults start with the slip rate and the shear stress that the scene
   * gives, in equilibrium (complete_start()): sets state, slip rate and shear
   * traction of @p state at their nodes, and velocities of the bodies that
   * belong to the rates of slip and of boundary conditions, as in a sequence of
   * static equilibria. What the bodies do not carry of the shear stress becomes
   * a prestress of the @p problem.
   *
   * Returns that prestress, see RunState; empty, with nothing changed, if the
   * scene gives no such thing. Throws InputError where what is given has a
   * contradiction in it. Collective.
   */
  template <int dim, int n_components = dim>
  std::vector<Tensor<1, dim - 1>>
  start_motion(const SceneParameters<dim>        &scene,
               const FaultNodes<dim>             &faults,
               const NodeLaws                    &laws,
               SpatialProblem<dim, n_components> &problem,
               SystemState<dim>                  &state);
} // namespace StickSlip

#endif
