// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <algorithm>
#include <cmath>

#include "parallel_comparison.h"
#include "simplex_bodies.h"

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



namespace
{
  /** Some levels of the multigrid method refine at the faults alone. The bodies
   * have different numbers of them. */
  std::vector<BodyGeometry<2>>
  strongly_graded_bodies()
  {
    std::vector<BodyGeometry<2>> bodies = graded_bodies();
    bodies[0].refinement_passes         = 5;
    bodies[1].coarse_cells              = {{10, 5}};
    bodies[1].uniform_refinements       = 2;
    bodies[1].refinement_passes         = 3;
    return bodies;
  }



  /** Cells of one size, of which no process makes more than it needs. */
  std::vector<BodyGeometry<2>>
  uniform_bodies()
  {
    std::vector<BodyGeometry<2>> bodies = graded_bodies();
    for (BodyGeometry<2> &body : bodies)
      {
        body.coarse_cells        = {{5, 3}};
        body.uniform_refinements = 4;
        body.refinement_passes   = 0;
      }
    return bodies;
  }



  void
  expect_cells_of_whole(const MeshHierarchy<2> &meshes)
  {
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



  /** Nodes by their numbers on one process, prolongations between them, and
   * what every process knows of faults. */
  template <int dim>
  void
  expect_same_meshes(const MeshHierarchy<dim> &shared,
                     const MeshHierarchy<dim> &alone)
  {
    ASSERT_EQ(shared.n_levels(), alone.n_levels());
    std::vector<types::global_dof_index> coarser;
    for (unsigned int l = 0; l < shared.n_levels(); ++l)
      {
        const MeshLevel<dim> &ours = shared.level(l), &one = alone.level(l);
        ASSERT_EQ(ours.n_nodes(), one.n_nodes());
        ASSERT_EQ(ours.n_cells(), one.n_cells());
        EXPECT_EQ(ours.checksum(), one.checksum());
        const std::vector<types::global_dof_index> numbers =
          numbers_on_one(ours);
        for (unsigned int f = 0; f < shared.topology().faults().size(); ++f)
          for (const unsigned int side : {0, 1})
            {
              const auto &here  = ours.surface(f, side),
                         &there = one.surface(f, side);
              ASSERT_EQ(here.nodes.size(), there.nodes.size());
              ASSERT_EQ(here.faces, there.faces);
              for (unsigned int k = 0; k < here.nodes.size(); ++k)
                {
                  EXPECT_EQ(numbers[here.nodes[k]], there.nodes[k]);
                  EXPECT_EQ(here.points[k], there.points[k]);
                }
            }
        if (l > 0)
          for (const types::global_dof_index node : ours.nodes.owned())
            {
              GlobalRow row   = shared.prolongation(l).row(node);
              GlobalRow whole = alone.prolongation(l).row(numbers[node]);
              for (auto &entry : row)
                entry.first = coarser[entry.first];
              std::sort(row.begin(), row.end());
              std::sort(whole.begin(), whole.end());
              EXPECT_EQ(row, whole);
            }
        coarser = numbers;
      }
  }
} // namespace



TEST(ParallelMeshes, CellsOfAllProcessesAreTheWhole)
{
  expect_cells_of_whole({graded_bodies(), MPI_COMM_WORLD});
  expect_cells_of_whole({uniform_bodies(), MPI_COMM_WORLD, 1});
}



TEST(ParallelMeshes, EqualThoseOfOneProcess)
{
  for (const auto &bodies :
       {graded_bodies(), strongly_graded_bodies(), uniform_bodies()})
    for (const unsigned int min_nodes_per_process : {1, 500})
      expect_same_meshes<2>({bodies, MPI_COMM_WORLD, min_nodes_per_process},
                            {bodies, MPI_COMM_SELF});

  std::vector<BodyGeometry<3>> blocks(2);
  for (unsigned int b = 0; b < 2; ++b)
    {
      blocks[b].base                = b;
      blocks[b].thickness           = 1.;
      blocks[b].coarse_cells        = {{3 - b, 2, 1}};
      blocks[b].uniform_refinements = 3;
    }
  expect_same_meshes<3>({blocks, MPI_COMM_WORLD, 1}, {blocks, MPI_COMM_SELF});
  for (BodyGeometry<3> &block : blocks)
    {
      block.uniform_refinements = 1;
      block.refinement_passes   = 2;
    }
  expect_same_meshes<3>({blocks, MPI_COMM_WORLD, 1}, {blocks, MPI_COMM_SELF});
}



namespace
{
  /** Two bodies on top of each other, of few cells that are refined. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  two_blocks(const unsigned int uniform_refinements,
             const unsigned int refinement_passes)
  {
    std::vector<BodyGeometry<dim>> blocks(2);
    for (unsigned int b = 0; b < 2; ++b)
      {
        blocks[b].base      = b;
        blocks[b].thickness = 1.;
        blocks[b].coarse_cells.fill(2);
        blocks[b].coarse_cells[0]     = 4 - b;
        blocks[b].uniform_refinements = uniform_refinements;
        blocks[b].refinement_passes   = refinement_passes;
      }
    return blocks;
  }



  /** Two bodies with a wave between them. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  bent_blocks(const unsigned int uniform_refinements,
              const unsigned int refinement_passes)
  {
    auto       blocks = two_blocks<dim>(uniform_refinements, refinement_passes);
    const auto wave   = [](const Point<dim> &x) {
      return 1. + 0.05 * std::sin(4. * x[0]) * std::cos(2. * x[dim - 2]);
    };
    blocks[0].upper_elevation = wave;
    blocks[1].lower_elevation = wave;
    return blocks;
  }



  /** Two bodies without ends along the first axis. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  endless_blocks(const unsigned int uniform_refinements)
  {
    auto blocks = two_blocks<dim>(uniform_refinements, 0);
    for (auto &block : blocks)
      block.periodic[0] = true;
    return blocks;
  }



  template <int dim>
  void
  expect_same_meshes(const std::vector<BodyGeometry<dim>> &bodies)
  {
    expect_same_meshes<dim>({bodies, MPI_COMM_WORLD, 1},
                            {bodies, MPI_COMM_SELF});
  }
} // namespace



TEST(ParallelMeshes, EqualThoseOfOneProcessWhereFaultsBend)
{
  expect_same_meshes(bent_blocks<2>(4, 0));
  expect_same_meshes(bent_blocks<2>(1, 5));
  expect_same_meshes(bent_blocks<3>(2, 0));
  expect_same_meshes(bent_blocks<3>(1, 2));
}



TEST(ParallelMeshes, EqualThoseOfOneProcessWithoutEnds)
{
  expect_same_meshes(endless_blocks<2>(4));
  expect_same_meshes(endless_blocks<3>(2));
}



TEST(ParallelMeshes, EqualThoseOfOneProcessOfSimplices)
{
  const FaultTopology topology  = stack_topology<2>({"1", "2"}, {"fault"});
  const auto          triangles = simplex_bricks(two_blocks<2>(4, 0));
  expect_same_meshes<2>({triangles, topology, MPI_COMM_WORLD, 1},
                        {triangles, topology, MPI_COMM_SELF});
  // Of 24 tetrahedra each.
  auto bricks            = two_blocks<3>(2, 0);
  bricks[0].coarse_cells = {{2, 1, 1}};
  bricks[1].coarse_cells = {{1, 1, 1}};
  const auto tetrahedra  = simplex_bricks(bricks);
  expect_same_meshes<3>(
    {tetrahedra, stack_topology<3>({"1", "2"}, {"fault"}), MPI_COMM_WORLD, 1},
    {tetrahedra, stack_topology<3>({"1", "2"}, {"fault"}), MPI_COMM_SELF});
}



// Passes at faults refine nothing in a body that has none.
TEST(ParallelMeshes, EqualThoseOfOneProcessWithoutFaultsAtABody)
{
  std::vector<BodyGeometry<2>> bodies = strongly_graded_bodies();
  bodies.push_back(bodies.front());
  bodies.back().base = 3.;
  const FaultTopology pair(
    {"lower", "upper", "apart"},
    stack_topology<2>({"lower", "upper"}, {"fault"}).faults());
  for (const unsigned int min_nodes_per_process : {1, 500})
    expect_same_meshes<2>({bodies, pair, MPI_COMM_WORLD, min_nodes_per_process},
                          {bodies, pair, MPI_COMM_SELF});
}
