// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_initial_balance_h
#define stickslip_simulation_initial_balance_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Shear stress over normal stress of one fault at the start, without unit,
   * over nodes in contact with friction that are pressed together.
   */
  struct InitialBalance
  {
    double least = 0., greatest = 0.;

    /** Sizes of shear forces over normal forces, both summed over the nodes and
     * those that nothing presses together; infinite where the sum is tension.
     */
    double mean = 0.;

    /** The node of the greatest ratio, by its position among all slave nodes.
     */
    unsigned int node = 0;

    /** False if there is no such node. */
    bool is_known = false;
  };

  /** @p state: before the first step, while the faults are stuck. */
  template <int dim>
  InitialBalance
  initial_balance(const FaultNodes<dim>  &faults,
                  const NodeLaws         &laws,
                  const SystemState<dim> &state,
                  const unsigned int      fault);

  /**
   * Sentences on faults that friction does not hold at the start: their shear
   * stress takes a slip rate of more than 1 m/s, or the state leaves no
   * friction below that. A run that fails in its first step mostly does for
   * that.
   */
  template <int dim>
  std::vector<std::string>
  what_friction_does_not_hold(const SceneParameters<dim>    &scene,
                              const FaultNodes<dim>         &faults,
                              const std::vector<Point<dim>> &points,
                              const NodeLaws                &laws,
                              const SystemState<dim>        &state);
} // namespace StickSlip

#endif
