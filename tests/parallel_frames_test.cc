// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <numeric>

#include "bent_block.h"
#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  std::vector<types::global_dof_index>
  same_numbers(const unsigned int n)
  {
    std::vector<types::global_dof_index> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }



  /** A smooth function of the node's number, for owned nodes. */
  NodalVector
  some_vector(const NodePartition &nodes)
  {
    const unsigned int n      = nodes.n_components();
    NodalVector        vector = nodes.make_vector();
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n; ++c)
        vector.local_element(i * n + c) =
          std::sin(0.3 * nodes.global_index(i) + c);
    return vector;
  }



  /** Matrices of all levels with curvature and truncation at the lower side,
   * and transfers between them, beside those of one process. */
  template <int dim>
  void
  compare_with_one_process(const BentBlock<dim>               &block,
                           const std::vector<NodeFrames<dim>> &frames,
                           const bool                          slides)
  {
    const auto shared = block.make(frames, slides, MPI_COMM_WORLD);
    const auto alone  = block.make(frames, slides, MPI_COMM_SELF);
    for (const auto *problem : {&shared, &alone})
      {
        LevelHierarchy<dim> &hierarchy = *problem->hierarchy;
        hierarchy.set_cycle_precision(CyclePrecision::double_precision);
        // A second linearisation forms only some rows anew.
        for (const unsigned int step : {0, 1})
          {
            const LevelDescription<dim> &finest = hierarchy.finest();
            NodeMask                     active = finest.fixed;
            std::vector<Tensor<2, dim>>  H;
            for (const unsigned int i : finest.nonsmooth_nodes)
              {
                const unsigned int node = finest.nodes.global_index(i);
                if ((node / 4 + step) % 3 == 0)
                  active.mask(i, 0);
                H.emplace_back();
                for (unsigned int c = 0; c < dim; ++c)
                  H.back()[c][c] = 1. + step + node % 7;
              }
            hierarchy.linearise(H, active);
          }
      }
    for (unsigned int l = 0; l < block.n_levels; ++l)
      {
        SCOPED_TRACE(testing::Message() << "level " << l);
        const auto &ours    = shared.hierarchy->description(l);
        const auto &one     = alone.hierarchy->description(l);
        const auto  numbers = same_numbers(block.n_nodes(l));
        EXPECT_LT(difference(shared.hierarchy->level_matrix(l),
                             ours.nodes,
                             alone.hierarchy->level_matrix(l),
                             numbers),
                  1e-13);
        if (l == 0)
          continue;
        const auto &ours_below = shared.hierarchy->description(l - 1);
        const auto &one_below  = alone.hierarchy->description(l - 1);
        NodalVector fine       = ours.nodes.make_vector(),
                    fine_alone = one.nodes.make_vector();
        ours.to_coarser->prolongation().prolongate(
          fine, some_vector(ours_below.nodes), dim);
        one.to_coarser->prolongation().prolongate(fine_alone,
                                                  some_vector(one_below.nodes),
                                                  dim);
        EXPECT_LT(difference(fine, ours.nodes, fine_alone, numbers), 1e-14);
        NodalVector coarse       = ours_below.nodes.make_vector(),
                    coarse_alone = one_below.nodes.make_vector();
        ours.to_coarser->prolongation().restrict_to(coarse,
                                                    some_vector(ours.nodes),
                                                    dim);
        one.to_coarser->prolongation().restrict_to(coarse_alone,
                                                   some_vector(one.nodes),
                                                   dim);
        EXPECT_LT(difference(coarse,
                             ours_below.nodes,
                             coarse_alone,
                             same_numbers(block.n_nodes(l - 1))),
                  1e-14);
      }
  }
} // namespace



TEST(ParallelFrames, LevelsEqualThoseOfOneProcess)
{
  const BentBlock<2> block({{4, 2}}, 4, true);
  compare_with_one_process(block, block.frames_of_lower_side(), true);
  compare_with_one_process(block, block.random_frames(false), false);
  const BentBlock<3> block_3d({{4, 2, 2}}, 3, true);
  compare_with_one_process(block_3d, block_3d.frames_of_lower_side(), true);
  compare_with_one_process(block_3d, block_3d.random_frames(true), true);
}
