// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_mesh_hierarchy_h
#define stickslip_mesh_mesh_hierarchy_h

#include <stickslip/mesh/mesh_level.h>
#include <stickslip/mesh/nodal_prolongation.h>

namespace StickSlip
{
  /**
   * The meshes of all bodies on all levels, the coarsest first, and the
   * prolongations of nodal values between them.
   *
   * Owners of nodes follow from one partition of cells of all bodies, see
   * partition_cells(): a node belongs to the least owner of the cells at its
   * place, on each level. These are the finest cells or, where there are many
   * of them, coarser ones, below which a process makes only what it needs,
   * see UnitRefinement. Other meshes are made whole on each process, which
   * keeps of them what MeshLevel::keep_own_cells() says. Levels with few nodes
   * are gathered on fewer processes, the coarsest on one.
   */
  template <int dim>
  class MeshHierarchy
  {
  public:
    /** The least number of nodes for which another process shares a level. */
    static constexpr unsigned int usual_nodes_per_process = 500;

    /** Cells that are divided between the processes at least, in units of the
     * least number of nodes of a process. So many divide as well as all, and
     * take little of the memory and time of a process. */
    static constexpr unsigned int least_units = 20;

    /**
     * The bodies in the order of the @p topology. A level but the finest is
     * shared by no more processes than there are multiples of
     * @p min_nodes_per_process in it. Nodal vectors have @p n_components
     * entries for each node. Throws InputError if a side of a fault
     * has no faces, or if both are plane and not opposite to each other.
     */
    MeshHierarchy(
      const std::vector<CoarseBody<dim>> &bodies,
      const FaultTopology                &topology,
      const MPI_Comm                     &communicator,
      const unsigned int min_nodes_per_process = usual_nodes_per_process,
      const unsigned int n_components          = dim);

    /** Bodies that are bricks. */
    MeshHierarchy(
      const std::vector<BodyGeometry<dim>> &bodies,
      const FaultTopology                  &topology,
      const MPI_Comm                       &communicator,
      const unsigned int min_nodes_per_process = usual_nodes_per_process);

    /** Bodies of a stack from bottom to top, they and their faults named by
     * numbers from one. */
    MeshHierarchy(
      const std::vector<BodyGeometry<dim>> &bodies,
      const MPI_Comm                       &communicator,
      const unsigned int min_nodes_per_process = usual_nodes_per_process);

    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    const FaultTopology &
    topology() const
    {
      return faults;
    }

    const MeshLevel<dim> &
    level(const unsigned int l) const;

    const MeshLevel<dim> &
    finest() const
    {
      return levels.back();
    }

    /** Nodal values on level @p l of the functions of level l-1, in global
     * numbers of nodes: the rows of the owned nodes. */
    const NodalProlongation &
    prolongation(const unsigned int l) const;

    /** The places on the side of a fault of level l+1 of the nodes of that of
     * level @p l, see places_on_finer(). */
    const std::vector<unsigned int> &
    places_on_finer(const unsigned int l,
                    const unsigned int fault,
                    const unsigned int side) const;

  private:
    FaultTopology                  faults;
    std::vector<MeshLevel<dim>>    levels;
    std::vector<NodalProlongation> prolongations;
    /** Level by level, for both sides of each fault. */
    std::vector<std::vector<std::array<std::vector<unsigned int>, 2>>>
      fault_places;
  };
} // namespace StickSlip

#endif
