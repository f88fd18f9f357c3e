// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_red_refinement_h
#define stickslip_mesh_red_refinement_h

#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A mesh of tetrahedra each of which is one of eight parts of a coarser one:
   * four at the corners, and four around the shortest diagonal of the
   * octahedron between these. That choice keeps the shape of the cells; deal.II
   * always takes the same diagonal, with which they degenerate.
   *
   * New vertices are in the middle of edges, or on the shape that these have,
   * see set_shapes(). Throws InputError if a cell is inverted by that.
   *
   * Of some cells only, if asked for: nothing is left of the others, and faces
   * between both have the indicator PartialMesh::cut_side.
   */
  struct RedRefinement
  {
    /** A mesh without any refinement of deal.II's. Boundary indicators are
     * those of the coarser mesh. */
    std::shared_ptr<const Triangulation<3>> mesh;

    /** For each vertex the ends of the coarse edge of which it is the middle; a
     * vertex of the coarser mesh twice itself. Vertices of the coarser mesh
     * have the same numbers in both, also those that no cell has any more. */
    std::vector<std::array<unsigned int, 2>> parents;

    RedRefinement() = default;

    /** @p is_refined: for each cell; empty: all are. */
    explicit RedRefinement(const Triangulation<3>  &coarse,
                           const std::vector<bool> &is_refined = {});
  };
} // namespace StickSlip

#endif
