// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_refinement_steps_h
#define stickslip_mesh_refinement_steps_h

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <set>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Refinements of all cells, then of those that touch a fault. If nothing else
   * is refined, cells follow from where they are: a cell of the mesh is one of
   * the level @p uniform that does not touch a fault, or one of the level
   * finest() that does, or a child without contact of a cell with contact
   * between these levels. No two cells with a common vertex differ by more than
   * one level.
   */
  struct RefinementSteps
  {
    unsigned int uniform = 0, at_faults = 0;

    /** Level of the finest cells. */
    unsigned int
    finest() const
    {
      return uniform + at_faults;
    }

    /** The steps to the mesh in which each cell that can be has been coarsened
     * so many times. */
    RefinementSteps
    coarser(const unsigned int n_times) const
    {
      const unsigned int n_uniform = std::min(n_times, uniform);
      return {uniform - n_uniform, at_faults - (n_times - n_uniform)};
    }

    /** True if a cell of this level is not refined. */
    bool
    ends_at(const unsigned int level, const bool touches_fault) const
    {
      return level >= (touches_fault ? finest() : uniform);
    }
  };



  /**
   * Numbers of the cells that the steps leave of each active cell of @p mesh.
   * Cells that touch one of the sides @p at_faults are at faults.
   */
  template <int dim>
  std::vector<unsigned int>
  count_finest_cells(const Triangulation<dim>           &mesh,
                     const std::set<types::boundary_id> &at_faults,
                     const RefinementSteps              &steps);
} // namespace StickSlip

#endif
