// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_mesh_share_h
#define stickslip_mesh_mesh_share_h

#include <deal.II/grid/tria.h>

#include <stickslip/mesh/red_refinement.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** The name of a cell on all processes: its unit, and its path below it, a
   * one and then the number of the child on each level in as many bits as the
   * dimension. */
  using CellName = std::pair<unsigned int, std::uint64_t>;

  /** The share of a process in a mesh that is nowhere as a whole, see
   * UnitRefinement. Units are counted tree by tree. */
  template <int dim>
  struct MeshShare
  {
    /** Cells of the whole mesh, and, where cells are trees, others that stand
     * in for those elsewhere. */
    std::shared_ptr<const Triangulation<dim>> mesh;

    /** For each active cell, if it is one of the whole mesh that the process
     * needs. */
    std::vector<bool> is_real;

    /** Names of the real cells tree by tree, and the level and index of each.
     */
    std::vector<CellName>            names;
    std::vector<std::pair<int, int>> cells;

    /** The process of each unit. */
    std::vector<unsigned int> owners;

    /** The last step, if these are tetrahedra. */
    std::shared_ptr<const RedRefinement> red_refinement;
  };
} // namespace StickSlip

#endif
