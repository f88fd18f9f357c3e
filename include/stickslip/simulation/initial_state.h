// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_state_h
#define stickslip_simulation_initial_state_h

#include <stickslip/simulation/scene_parameters.h>
#include <stickslip/time/fault_nodes.h>
#include <stickslip/time/initial_equilibrium.h>
#include <stickslip/time/system_state.h>

namespace StickSlip
{
  /**
   * The friction laws of all slave nodes, from bottom to top. Nodes of a fault
   * with the same parameters share one. With the radiation damping of plane
   * shear waves into both bodies (Rice 1993), as they are at the node, if the
   * scene is quasi-dynamic.
   */
  template <int dim>
  NodeLaws
  make_node_laws(const SceneParameters<dim> &scene,
                 const JumpBasis<dim>       &basis);

  /**
   * The normal stress at all slave nodes from the source that each fault
   * names, Pa. A negative contact pressure counts as zero: a bilateral fault
   * can be under tension, but then has no friction. Their number is added to
   * @p n_in_tension.
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
