// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/mortar/fault_displacement.h>

namespace StickSlip
{
  template <int dim>
  std::vector<Tensor<1, dim>>
  gather_nodes(const NodalVector                          &values,
               const NodePartition                        &partition,
               const std::vector<types::global_dof_index> &nodes)
  {
    const unsigned int  n_components = partition.n_components();
    std::vector<double> all(nodes.size() * n_components);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (partition.owned().is_element(nodes[k]))
        for (unsigned int d = 0; d < n_components; ++d)
          all[k * n_components + d] = values.local_element(
            partition.local_index(nodes[k]) * n_components + d);
    // All but one of the terms are zero.
    Utilities::MPI::sum(all, partition.communicator(), all);
    std::vector<Tensor<1, dim>> result(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < n_components; ++d)
        result[k][d] = all[k * n_components + d];
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  gather_displacements(const NodalVector                          &displacement,
                       const NodePartition                        &partition,
                       const std::vector<types::global_dof_index> &nodes)
  {
    return partition.n_components() < dim ?
             std::vector<Tensor<1, dim>>(nodes.size()) :
             gather_nodes<dim>(displacement, partition, nodes);
  }



  template <int dim>
  std::vector<FaultDisplacement<dim>>
  gather_fault_displacements(const MeshLevel<dim>          &level,
                             const std::vector<FaultSides> &sides,
                             const NodalVector             &displacement)
  {
    std::vector<FaultDisplacement<dim>> result;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        const auto gather = [&](const unsigned int side) {
          return gather_displacements<dim>(displacement,
                                           level.nodes,
                                           level.surface(f, side).nodes);
        };
        result.push_back({gather(sides[f].slave), gather(sides[f].master)});
      }
    return result;
  }



  template <int dim>
  std::vector<FaultDisplacement<dim>>
  inject(const MeshHierarchy<dim>                  &meshes,
         const unsigned int                         level,
         const std::vector<FaultSides>             &sides,
         const std::vector<FaultDisplacement<dim>> &displacements)
  {
    std::vector<FaultDisplacement<dim>> result;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        const auto on_side = [&](const unsigned int                 side,
                                 const std::vector<Tensor<1, dim>> &values) {
          std::vector<Tensor<1, dim>> injected;
          for (const unsigned int k : meshes.places_on_finer(level, f, side))
            injected.push_back(values[k]);
          return injected;
        };
        result.push_back({on_side(sides[f].slave, displacements[f].slave),
                          on_side(sides[f].master, displacements[f].master)});
      }
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                 \
  template struct FaultDisplacement<dim>;                          \
  template std::vector<Tensor<1, dim>> gather_nodes<dim>(          \
    const NodalVector &,                                           \
    const NodePartition &,                                         \
    const std::vector<types::global_dof_index> &);                 \
  template std::vector<Tensor<1, dim>> gather_displacements<dim>(  \
    const NodalVector &,                                           \
    const NodePartition &,                                         \
    const std::vector<types::global_dof_index> &);                 \
  template std::vector<FaultDisplacement<dim>>                     \
  gather_fault_displacements<dim>(const MeshLevel<dim> &,          \
                                  const std::vector<FaultSides> &, \
                                  const NodalVector &);            \
  template std::vector<FaultDisplacement<dim>> inject<dim>(        \
    const MeshHierarchy<dim> &,                                    \
    const unsigned int,                                            \
    const std::vector<FaultSides> &,                               \
    const std::vector<FaultDisplacement<dim>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
