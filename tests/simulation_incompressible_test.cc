// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/simulation/fault_layouts.h>

#include <cmath>
#include <iostream>
#include <numeric>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  SceneParameters<2>
  spring_slider(const double poissons_ratio, const Settings &more = {})
  {
    const std::string nu = std::to_string(poissons_ratio);
    Settings          settings;
    for (const std::string body : {"lower", "upper"})
      {
        const std::string material = "Bodies/" + body + "/Material/";
        settings.push_back(material + "Poisson ratio=" + nu);
        settings.push_back(material + "Volumetric strain=patch mean");
      }
    return published_scene("spring_slider", settings + more);
  }
} // namespace



// Means over single cells give tractions that alternate by 30 and 40 % of their
// largest one from node to node, nodes that slip at once, and 40 times the
// steps.
TEST(NearlyIncompressible, TractionsOfTheFaultDoNotAlternate)
{
  for (const double nu : {0.49, 0.499, 0.4999, 0.49999})
    {
      SteppingScene scene(spring_slider(nu));
      unsigned int  n_steps = 0, n_iterations = 0;
      while (scene.state.time < 0.02)
        for (const StepResult<2> &step : scene.advance())
          {
            ++n_steps;
            n_iterations += step.counts.tnnmg_iterations;
          }
      std::cout << nu << ": " << n_steps << " steps, " << n_iterations
                << " iterations" << std::endl;
      EXPECT_LE(n_steps, 8u);

      std::vector<unsigned int> order(scene.faults.size());
      std::iota(order.begin(), order.end(), 0);
      const auto points =
        fault_positions(scene.problem.jump_basis(),
                        scene.problem.hierarchy().finest().nodes,
                        scene.state.displacement)[0];
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return points[a][0] < points[b][0];
      });
      std::vector<double> traction;
      double              largest = 0., fastest = 0.;
      for (const unsigned int k : order)
        {
          traction.push_back(
            shear_traction(scene.faults, scene.laws, scene.state, k)[0]);
          largest = std::max(largest, std::abs(traction.back()));
          fastest = std::max(fastest, magnitude(scene.state.slip_rate[k]));
        }
      EXPECT_LT(fastest, 1e-15);
      for (unsigned int i = 1; i + 1 < traction.size(); ++i)
        EXPECT_LT(std::abs(traction[i] -
                           0.5 * (traction[i - 1] + traction[i + 1])),
                  (i == 1 || i + 2 == traction.size() ? 0.06 : 0.02) * largest)
          << nu << ' ' << i;
    }
}
