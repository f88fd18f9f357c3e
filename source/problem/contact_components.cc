// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/make_set.h>
#include <stickslip/problem/contact_components.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  std::vector<unsigned int>
  slave_nodes_of_all_faults(const JumpBasis<dim> &basis)
  {
    std::vector<unsigned int> nodes;
    for (const FaultContact<dim> &fault : basis.faults())
      nodes.insert(nodes.end(),
                   fault.slave_nodes.begin(),
                   fault.slave_nodes.end());
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }



  template <int dim>
  NodeMask
  fixed_components(const MeshLevel<dim>                       &level,
                   const NodeMask                             &dirichlet,
                   const JumpBasis<dim>                       &basis,
                   const std::vector<types::global_dof_index> &prescribed_slip)
  {
    NodeMask mask = dirichlet;
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
        mask.mask_node(level.global_node(b, line.index));
    for (const auto p : basis.contact_nodes())
      if (std::binary_search(prescribed_slip.begin(), prescribed_slip.end(), p))
        mask.mask_node(p);
      else
        mask.mask(p, FaultAxes<dim>::normal_component);
    return mask;
  }



  template <int dim>
  std::vector<unsigned int>
  rows_near_faults(const MeshHierarchy<dim>          &meshes,
                   const unsigned int                 l,
                   const std::vector<JumpBasis<dim>> &bases)
  {
    // B_l^-1 P B_{l-1} differs from P in the rows of slave nodes, and in those
    // that see slave nodes of the coarser level.
    std::vector<unsigned int> result = slave_nodes_of_all_faults(bases[l]);
    if (l > 0)
      {
        const std::vector<unsigned int> coarse =
          slave_nodes_of_all_faults(bases[l - 1]);
        for (unsigned int i = 0; i < meshes.level(l).nodes.n_owned(); ++i)
          for (const auto &entry : meshes.prolongation(l).row(i))
            if (std::binary_search(coarse.begin(), coarse.end(), entry.first))
              {
                result.push_back(i);
                break;
              }
        make_set(result);
      }
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                   \
  template NodeMask fixed_components<dim>(                           \
    const MeshLevel<dim> &,                                          \
    const NodeMask &,                                                \
    const JumpBasis<dim> &,                                          \
    const std::vector<types::global_dof_index> &);                   \
  template std::vector<unsigned int> slave_nodes_of_all_faults<dim>( \
    const JumpBasis<dim> &);                                         \
  template std::vector<unsigned int> rows_near_faults<dim>(          \
    const MeshHierarchy<dim> &,                                      \
    const unsigned int,                                              \
    const std::vector<JumpBasis<dim>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
