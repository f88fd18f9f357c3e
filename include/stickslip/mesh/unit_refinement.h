// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_unit_refinement_h
#define stickslip_mesh_unit_refinement_h

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <stickslip/mesh/mesh_share.h>
#include <stickslip/mesh/refinement_steps.h>

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
   * and the siblings of these. Elsewhere trees have coarser cells, and
   * tetrahedra, which are no trees, have none.
   */
  template <int dim>
  struct UnitRefinement
  {
    /** Active cells, whose hanging vertices are on the shapes of faults if
     * these have any, and the process of each. */
    std::shared_ptr<const Triangulation<dim>>        units;
    std::shared_ptr<const std::vector<unsigned int>> owners;

    /** Steps that lead to the cells of the whole mesh, and how many of them are
     * beyond the units. */
    RefinementSteps steps;
    unsigned int    depth;

    /** Sides at faults, and those that each process needs as a whole. */
    std::set<types::boundary_id> sides_at_faults, whole_sides;

    /** Siblings are needed together. */
    bool couples_patches;

    MPI_Comm communicator;

    /** Throws InputError if a cell is inverted. */
    MeshShare<dim>
    make_share() const;

  private:
    MeshShare<dim>
    share_of_trees() const;

    MeshShare<dim>
    share_of_tetrahedra() const;

    /** The mesh of a share of trees. */
    std::shared_ptr<Triangulation<dim>>
    make_trees() const;

    /** Call @p visit(cell, name, owner) on the active cells below the units,
     * tree by tree. */
    template <typename Visitor>
    void
    for_each_named_leaf(const Triangulation<dim> &mesh,
                        const Visitor            &visit) const;

    /** Vertices of the own cells among trees, and of so many rows of cells
     * around them. */
    std::vector<bool>
    needed_vertices(const Triangulation<dim> &mesh,
                    const unsigned int        n_rows) const;

    /** Vertices of the sides that every process needs as a whole, and of one
     * cell, since no mesh is without. */
    std::vector<bool>
    vertices_needed_anyway(const Triangulation<dim> &mesh) const;

    unsigned int
    this_process() const
    {
      return Utilities::MPI::this_mpi_process(communicator);
    }

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
