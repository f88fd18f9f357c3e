// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/make_set.h>
#include <stickslip/problem/contact_components.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  NodeMask
  fixed_components(const MeshLevel<dim>                       &level,
                   const NodePartition                        &nodes,
                   const NodeMask                             &dirichlet,
                   const JumpBasis<dim>                       &basis,
                   const std::vector<types::global_dof_index> &prescribed_slip,
                   const std::vector<types::global_dof_index> &opening)
  {
    NodeMask mask(nodes.n_local(), dirichlet.n_components());
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < mask.n_components(); ++c)
        if (!dirichlet.is_active(i, c))
          mask.mask(i, c);
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
        if (const auto node = level.global_node(b, line.index);
            nodes.owned().is_element(node))
          mask.mask_node(nodes.local_index(node));
    for (const unsigned int i : basis.owned_contact_nodes(nodes))
      if (const auto p = nodes.global_index(i);
          std::binary_search(prescribed_slip.begin(), prescribed_slip.end(), p))
        mask.mask_node(i);
      else if (!std::binary_search(opening.begin(), opening.end(), p))
        for (unsigned int c = FaultAxes<dim>::normal_component;
             c < mask.n_components();
             ++c)
          mask.mask(i, c);
    mask.update_ghosts(nodes);
    return mask;
  }



#define STICKSLIP_INSTANTIATE(dim)                \
  template NodeMask fixed_components<dim>(        \
    const MeshLevel<dim> &,                       \
    const NodePartition &,                        \
    const NodeMask &,                             \
    const JumpBasis<dim> &,                       \
    const std::vector<types::global_dof_index> &, \
    const std::vector<types::global_dof_index> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
