// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::array<unsigned int, 2> cells = {{10, 2}}, other_cells = {{14, 2}};
} // namespace



TEST(CyclePrecision, SingleTakesAsManyIterationsAsDouble)
{
  for (const double tau : {1e-5, 1e-3, 1e-1})
    {
      LayeredSlider     slider(cells, other_cells, 4);
      const NodalVector b = slider.set_step(tau, 0.65 * slider.normal_stress);
      const Friction<2> friction =
        slider.friction(Kind::truncated, [](const double x, const unsigned) {
          return 3. + 9. * std::tanh(2. * x);
        });
      NodalVector  solution[2];
      unsigned int n_iterations[2];
      for (const CyclePrecision precision :
           {CyclePrecision::single_precision, CyclePrecision::double_precision})
        {
          const bool is_single =
            (precision == CyclePrecision::single_precision);
          TNNMGParameters parameters;
          parameters.tolerance       = 1e-12;
          parameters.cycle_precision = precision;
          NodalVector        w       = slider.start();
          const SolveSummary summary =
            TNNMGSolver<2>(slider.problem.hierarchy(), parameters)
              .solve(*friction.functional, b, w);
          EXPECT_TRUE(summary.converged) << summary;
          solution[is_single]     = w;
          n_iterations[is_single] = summary.iterations.size();
        }
      EXPECT_LE(n_iterations[1], n_iterations[0] + 1);
      const double size = solution[0].linfty_norm();
      solution[1] -= solution[0];
      EXPECT_LT(solution[1].linfty_norm(), 1e-10 * size);
    }
}



TEST(CyclePrecision, NoNumberIsTooSmallOrTooLarge)
{
  LayeredSlider      slider(cells, other_cells, 3);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  slider.set_step(1e-3, 0.);
  linearise_without_friction(hierarchy, hierarchy.finest().fixed);
  NodalVector b = slider.problem.make_vector(), x = b, scaled = b;
  for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
    b.local_element(i) = std::sin(i);
  hierarchy.finest().fixed.apply(b);
  hierarchy.v_cycle(x, b);
  const double size = x.linfty_norm();
  EXPECT_GT(size, 0.);
  for (const double factor : {1e-60, 1e60})
    {
      NodalVector scaled_b = b;
      scaled_b *= factor;
      hierarchy.v_cycle(scaled, scaled_b);
      scaled *= 1. / factor;
      scaled -= x;
      EXPECT_LT(scaled.linfty_norm(), 1e-5 * size);
    }
  // Zero stays zero.
  b = 0.;
  hierarchy.v_cycle(x, b);
  EXPECT_EQ(x.linfty_norm(), 0.);
}
