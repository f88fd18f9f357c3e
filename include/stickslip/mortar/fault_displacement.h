// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_fault_displacement_h
#define stickslip_mortar_fault_displacement_h

#include <deal.II/base/tensor.h>

#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/fault_sides.h>

#include <vector>

namespace StickSlip
{
  /**
   * Displacements of the nodes on both sides of one fault, m, in the order of
   * the surfaces. Every process has those of all nodes of the fault.
   */
  template <int dim>
  struct FaultDisplacement
  {
    std::vector<Tensor<1, dim>> slave, master;
  };

  /**
   * The values at given nodes, by global number, of a nodal vector: the same on
   * all processes. Components that the vector does not have are zero: that out
   * of the plane, where it is the only one, is the first. Collective.
   */
  template <int dim>
  std::vector<Tensor<1, dim>>
  gather_nodes(const NodalVector                          &values,
               const NodePartition                        &partition,
               const std::vector<types::global_dof_index> &nodes);

  /**
   * The displacements in the space of the mesh at given nodes: those of
   * gather_nodes(), or none where bodies move out of the plane. Collective.
   */
  template <int dim>
  std::vector<Tensor<1, dim>>
  gather_displacements(const NodalVector                          &displacement,
                       const NodePartition                        &partition,
                       const std::vector<types::global_dof_index> &nodes);

  /**
   * The displacements of all faults. Collective.
   */
  template <int dim>
  std::vector<FaultDisplacement<dim>>
  gather_fault_displacements(const MeshLevel<dim>          &level,
                             const std::vector<FaultSides> &sides,
                             const NodalVector             &displacement);

  /**
   * The displacements of all faults on a level from those on the next finer
   * one: those of the nodes at the same places.
   */
  template <int dim>
  std::vector<FaultDisplacement<dim>>
  inject(const MeshHierarchy<dim>                  &meshes,
         const unsigned int                         level,
         const std::vector<FaultSides>             &sides,
         const std::vector<FaultDisplacement<dim>> &displacements);
} // namespace StickSlip

#endif
