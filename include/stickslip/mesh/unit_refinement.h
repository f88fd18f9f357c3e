// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_unit_refinement_h
#define stickslip_mesh_unit_refinement_h

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <stickslip/mesh/refinement_steps.h>

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The share of a process in a mesh that is nowhere as a whole. Active cells
   * of a coarser mesh, the units, are owned each by one process, and refined as
   * far as RefinementSteps say. Of the mesh that results a process makes the
   * cells of its units, those around them or a side that every process needs,
   * and the siblings of these; elsewhere cells are coarser, and stand in for
   * those of the whole mesh.
   */
  template <int dim>
  struct UnitRefinement
  {
    /** Active cells, and the process of each. */
    std::shared_ptr<const Triangulation<dim>>        units;
    std::shared_ptr<const std::vector<unsigned int>> owners;

    /** Steps that lead to the cells of the whole mesh, and how many of them are
     * beyond the units. */
    RefinementSteps steps;
    unsigned int    depth;

    /** Sides at faults, and those that each process needs as a whole. */
    std::set<types::boundary_id> sides_at_faults, whole_sides;

    MPI_Comm communicator;

    /** A mesh of the cells that the process needs, and those in place of
     * others. */
    std::shared_ptr<Triangulation<dim>>
    make_mesh() const;

    /** For each active cell of make_mesh(), if it is one of the whole mesh that
     * the process needs. */
    std::vector<bool>
    real_cells(const Triangulation<dim> &mesh) const;

    /** The process of a unit. */
    unsigned int
    owner(const typename Triangulation<dim>::cell_iterator &unit) const
    {
      return (*owners)[unit->active_cell_index()];
    }

  private:
    /** Vertices of the cells in the own units and so many rows of cells around
     * them. */
    std::vector<bool>
    needed_vertices(const Triangulation<dim> &mesh,
                    const unsigned int        n_rows) const;

    /** Rows of cells around the own ones that are needed with all around them:
     * none, or, where cells differ in size, those that couple with own nodes
     * through hanging ones, and those that nodes of these hang on. */
    unsigned int
    n_rows() const
    {
      return steps.at_faults == 0 ? 0 : 2;
    }
  };
} // namespace StickSlip

#endif
