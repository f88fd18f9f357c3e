// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <limits>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  IterationSummary
  correction(const double norm, const unsigned int cycles)
  {
    IterationSummary summary;
    summary.correction_norm = norm;
    summary.iterate_norm    = 1.;
    summary.cycles          = cycles;
    return summary;
  }
} // namespace



TEST(Stopping, FewerCyclesReduceTheErrorLess)
{
  const IterationSummary before = correction(1e-3, 3);
  // By 0.064 in three cycles, which is 0.4 in each.
  const double q = 0.064, size = q * 1e-3;
  EXPECT_NEAR(correction(size, 3).relative_error(&before),
              q / (1. - q) * size,
              1e-12 * size);
  EXPECT_NEAR(correction(size, 1).relative_error(&before),
              0.4 / 0.6 * size,
              1e-12 * size);
  // More than in the iteration before are not counted on.
  EXPECT_NEAR(correction(size, 6).relative_error(&before),
              q / (1. - q) * size,
              1e-12 * size);
}



TEST(Stopping, CyclesThatTheToleranceIsWorth)
{
  const IterationSummary before = correction(1e-3, 3);
  const IterationSummary last   = correction(6.4e-5, 3);
  const double           error  = last.relative_error(&before);
  for (unsigned int n = 1; n < 20; ++n)
    {
      const double f = std::pow(0.4, n), left = f / (1. - f) * error;
      EXPECT_EQ(last.sufficient_cycles(&before, 1.001 * left), n);
      EXPECT_EQ(last.sufficient_cycles(&before, 0.999 * left), n + 1);
    }
  EXPECT_EQ(last.sufficient_cycles(&before, 1e3), 1u);

  // Nothing tells how many after one correction, or after slow ones.
  constexpr unsigned int any = std::numeric_limits<unsigned int>::max();
  EXPECT_EQ(last.sufficient_cycles(nullptr, 1e-8), any);
  EXPECT_EQ(correction(5e-4, 3).sufficient_cycles(&before, 1e-8), any);
}



TEST(Stopping, ErrorsAreWhatIsAskedFor)
{
  LayeredSlider      slider({{10, 2}}, {{14, 2}}, 4);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  const auto         solve     = [&](const double       tolerance,
                         const Friction<2> &friction,
                         const NodalVector &rhs,
                         NodalVector       &w) {
    TNNMGParameters parameters;
    parameters.tolerance = tolerance;
    w                    = slider.start();
    const SolveSummary summary =
      TNNMGSolver<2>(hierarchy, parameters).solve(*friction.functional, rhs, w);
    EXPECT_TRUE(summary.converged);
    return summary.n_cycles();
  };
  const auto energy_norm = [&](const NodalVector &w) {
    NodalVector A_w = w;
    hierarchy.operators().matrix().vmult(A_w, w);
    return std::sqrt(w * A_w);
  };

  for (const double tau : {1e-3, 0.1})
    for (const bool is_random : {false, true})
      {
        SCOPED_TRACE(testing::Message() << tau << ", " << is_random);
        const NodalVector rhs = slider.set_step(tau, 2.8e4);
        const Friction<2> friction =
          slider.friction(Kind::truncated,
                          [&](const double x, const unsigned int k) {
                            return is_random ? 9. * std::sin(54321. * k + 1.) :
                                               (x < 0. ? -9. : 9.);
                          });
        NodalVector exact = slider.start(), w = exact;
        solve(1e-13, friction, rhs, exact);
        unsigned int cycles_before = 0;
        for (const double tolerance :
             {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
          {
            const unsigned int cycles = solve(tolerance, friction, rhs, w);
            w -= exact;
            EXPECT_LT(energy_norm(w) / energy_norm(exact), 1.5 * tolerance);
            EXPECT_GE(cycles, cycles_before);
            // A digit is worth no more than four cycles, at any tolerance.
            if (cycles_before > 0)
              {
                EXPECT_LE(cycles, cycles_before + 4);
              }
            cycles_before = cycles;
          }
      }
}
