// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_body_sides_h
#define stickslip_mesh_body_sides_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <stickslip/mesh/fault_surface.h>

#include <array>
#include <utility>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The sides of the mesh of a body, whose nodes are those of linear functions.
   * The object refers to its arguments.
   */
  template <int dim>
  struct BodySides
  {
    const DoFHandler<dim>           &dofs;
    const AffineConstraints<double> &constraints;

    /** Lower end of the body, and its length along periodic axes, m. */
    const std::array<double, dim - 1> &lateral_lower;
    const Tensor<1, dim - 1>          &period;

    /** The faces and nodes on one side; nodes have the numbers of their degrees
     * of freedom. */
    FaultSurface<dim>
    surface(const types::boundary_id side) const;

  private:
    /** The degree of freedom that stands for the vertex of a side and its
     * images, and how many periods the vertex lies from it. */
    std::pair<types::global_dof_index, std::array<int, dim - 1>>
    node_of_vertex(const types::global_dof_index dof,
                   const Point<dim>             &vertex) const;
  };
} // namespace StickSlip

#endif
