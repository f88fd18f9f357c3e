// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_contact_components_h
#define stickslip_problem_contact_components_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/jump_basis.h>

#include <functional>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Points of a fault in the reference configuration that may open, among some;
   * an empty function where none may.
   */
  template <int dim>
  using OpeningParts =
    std::function<std::vector<bool>(const std::vector<Point<dim>> &)>;

  /**
   * The components of @p nodes, with the ghosts of the jump basis, that never
   * take part: those that @p dirichlet masks among the owned ones, those of
   * hanging nodes, the jumps at the nodes @p prescribed_slip, and the normal
   * jumps, which are zero, but for those of the nodes @p opening (both
   * ascending, by their global numbers). Where the only component is that out
   * of the plane, there is no normal one. Collective among neighbours.
   */
  template <int dim>
  NodeMask
  fixed_components(const MeshLevel<dim>                       &level,
                   const NodePartition                        &nodes,
                   const NodeMask                             &dirichlet,
                   const JumpBasis<dim>                       &basis,
                   const std::vector<types::global_dof_index> &prescribed_slip,
                   const std::vector<types::global_dof_index> &opening);
} // namespace StickSlip

#endif
