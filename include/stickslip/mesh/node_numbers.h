// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_node_numbers_h
#define stickslip_mesh_node_numbers_h

#include <deal.II/base/types.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Owners and numbers of the nodes of a body on one level. Nodes of the whole
   * mesh are counted, and those that are here are listed by their degree of
   * freedom; what is invalid is no node of the whole mesh, or not known here.
   */
  struct NodeNumbers
  {
    /** Numbers of nodes of the whole mesh: all, and those of each process. */
    types::global_dof_index              n_nodes = 0;
    std::vector<types::global_dof_index> n_owned;

    /** The process of each node; its serial number, which it has on one
     * process; and its place among the nodes of its owner in serial order. */
    std::vector<unsigned int>            owner;
    std::vector<types::global_dof_index> serial, place;
  };



  /** Numbers of a mesh that is here as a whole, from the @p owner of each
   * node. */
  NodeNumbers
  number_whole_mesh(const std::vector<unsigned int> &owner,
                    const unsigned int               n_processes);
} // namespace StickSlip

#endif
