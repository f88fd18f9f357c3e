// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_hanging_nodes_h
#define stickslip_mesh_hanging_nodes_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Add the constraints of the nodes that hang on real cells, one degree of
   * freedom at each vertex, and not those of nodes that hang on cells which
   * stand in for finer ones. @p is_real: for each active cell.
   */
  template <int dim>
  void
  add_hanging_nodes(const DoFHandler<dim>     &dofs,
                    const std::vector<bool>   &is_real,
                    AffineConstraints<double> &constraints);
} // namespace StickSlip

#endif
