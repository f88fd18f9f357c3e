// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_contact_components_h
#define stickslip_problem_contact_components_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/jump_basis.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The components that never take part: those that @p dirichlet masks, those
   * of hanging nodes, the normal jumps, which are zero, and the jumps at the
   * nodes @p prescribed_slip (ascending). Over the global numbers of all nodes.
   */
  template <int dim>
  NodeMask
  fixed_components(const MeshLevel<dim>                       &level,
                   const NodeMask                             &dirichlet,
                   const JumpBasis<dim>                       &basis,
                   const std::vector<types::global_dof_index> &prescribed_slip);

  /** The slave nodes of all faults, global numbers in ascending order. */
  template <int dim>
  std::vector<unsigned int>
  slave_nodes_of_all_faults(const JumpBasis<dim> &basis);

  /**
   * The nodes whose rows in the transfer from level l - 1 to @p l can depend on
   * the contact mapping, in ascending order; @p bases: those of all levels. On
   * one process, where local and global numbers are the same.
   */
  template <int dim>
  std::vector<unsigned int>
  rows_near_faults(const MeshHierarchy<dim>          &meshes,
                   const unsigned int                 l,
                   const std::vector<JumpBasis<dim>> &bases);
} // namespace StickSlip

#endif
