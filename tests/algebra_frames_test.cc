// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/algebra/node_frames.h>

#include <cmath>

#include "serial_matrices.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  Tensor<2, 2>
  turned_by(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return Tensor<2, 2>({{c, -s}, {s, c}});
  }
} // namespace



TEST(NodeFrames, AreThoseOfSpaceUntilTheyAreSet)
{
  NodeFrames<2> frames;
  EXPECT_TRUE(frames.empty());
  EXPECT_EQ(frames.find(4), nullptr);
  EXPECT_TRUE(frames.local_part(serial_nodes(10, 2)).empty());

  frames.set(7, turned_by(0.3));
  frames.set(4, turned_by(-1.2));
  EXPECT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames.find(5), nullptr);
  ASSERT_NE(frames.find(4), nullptr);
  EXPECT_EQ(*frames.find(4), turned_by(-1.2));
  std::vector<types::global_dof_index> nodes;
  for (const auto &[node, axes] : frames)
    {
      nodes.push_back(node);
      EXPECT_EQ(axes, *frames.find(node));
    }
  EXPECT_EQ(nodes, (std::vector<types::global_dof_index>{4, 7}));

  // Axes of space are not stored.
  frames.set(7, turned_by(0.));
  EXPECT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames.find(7), nullptr);
}



TEST(NodeFrames, MustBeOrthonormal)
{
  NodeFrames<2> frames;
  EXPECT_THROW(frames.set(0, 1.001 * turned_by(0.1)), ExceptionBase);
  EXPECT_THROW(frames.set(0, Tensor<2, 2>({{1., 1e-6}, {0., 1.}})),
               ExceptionBase);
  EXPECT_TRUE(frames.empty());

  // Mirrored axes are axes, too.
  frames.set(0, Tensor<2, 2>({{1., 0.}, {0., -1.}}));
  NodeFrames<1> signs;
  signs.set(3, Tensor<2, 1>({{-1.}}));
  EXPECT_EQ(signs.size(), 1u);
  EXPECT_THROW(signs.set(3, Tensor<2, 1>({{2.}})), ExceptionBase);
}



TEST(NodeFrames, LocalPartHoldsOwnedNodesAndGhosts)
{
  NodeFrames<3> frames;
  Tensor<2, 3>  axes;
  // Columns: the axes y, z and x.
  axes[1][0] = axes[2][1] = axes[0][2] = 1.;
  frames.set(2, axes);
  frames.set(5, -axes);
  const LocalFrames local = frames.local_part(serial_nodes(6, 3));
  EXPECT_FALSE(local.empty());
  EXPECT_EQ(local.n_components(), 3u);
  EXPECT_EQ(local.nodes(), (std::vector<unsigned int>{2, 5}));
  EXPECT_EQ(local.find(0), nullptr);
  ASSERT_NE(local.find(2), nullptr);
  ASSERT_NE(local.find(5), nullptr);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_EQ(local.find(2)[c * 3 + d], axes[c][d]);
        EXPECT_EQ(local.find(5)[c * 3 + d], -axes[c][d]);
      }
  // Others than those of these nodes do not count.
  EXPECT_TRUE(frames.local_part(serial_nodes(2, 3)).empty());
}
