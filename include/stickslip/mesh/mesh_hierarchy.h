// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_mesh_hierarchy_h
#define stickslip_mesh_mesh_hierarchy_h

#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/mesh/body_mesh.h>

namespace StickSlip
{
  /**
   * One level of the hierarchy: a mesh of each body and a common numbering of
   * their nodes, body after body.
   */
  template <int dim>
  struct MeshLevel
  {
    /** From the lowest body to the highest. A body that cannot be coarsened
     * further appears with the same mesh on several levels. */
    std::vector<std::shared_ptr<const BodyMesh<dim>>> bodies;

    /** Number of the first node of each body, and the number of all. */
    std::vector<types::global_dof_index> first_node;

    NodePartition nodes;

    /** The local index of a degree of freedom of a body. */
    unsigned int
    node(const unsigned int body, const types::global_dof_index dof) const;
  };

  /**
   * The meshes of all bodies on all levels, the coarsest first, and the
   * prolongations of nodal values between them.
   */
  template <int dim>
  class MeshHierarchy
  {
  public:
    /** Bodies from bottom to top; every inner side is a fault. */
    MeshHierarchy(const std::vector<BodyGeometry<dim>> &bodies,
                  const MPI_Comm                       &communicator);

    unsigned int
    n_levels() const;

    unsigned int
    n_bodies() const;

    const MeshLevel<dim> &
    level(const unsigned int l) const;

    const MeshLevel<dim> &
    finest() const;

    /**
     * Nodal values on level @p l of the functions of level l-1. The rows of
     * hanging nodes are empty.
     */
    const TransferMatrix &
    prolongation(const unsigned int l) const;

  private:
    std::vector<MeshLevel<dim>> levels;
    std::vector<TransferMatrix> prolongations;
  };

  /**
   * The prolongation between two meshes of one body that differ by at most
   * one refinement of each cell: row i holds the values of the coarse basis
   * functions at the fine node i, in the numbers of the two DoFHandlers.
   */
  template <int dim>
  std::vector<TransferMatrix::Row>
  nodal_prolongation(const BodyMesh<dim> &coarse, const BodyMesh<dim> &fine);
} // namespace StickSlip

#endif
