// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_contact_pressure_h
#define stickslip_faults_contact_pressure_h

#include <stickslip/mortar/jump_basis.h>

#include <vector>

namespace StickSlip
{
  /**
   * The contact pressure at each slave node, fault after fault, Pa, compression
   * positive: the force that keeps the normal jump at zero over the node's
   * weight. Slave nodes off contact have the value of the nearest node in
   * contact. Zero where bodies move out of the plane, which presses nothing.
   *
   * @p reaction: a dual vector of the jump basis, the forces that the normal
   * constraint exerts, partitioned as @p nodes. Collective.
   */
  template <int dim>
  std::vector<double>
  contact_pressures(const JumpBasis<dim> &basis,
                    const NodePartition  &nodes,
                    const NodalVector    &reaction);
} // namespace StickSlip

#endif
