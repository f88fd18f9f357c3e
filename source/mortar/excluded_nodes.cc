// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/mortar/crosspoints.h>
#include <stickslip/mortar/excluded_nodes.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  std::vector<std::vector<bool>>
  excluded_nodes(const MeshLevel<dim>          &level,
                 const std::vector<FaultSides> &sides,
                 const NodeMask                &dirichlet)
  {
    const std::vector<types::global_dof_index> crossings =
      crosspoints(level, sides.size());
    std::vector<std::vector<bool>> result;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        std::vector<unsigned int> is_excluded;
        for (const auto node : level.surface(f, sides[f].slave).nodes)
          is_excluded.push_back(
            std::binary_search(crossings.begin(), crossings.end(), node) ||
            (level.nodes.owned().is_element(node) &&
             !dirichlet.is_fully_active(level.nodes.local_index(node))));
        // Only owners know what is masked.
        Utilities::MPI::max(is_excluded,
                            level.nodes.communicator(),
                            is_excluded);
        result.emplace_back(is_excluded.begin(), is_excluded.end());
      }
    return result;
  }



  template decltype(excluded_nodes<2>) excluded_nodes<2>;
  template decltype(excluded_nodes<3>) excluded_nodes<3>;
} // namespace StickSlip
