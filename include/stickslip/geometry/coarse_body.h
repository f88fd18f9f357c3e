// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_coarse_body_h
#define stickslip_geometry_coarse_body_h

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <stickslip/geometry/body_geometry.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The cells of a body before any refinement, the names of its sides, and how
   * it is to be refined.
   */
  template <int dim>
  struct CoarseBody
  {
    /** Indicators of the sides of a brick across the vertical axis. */
    static constexpr types::boundary_id lower_side = 2 * (dim - 1);
    static constexpr types::boundary_id upper_side = 2 * (dim - 1) + 1;

    /** Cells of one shape, none of them refined; boundary indicators are those
     * of the sides. Their manifolds say where refinement puts vertices, see
     * set_shapes(). */
    std::shared_ptr<const Triangulation<dim>> cells;

    /** Coarser cells of the same body, whose sides have the same indicators,
     * finest first: levels of the multigrid method below the cells above. They
     * need not be nested. */
    std::vector<std::shared_ptr<const Triangulation<dim>>> coarser_cells;

    /** Names of the sides by boundary indicator. */
    std::map<types::boundary_id, std::string> side_names;

    /** Sides that each process needs as a whole beside those at faults, since
     * their directions are asked for. */
    std::set<types::boundary_id> whole_sides;

    /** Number of refinements of all cells, then of passes that refine the cells
     * touching a fault, and of rows of cells that each of them refines. */
    unsigned int uniform_refinements = 0;
    unsigned int refinement_passes   = 0;
    unsigned int refinement_rows     = 1;

    /** Function of the position that is greater than zero where the passes
     * refine; empty: everywhere. */
    std::function<double(const Point<dim> &)> refine_where;

    /** Cells that are refined as well. */
    std::set<CellId> refined_cells;

    /** True if the body does not deform; it is not refined then. */
    bool rigid = false;

    /** True if all nodes of the cells that one cell was refined into couple to
     * each other, see CellPatches. */
    bool couples_patches = false;

    /** Length after which fields repeat along each horizontal axis, m; zero:
     * the body ends there. Sides have the indicators of a brick if any is
     * not zero. */
    Tensor<1, dim - 1> period;

    /** Lower end along each axis on which fields repeat, m. */
    std::array<double, dim - 1> lateral_lower = {};
  };

  /** Names of the sides of a brick by boundary indicator: left, right, (front,
   * back,) bottom, top. */
  template <int dim>
  std::map<types::boundary_id, std::string>
  brick_side_names();

  /** The coarse cells of a brick. Sides have the indicators of deal.II's
   * bricks: 2 d and 2 d + 1 are the lower and the upper one across axis d.
   * Sides with an elevation have it on all levels of refinement, and what is
   * inside follows. */
  template <int dim>
  CoarseBody<dim>
  coarse_brick(const BodyGeometry<dim> &geometry);
} // namespace StickSlip

#endif
