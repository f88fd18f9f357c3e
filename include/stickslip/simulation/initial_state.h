// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_state_h
#define stickslip_simulation_initial_state_h

#include <stickslip/faults/node_opening.h>
#include <stickslip/problem/initial_equilibrium.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * The state at t = 0 and what there is to say of it.
   */
  template <int dim>
  struct InitialState
  {
    SystemState<dim> system;

    /** Normal stress less contact pressure at each slave node, Pa. */
    std::vector<double> stress_offset;

    /** Number of nodes that would have friction but are under tension. */
    unsigned int n_in_tension = 0;
  };

  /**
   * The state at t = 0: the static equilibrium at rest, with the initial state
   * of each fault and the normal stress from the source that each fault names.
   * A negative contact pressure counts as zero: a bilateral fault can be under
   * tension, but then has no friction. A node that may open does so; @p
   * openings: of each slave node, or empty if none may.
   */
  template <int dim>
  InitialState<dim>
  make_initial_state(const SceneParameters<dim>     &scene,
                     const JumpBasis<dim>           &basis,
                     const InitialEquilibrium<dim>  &equilibrium,
                     const std::vector<NodeOpening> &openings = {});
} // namespace StickSlip

#endif
