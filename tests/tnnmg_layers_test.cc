// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <iostream>

#include "linear_iterations.h"
#include "opening_layers.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Steps of conjugate gradients between two bodies of 1 m, with none, half
   * and all of the jumps truncated. */
  std::vector<unsigned int>
  steps(const double thickness, const unsigned int n_cells)
  {
    OpeningLayers<2>                 layers({make_body<2>(1., {{10, 2}}, 4),
                                             make_body<2>(thickness, {{n_cells, 1}}, 1),
                                             make_body<2>(1., {{10, 2}}, 4)},
                            /*opens=*/false);
    LevelHierarchy<2>               &hierarchy = layers.problem.hierarchy();
    const std::vector<unsigned int> &jumps = hierarchy.finest().nonsmooth_nodes;
    std::mt19937                     engine(5);
    std::normal_distribution<double> normal;
    layers.problem.combine(Newmark<2>().operator_coefficients(1e-2));
    std::vector<unsigned int> result;
    for (const double probability : {0., 0.5, 1.})
      {
        std::bernoulli_distribution is_truncated(probability);
        NodeMask                    active = hierarchy.finest().fixed;
        for (const unsigned int p : jumps)
          if (is_truncated(engine))
            active.mask(p, 0);
        linearise_without_friction(hierarchy, active);
        NodalVector x = layers.problem.make_vector();
        for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
          x.local_element(i) = normal(engine);
        active.apply(x);
        result.push_back(cg_iterations(hierarchy, x));
      }
    std::cout << thickness << " m, " << n_cells << " cells:";
    for (const unsigned int n : result)
      std::cout << ' ' << n;
    std::cout << std::endl;
    return result;
  }
} // namespace



TEST(TNNMG, LayersMayBeThinAndTheirCellsFineOrFlat)
{
  // A layer that slides on both sides is a long bar, which takes more steps the
  // thinner it is.
  const std::vector<unsigned int> at_most = {42, 18, 12};
  for (const auto &layer :
       std::vector<std::pair<double, unsigned int>>{{0.3, 16},
                                                    {0.01, 100},
                                                    {0.01, 10},
                                                    {0.003, 333},
                                                    {0.003, 33},
                                                    {0.001, 1000}})
    {
      const std::vector<unsigned int> n = steps(layer.first, layer.second);
      for (unsigned int k = 0; k < n.size(); ++k)
        EXPECT_LE(n[k], at_most[k]) << layer.first << ' ' << k;
    }
}
