// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_mesh_level_h
#define stickslip_mesh_mesh_level_h

#include <stickslip/algebra/node_partition.h>
#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/geometry/fault_topology.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/node_numbers.h>

#include <cstdint>
#include <unordered_map>

namespace StickSlip
{
  /**
   * One level of the hierarchy: a mesh of each body and a common numbering of
   * their nodes, by owner, and for each owner body after body in the order of
   * the bodies' DoFHandlers. On one process that is body after body, the serial
   * order.
   *
   * It is made from whole meshes or shares of them, see BodyMesh; several
   * processes then keep what they need.
   */
  template <int dim>
  struct MeshLevel
  {
    /** Meshes in the order of the topology. A body that cannot be coarsened
     * further appears with the same mesh on several levels. */
    BodyMeshes<dim> bodies;

    /** The owned nodes; ghosts are the nodes of all patches of cells that touch
     * an owned node. */
    NodePartition nodes;

    MeshLevel() = default;

    /**
     * @p numbers of the nodes of each body; @p n_components: entries of nodal
     * vectors for each node. Throws InputError if a side of a fault has no
     * faces. Collective.
     */
    MeshLevel(const BodyMeshes<dim>          &bodies,
              const FaultTopology            &topology,
              const std::vector<NodeNumbers> &numbers,
              const MPI_Comm                 &communicator,
              const unsigned int              n_components = dim);

    /** Keep the patches that touch an owned node, those with nodes at the other
     * end of a body that these name, the cells that touch a side which every
     * process needs as a whole, rigid bodies, and a cell of each other; forget
     * the others and their nodes. Surfaces go on to be those of all faults. */
    void
    keep_own_cells();

    /** Number of nodes of all bodies. */
    types::global_dof_index
    n_nodes() const
    {
      return first_serial_node.back();
    }

    /** Number of active cells of all bodies. */
    types::global_dof_index
    n_cells() const
    {
      return first_serial_cell.back();
    }

    /** Serial numbers of a degree of freedom and of an active cell of a body:
     * those that they have on one process. */
    types::global_dof_index
    serial_node(const unsigned int            body,
                const types::global_dof_index dof) const
    {
      return first_serial_node[body] + bodies[body]->whole_dof(dof);
    }
    types::global_dof_index
    serial_cell(const unsigned int body, const unsigned int cell) const
    {
      return first_serial_cell[body] + bodies[body]->whole_cell(cell);
    }

    /** Serial numbers of the owned nodes. */
    const std::vector<types::global_dof_index> &
    owned_serial_nodes() const
    {
      return serial_nodes;
    }

    /** Checksum of the positions of all nodes and their serial numbers.
     * Collective. */
    std::uint32_t
    checksum() const;

    /** The global number of the node at a degree of freedom of a body; invalid
     * for those of cells that are not real. */
    types::global_dof_index
    global_node(const unsigned int            body,
                const types::global_dof_index dof) const;

    /** The local index of a node, which must be owned or a ghost. */
    unsigned int
    node(const unsigned int body, const types::global_dof_index dof) const;

    /** The nodes and weights to which the value at a degree of freedom is
     * bound: the node itself, or the masters of a hanging one. */
    GlobalRow
    resolve(const unsigned int body, const types::global_dof_index dof) const;

    /** The first (0) or second (1) side of a fault, its nodes by global number,
     * one part of the side after the other. */
    const FaultSurface<dim> &
    surface(const unsigned int fault, const unsigned int side) const;

  private:
    IndexSet
    find_ghosts(const IndexSet &owned) const;

    FaultSurface<dim>
    join(const std::vector<BodySide> &parts,
         const MPI_Comm              &communicator) const;

    /** One part of a side of a fault as a whole, its nodes by global number,
     * whatever of it is here. */
    FaultSurface<dim>
    whole_part(const BodySide &part, const MPI_Comm &communicator) const;

    /** Position in global_numbers of the first node of each body. */
    std::vector<types::global_dof_index> first_node;
    std::vector<types::global_dof_index> global_numbers;
    /** Rows of the bound nodes by their position in global_numbers. */
    std::unordered_map<types::global_dof_index, GlobalRow> bound_rows;
    /** Serial numbers of the owned nodes, and of the first node and the first
     * cell of each body. */
    std::vector<types::global_dof_index> serial_nodes, first_serial_node,
      first_serial_cell;
    /** First and second side of each fault. */
    std::vector<std::array<FaultSurface<dim>, 2>> surfaces;
  };
} // namespace StickSlip

#endif
