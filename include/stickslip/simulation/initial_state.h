// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_state_h
#define stickslip_simulation_initial_state_h

#include <stickslip/problem/initial_equilibrium.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * The state at t = 0: the static equilibrium at rest, with the initial state
   * of each fault and the normal stress from the source that each fault names.
   * A negative contact pressure counts as zero: a bilateral fault can be under
   * tension, but then has no friction. The number of nodes that would have some
   * is added to @p n_in_tension.
   */
  template <int dim>
  SystemState<dim>
  make_initial_state(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium,
                     unsigned int                  &n_in_tension);
} // namespace StickSlip

#endif
