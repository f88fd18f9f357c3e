// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <algorithm>

#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * Parts of the meshes that processes keep.
 */

namespace
{
  std::vector<BodyGeometry<2>>
  graded_bodies()
  {
    std::vector<BodyGeometry<2>> bodies(2);
    for (unsigned int b = 0; b < 2; ++b)
      {
        bodies[b].lateral_lower[0]    = 0.;
        bodies[b].lateral_upper[0]    = 2.;
        bodies[b].base                = b;
        bodies[b].thickness           = 1.;
        bodies[b].coarse_cells        = {{20, 10}};
        bodies[b].uniform_refinements = 1;
        bodies[b].refinement_passes   = 2;
      }
    return bodies;
  }
} // namespace



TEST(ParallelMeshes, CellsOfAllProcessesAreTheWhole)
{
  const MeshHierarchy<2> meshes(graded_bodies(), MPI_COMM_WORLD);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    {
      const MeshLevel<2> &level  = meshes.level(l);
      double              area   = 0.;
      unsigned int        n_kept = 0, n_owned = 0;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const DoFHandler<2> &dofs = level.bodies[b]->dof_handler();
          for (const auto &cell : dofs.active_cell_iterators())
            {
              ++n_kept;
              types::global_dof_index least = numbers::invalid_dof_index;
              for (const auto v : cell->vertex_indices())
                for (const auto &node :
                     level.resolve(b, cell->vertex_dof_index(v, 0)))
                  least = std::min(least, node.first);
              if (level.nodes.owned().is_element(least))
                area += cell->measure();
            }
          // Hanging nodes too.
          for (unsigned int dof = 0; dof < dofs.n_dofs(); ++dof)
            n_owned +=
              level.nodes.owned().is_element(level.global_node(b, dof));
        }
      EXPECT_NEAR(Utilities::MPI::sum(area, MPI_COMM_WORLD), 4., 1e-12);
      EXPECT_EQ(n_owned, level.nodes.n_owned());
      if (n_processes() > 1 && l + 1 == meshes.n_levels())
        {
          EXPECT_LT(n_kept, 0.8 * level.n_cells());
        }
    }
}
