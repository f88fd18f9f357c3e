// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_tree_order_h
#define stickslip_mesh_tree_order_h

#include <deal.II/dofs/dof_handler.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Number the degrees of freedom of a mesh, one at each vertex, tree by tree
   * in the order of the first cell that has them. Returns the numbers of the
   * active cells in that order, see for_each_leaf().
   */
  template <int dim>
  std::vector<unsigned int>
  number_by_trees(DoFHandler<dim> &dofs);
} // namespace StickSlip

#endif
