// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_partial_mesh_h
#define stickslip_mesh_partial_mesh_h

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Some active cells of a mesh as a mesh of their own, all of them coarse
   * cells. Sides keep their boundary indicators; faces to cells that are
   * missing, and between cells of different size, have the indicator
   * @p cut_side.
   */
  template <int dim>
  struct PartialMesh
  {
    static constexpr types::boundary_id cut_side =
      numbers::internal_face_boundary_id - 1;

    /** @p is_kept by the numbers of active cells; one at least is. */
    PartialMesh(const Triangulation<dim> &whole,
                const std::vector<bool>  &is_kept);

    std::shared_ptr<const Triangulation<dim>> mesh;

    /** Numbers in the whole mesh of the vertices, and of the active cells. */
    std::vector<unsigned int> vertices, cells;
  };
} // namespace StickSlip

#endif
