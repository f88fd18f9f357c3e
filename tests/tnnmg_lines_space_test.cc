// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/multigrid/strong_lines.h>

#include <iostream>

#include "layered_slider.h"
#include "linear_iterations.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Steps of conjugate gradients without friction, with none, half and all of
   * the jumps truncated, for two step sizes. */
  std::vector<unsigned int>
  steps(const std::array<unsigned int, 3> &cells, const bool has_lines)
  {
    LayeredSliderIn<3>               slider(cells, cells, 1);
    LevelHierarchy<3>               &hierarchy = slider.problem.hierarchy();
    const std::vector<unsigned int> &jumps = hierarchy.finest().nonsmooth_nodes;
    std::mt19937                     engine(5);
    std::normal_distribution<double> normal;
    std::vector<unsigned int>        result;
    EXPECT_EQ(find_strong_lines(hierarchy.operators().matrix().sparsity(),
                                hierarchy.operators().terms(),
                                hierarchy.finest().fixed,
                                jumps)
                .empty(),
              !has_lines);
    for (const double tau : {1e-1, 1e-3})
      {
        slider.problem.combine(Newmark<3>().operator_coefficients(tau));
        for (const double probability : {0., 0.5, 1.})
          {
            std::bernoulli_distribution is_truncated(probability);
            NodeMask                    active = hierarchy.finest().fixed;
            for (const unsigned int p : jumps)
              if (is_truncated(engine))
                for (const unsigned int c : {0, 1})
                  active.mask(p, c);
            linearise_without_friction(hierarchy, active);
            NodalVector x = slider.problem.make_vector();
            for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
              x.local_element(i) = normal(engine);
            active.apply(x);
            result.push_back(cg_iterations(hierarchy, x));
          }
      }
    for (const unsigned int n : cells)
      std::cout << n << ' ';
    std::cout << "cells:";
    for (const unsigned int n : result)
      std::cout << ' ' << n;
    std::cout << std::endl;
    return result;
  }
} // namespace



TEST(TNNMGLines, AreAcrossFlatCellsInSpace)
{
  // Bodies of 5 m x 5 m x 1 m.
  const std::vector<unsigned int> cubes = steps({{5, 5, 1}}, false);
  for (const std::array<unsigned int, 3> &cells :
       std::vector<std::array<unsigned int, 3>>{
         {{2, 2, 4}}, {{2, 2, 8}}, {{25, 5, 1}}, {{50, 5, 1}}})
    {
      const std::vector<unsigned int> n = steps(cells, true);
      for (unsigned int k = 0; k < n.size(); ++k)
        EXPECT_LE(10 * n[k], 16 * cubes[k]);
    }
}
