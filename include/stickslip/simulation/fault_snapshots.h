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
   *
   * @p tractions: shear tractions at all nodes, slave relative to master, Pa.
   * @p may_open: which faults have gaps, by fault; empty: all, if the state has
   * any.
   */
  template <int dim>
  std::vector<FaultSnapshot<dim>>
  make_fault_snapshots(const SystemState<dim>                &state,
                       const FaultNodes<dim>                 &nodes,
                       const std::vector<Tensor<1, dim - 1>> &tractions,
                       const JumpBasis<dim>                  &basis,
                       const std::vector<std::string>        &names,
                       const std::vector<bool>               &may_open = {});
} // namespace StickSlip

#endif
