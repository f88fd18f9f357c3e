// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_crosspoints_h
#define stickslip_mortar_crosspoints_h

#include <stickslip/mesh/mesh_level.h>

namespace StickSlip
{
  /**
   * The nodes of a level, ascending, that are on more than one of the sides of
   * its first @p n_faults faults: where a fault ends at another one, where
   * faults cross, and where a fault ends inside a body, both sides of which
   * have its last node in common. No jump belongs to them; the nodes next to
   * them take over their dual functions.
   */
  template <int dim>
  std::vector<types::global_dof_index>
  crosspoints(const MeshLevel<dim> &level, const unsigned int n_faults);
} // namespace StickSlip

#endif
