// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_restraint_h
#define stickslip_simulation_restraint_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Without inertia a body that no side holds along the faults is held by
   * friction and radiation damping alone. Throws InputError if there is
   * neither on a way to a body that is held: the velocity of such a body would
   * not be determined. @p state: at the start.
   */
  template <int dim>
  void
  check_restraint(const SceneParameters<dim> &scene,
                  const FaultNodes<dim>      &faults,
                  const NodeLaws             &laws,
                  const SystemState<dim>     &state);

  /** One more sentence for a run without mass that could not go on: which fault
   * is open so far that a body is about to lose its hold; if none is, and there
   * is no damping, that slip rates can grow. Empty where neither explains it.
   */
  template <int dim>
  std::string
  explain_failure(const SceneParameters<dim> &scene,
                  const FaultNodes<dim>      &faults,
                  const SystemState<dim>     &state);
} // namespace StickSlip

#endif
