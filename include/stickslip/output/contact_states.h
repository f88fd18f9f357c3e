// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_contact_states_h
#define stickslip_output_contact_states_h

#include <stickslip/output/fault_snapshot.h>

namespace StickSlip
{
  /**
   * The state of contact of each node of a fault; none where it may not open.
   * Nodes slip that are neither open nor bonded and faster than @p slip_rate,
   * m/s.
   */
  template <int dim>
  std::vector<ContactState>
  contact_states(const FaultSnapshot<dim> &fault, const double slip_rate);
} // namespace StickSlip

#endif
