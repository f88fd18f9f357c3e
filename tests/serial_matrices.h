// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_serial_matrices_h
#define stickslip_tests_serial_matrices_h

#include <stickslip/algebra/galerkin_product.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mesh/nodal_normals.h>
#include <stickslip/mortar/excluded_nodes.h>
#include <stickslip/mortar/jump_basis.h>

namespace StickSlip::Tests
{
  /** Nodes that all belong to this process. */
  inline NodePartition
  serial_nodes(const unsigned int n, const unsigned int components)
  {
    return NodePartition(complete_index_set(n),
                         IndexSet(n),
                         components,
                         MPI_COMM_SELF);
  }



  /** A matrix with all its rows and columns. */
  inline TransferMatrix
  serial_matrix(const std::vector<GlobalRow> &rows,
                const unsigned int            n_columns,
                const unsigned int            components)
  {
    return TransferMatrix(rows,
                          serial_nodes(rows.size(), components),
                          serial_nodes(n_columns, components));
  }



  /** Row by row from a function of the node. */
  template <typename Row>
  std::vector<GlobalRow>
  rows_of(const unsigned int n_rows, const Row &row)
  {
    std::vector<GlobalRow> rows;
    for (unsigned int i = 0; i < n_rows; ++i)
      rows.push_back(row(i));
    return rows;
  }



  /** The prolongation of nodal values to level @p l. */
  template <int dim>
  TransferMatrix
  prolongation_matrix(const MeshHierarchy<dim> &meshes, const unsigned int l)
  {
    return serial_matrix(rows_of(meshes.level(l).n_nodes(),
                                 [&](const unsigned int i) {
                                   return meshes.prolongation(l).row(i);
                                 }),
                         meshes.level(l - 1).n_nodes(),
                         dim);
  }



  /** B of a basis over @p n nodes. */
  template <int dim>
  TransferMatrix
  to_nodal_matrix(const JumpBasis<dim> &basis, const unsigned int n)
  {
    return serial_matrix(
      rows_of(n, [&](const unsigned int i) { return basis.to_nodal(i); }),
      n,
      dim);
  }



  /** Its inverse. */
  template <int dim>
  TransferMatrix
  to_jumps_matrix(const JumpBasis<dim> &basis, const unsigned int n)
  {
    return serial_matrix(
      rows_of(n, [&](const unsigned int i) { return basis.to_jumps(i); }),
      n,
      dim);
  }



  /** The rows of the prolongation between two jump bases to level @p l. */
  template <int dim>
  std::vector<GlobalRow>
  jump_prolongation_rows(const JumpBasis<dim>     &coarse,
                         const JumpBasis<dim>     &fine,
                         const MeshHierarchy<dim> &meshes,
                         const unsigned int        l)
  {
    return rows_of(meshes.level(l).n_nodes(), [&](const unsigned int i) {
      return jump_prolongation(coarse, fine, meshes.prolongation(l), i);
    });
  }



  /** The jump basis of a level without displacement, with the axes of its own
   * surfaces; @p reference: the reference axis of faults normal to x. */
  template <int dim>
  JumpBasis<dim>
  undeformed_basis(
    const MeshLevel<dim>          &level,
    const std::vector<FaultSides> &sides,
    const NodeMask                &dirichlet,
    const Tensor<1, dim>          &reference = FaultAxes<dim>::first_axis())
  {
    std::vector<FaultAxes<dim>> axes;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        std::vector<Tensor<1, dim>> normals =
          nodal_normals(level.surface(f, sides[f].slave));
        for (Tensor<1, dim> &normal : normals)
          normal *= -sides[f].sign();
        axes.emplace_back(normals,
                          std::abs(normals[0][0]) > 0.9 ?
                            reference :
                            FaultAxes<dim>::first_axis());
      }
    return JumpBasis<dim>(level,
                          sides,
                          axes,
                          gather_fault_displacements(level,
                                                     sides,
                                                     level.nodes.make_vector()),
                          excluded_nodes(level, sides, dirichlet));
  }
} // namespace StickSlip::Tests

#endif
