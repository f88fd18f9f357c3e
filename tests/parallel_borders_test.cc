// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <iostream>

#include "linear_iterations.h"
#include "opening_layers.h"
#include "parallel_comparison.h"
#include "random_vectors.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two blocks with cells that are twice as wide as thick, or more, too few to
   * be in lines. */
  std::vector<BodyGeometry<3>>
  flat_blocks(const unsigned int n_cells_across)
  {
    BodyGeometry<3> block     = make_body<3>(1., {{5, 5, n_cells_across}}, 0);
    block.uniform_refinements = 2;
    return {block, block};
  }



  /** Steps of conjugate gradients for the linear problem with stuck faults. */
  unsigned int
  linear_steps(const std::vector<BodyGeometry<3>> &blocks,
               const MPI_Comm                      communicator)
  {
    OpeningLayers<3>   layers(blocks, false, false, communicator, 1);
    LevelHierarchy<3> &hierarchy = layers.problem.hierarchy();
    layers.problem.combine(Newmark<3>().operator_coefficients(1e-1));
    std::mt19937   engine;
    const NodeMask active =
      random_truncation(hierarchy.finest(), /*probability=*/1., engine);
    linearise_without_friction(hierarchy, active);
    return cg_iterations(hierarchy,
                         random_vector(hierarchy.finest(),
                                       active,
                                       Utilities::MPI::this_mpi_process(
                                         communicator)));
  }
} // namespace



// Without caution at the borders the cycle is indefinite on four processes.
TEST(ParallelBorders, LeaveTheCycleAPreconditioner)
{
  for (const unsigned int n_cells_across : {2, 3, 4})
    {
      const std::vector<BodyGeometry<3>> blocks = flat_blocks(n_cells_across);
      const unsigned int ours = linear_steps(blocks, MPI_COMM_WORLD),
                         one  = linear_steps(blocks, MPI_COMM_SELF);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << ours << " steps, " << one << " on one process\n";
      EXPECT_LE(ours, 1.3 * one);
    }
}
