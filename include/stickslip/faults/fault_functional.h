// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_fault_functional_h
#define stickslip_faults_fault_functional_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/friction/fault_friction.h>

namespace StickSlip
{
  /**
   * The functional of friction and radiation damping, with a term for each node
   * of FaultNodes::owned_contact(). @p normal_stress: at each slave node, Pa.
   * The state is alpha = 0 until FaultFriction::set_state() is called.
   */
  template <int dim, int n_components = dim>
  std::unique_ptr<FaultFriction<n_components>>
  make_fault_friction(const FaultNodes<dim>     &nodes,
                      const NodeLaws            &laws,
                      const std::vector<double> &normal_stress);
} // namespace StickSlip

#endif
