// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/multigrid/linearised_cg.h>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(LinearisedCG, EndsWhereTheResidualIsExpectedToBeSmallEnough)
{
  LayeredSlider              slider({{10, 2}}, {{10, 2}}, 2);
  const LevelDescription<2> &finest    = slider.problem.hierarchy().finest();
  const OperatorSum<2>      &operators = slider.problem.hierarchy().operators();
  const NodalVector          b         = slider.set_step(1e-3, 0.6 * 4.9e4);
  LinearisedCG<2>            cg(operators);
  std::vector<Tensor<2, 2>>  none(finest.nonsmooth_nodes.size());
  cg.linearise(none, finest.fixed);
  // The diagonal as preconditioner.
  const auto jacobi = [&](NodalVector &x, const NodalVector &r) {
    x = 0.;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
        if (finest.fixed.is_active(i, c))
          x.local_element(2 * i + c) =
            r.local_element(2 * i + c) /
            operators.matrix().diagonal_block(i)[c][c];
  };
  const auto solve = [&](const unsigned int min,
                         const unsigned int max,
                         const double       reduction) {
    NodalVector x = slider.problem.make_vector(), A_x = x, r = b, z = x;
    finest.fixed.apply(r);
    NodalVector rest = r;
    jacobi(z, r);
    const double       first = rest * z;
    const unsigned int steps = cg.solve(jacobi, min, max, reduction, x, A_x, r);
    rest -= A_x;
    finest.fixed.apply(rest);
    jacobi(z, rest);
    return std::make_pair(steps, std::sqrt(rest * z / first));
  };
  EXPECT_EQ(solve(3, 3, 0.).first, 3u);
  EXPECT_EQ(solve(1, 7, 1e-12).first, 7u);
  const double       reduction = 1e-4;
  const unsigned int steps     = solve(1, 1000, reduction).first;
  ASSERT_LT(steps, 1000u);
  ASSERT_GT(steps, 3u);
  const auto norm_after = [&](const unsigned int n) {
    return solve(n, n, 0.).second;
  };
  const auto expected_after = [&](const unsigned int n) {
    return norm_after(n - 1) * norm_after(n - 1) / norm_after(n - 2);
  };
  EXPECT_LE(expected_after(steps), reduction);
  EXPECT_GT(expected_after(steps - 1), reduction);
}
