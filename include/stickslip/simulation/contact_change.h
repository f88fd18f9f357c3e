// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_contact_change_h
#define stickslip_simulation_contact_change_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * True if a node has slid further between two slips, m, than this fraction of
   * the smallest face of any fault.
   */
  template <int dim>
  bool
  has_slid(const JumpBasis<dim>                  &basis,
           const std::vector<Tensor<1, dim - 1>> &slip,
           const std::vector<Tensor<1, dim - 1>> &since,
           const double                           fraction);

  /**
   * Carry a state over to a new contact mapping, that of @p space and
   * @p now. Slip rates belong to the nodes of the fault and stay; the velocity
   * of the slave side follows from them and from the new partners. Nodes that
   * come into contact get the jump of the velocities as they are. Collective.
   */
  template <int dim>
  void
  change_contact(SystemState<dim>        &state,
                 const ContactSpace<dim> &space,
                 const FaultNodes<dim>   &before,
                 const FaultNodes<dim>   &now);
} // namespace StickSlip

#endif
