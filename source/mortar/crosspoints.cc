// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/crosspoints.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  std::vector<types::global_dof_index>
  crosspoints(const MeshLevel<dim> &level, const unsigned int n_faults)
  {
    std::vector<types::global_dof_index> nodes;
    for (unsigned int f = 0; f < n_faults; ++f)
      for (const unsigned int side : {0, 1})
        nodes.insert(nodes.end(),
                     level.surface(f, side).nodes.begin(),
                     level.surface(f, side).nodes.end());
    std::sort(nodes.begin(), nodes.end());

    std::vector<types::global_dof_index> result;
    for (unsigned int k = 1; k < nodes.size(); ++k)
      if (nodes[k] == nodes[k - 1] &&
          (result.empty() || result.back() != nodes[k]))
        result.push_back(nodes[k]);
    return result;
  }



  template std::vector<types::global_dof_index>
  crosspoints(const MeshLevel<2> &, const unsigned int);
  template std::vector<types::global_dof_index>
  crosspoints(const MeshLevel<3> &, const unsigned int);
} // namespace StickSlip
