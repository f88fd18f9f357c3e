// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_body_sides_h
#define stickslip_mesh_body_sides_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <stickslip/mesh/fault_surface.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** A face on a side of a body, by the numbers of its nodes; in the last place
   * of a triangle is an invalid one. */
  template <int dim>
  struct SideFace
  {
    static constexpr unsigned int n_vertices =
      GeometryInfo<dim>::vertices_per_face;

    std::array<types::global_dof_index, n_vertices>  nodes;
    std::array<Point<dim>, n_vertices>               positions;
    std::array<std::array<int, dim - 1>, n_vertices> wraps;

    /** Normal out of the body, as long as the face is large, m^(dim-1). */
    Tensor<1, dim> outward;
  };



  /** The surface of the faces on one side, in any order and as often as may be.
   * @p period: see FaultSurface. */
  template <int dim>
  FaultSurface<dim>
  surface_of_faces(const std::vector<SideFace<dim>> &faces,
                   const Tensor<1, dim - 1>         &period);



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

    /** The faces on one side of the cells that @p is_wanted; nodes have the
     * numbers of their degrees of freedom, and positions are those of nodes. */
    std::vector<SideFace<dim>>
    faces(
      const types::boundary_id                                side,
      const std::function<bool(
        const typename Triangulation<dim>::cell_iterator &)> &is_wanted) const;

  private:
    /** The degree of freedom that stands for the vertex of a side and its
     * images, and how many periods the vertex lies from it. */
    std::pair<types::global_dof_index, std::array<int, dim - 1>>
    node_of_vertex(const types::global_dof_index dof,
                   const Point<dim>             &vertex) const;
  };
} // namespace StickSlip

#endif
