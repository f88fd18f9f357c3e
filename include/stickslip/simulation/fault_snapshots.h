// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_fault_snapshots_h
#define stickslip_simulation_fault_snapshots_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * The fields of all faults, with @p names, in the form in which they are
   * written: of the upper body relative to the lower one, along x.
   */
  template <int dim>
  std::vector<FaultSnapshot<dim>>
  make_fault_snapshots(const SystemState<dim>         &state,
                       const FaultNodes<dim>          &nodes,
                       const JumpBasis<dim>           &basis,
                       const std::vector<std::string> &names);

  /** The largest slip rate of any node in contact, m/s. */
  template <int dim>
  double
  largest_slip_rate(const SystemState<dim> &state);

  /** The largest distance that any node has slid between two states, m. */
  template <int dim>
  double
  largest_slip(const SystemState<dim>                &state,
               const std::vector<Tensor<1, dim - 1>> &since);
} // namespace StickSlip

#endif
