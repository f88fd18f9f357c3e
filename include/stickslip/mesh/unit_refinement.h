// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_unit_refinement_h
#define stickslip_mesh_unit_refinement_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>

#include <stickslip/mesh/node_numbers.h>

#include <memory>
#include <set>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The share of a process in a mesh that is nowhere as a whole. Quadrilaterals
   * or hexahedra of one level of refinement, the units, are owned each by one
   * process, and refined equally often. Of the mesh that results a process
   * makes the cells of its units, those that touch them or a side that every
   * process needs, and the siblings of these; elsewhere cells are coarser, and
   * stand in for those of the whole mesh.
   *
   * Owners and numbers of nodes follow from the units without messages, since
   * the nodes within a unit, or one of its faces, edges or corners, can be
   * counted. A node belongs to the least owner of the units that have it.
   * Serial numbers are those that deal.II gives the degrees of freedom of the
   * whole mesh: in the order of the first cell that has them, unit after unit.
   */
  template <int dim>
  class UnitRefinement
  {
  public:
    /** @p owners: the process of each active cell of @p units, which are
     * refined @p depth times, as far as @p process needs them if it has to know
     * the boundary @p sides as a whole. */
    UnitRefinement(
      const std::shared_ptr<const Triangulation<dim>>        &units,
      const std::shared_ptr<const std::vector<unsigned int>> &owners,
      const unsigned int                                      depth,
      const unsigned int                                      process,
      const std::set<types::boundary_id>                     &sides);

    /** A mesh of the cells that the process needs, and those in place of
     * others. */
    std::shared_ptr<Triangulation<dim>>
    make_mesh() const;

    /** True if a cell of make_mesh() is one of the whole mesh. */
    bool
    is_real(const typename Triangulation<dim>::cell_iterator &cell) const
    {
      return static_cast<unsigned int>(cell->level()) == level();
    }

    /** Level of refinement of the cells of the whole mesh. */
    unsigned int
    level() const
    {
      return units->n_levels() - 1 + depth;
    }

    /** Number of cells of the whole mesh. */
    unsigned int
    n_cells() const;

    /** The number that each active cell of make_mesh() has in the whole mesh;
     * invalid for cells that are not real. */
    std::vector<unsigned int>
    cell_numbers(const Triangulation<dim> &mesh) const;

    /** Numbers of the nodes of the real cells of make_mesh(), one degree of
     * freedom at each vertex; invalid where the first unit of a node has no
     * real cell with it here. */
    NodeNumbers
    node_numbers(const DoFHandler<dim> &dofs) const;

    /** Active cells of one level of refinement. */
    std::shared_ptr<const Triangulation<dim>>        units;
    std::shared_ptr<const std::vector<unsigned int>> owners;
    unsigned int                                     depth, process;

  private:
    std::set<types::boundary_id> sides;
  };
} // namespace StickSlip

#endif
