// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_fault_shapes_h
#define stickslip_simulation_fault_shapes_h

#include <stickslip/mortar/jump_basis.h>
#include <stickslip/output/fault_shape.h>

namespace StickSlip
{
  /** The surfaces of all faults and the axes of their nodes at the present
   * contact mapping, in the form in which they are written. */
  template <int dim>
  std::vector<FaultShape<dim>>
  make_fault_shapes(const JumpBasis<dim> &basis);

  /** The positions of the slave nodes of all faults after a displacement, m, by
   * fault and node. Collective. */
  template <int dim>
  std::vector<std::vector<Point<dim>>>
  fault_positions(const JumpBasis<dim> &basis,
                  const NodePartition  &nodes,
                  const NodalVector    &displacement);
} // namespace StickSlip

#endif
