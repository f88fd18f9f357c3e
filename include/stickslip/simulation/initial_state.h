// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_state_h
#define stickslip_simulation_initial_state_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/problem/initial_equilibrium.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * The normal stress at all slave nodes from the source that each fault
   * names, Pa. A negative contact pressure counts as zero: a bilateral fault
   * can be under tension, but then has no friction. The number of those that
   * would have some is added to @p n_in_tension.
   */
  template <int dim>
  std::vector<double>
  make_normal_stress(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium,
                     unsigned int                  &n_in_tension);

  /**
   * The state at t = 0: the static equilibrium at rest, with the initial state
   * of each fault.
   */
  template <int dim>
  SystemState<dim>
  make_initial_state(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium);
} // namespace StickSlip

#endif
