// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_excluded_nodes_h
#define stickslip_mortar_excluded_nodes_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mortar/fault_sides.h>

#include <vector>

namespace StickSlip
{
  /**
   * The slave nodes of each fault of a level that are no contact nodes,
   * whatever faces them: crosspoints, and nodes with a component that is masked
   * in @p dirichlet, which is at least over the owned nodes of the level.
   * @p sides: one entry a fault. Collective.
   */
  template <int dim>
  std::vector<std::vector<bool>>
  excluded_nodes(const MeshLevel<dim>          &level,
                 const std::vector<FaultSides> &sides,
                 const NodeMask                &dirichlet);
} // namespace StickSlip

#endif
