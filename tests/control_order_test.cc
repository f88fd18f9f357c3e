// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct Solution
  {
    std::vector<double> alpha, slip_rate, slip;
  };



  // The fault of the creeping scene at t = 1 by constant steps. The loading
  // begins so smoothly that no waves are stirred up, which would not decay and
  // hide the order.
  Solution
  solve(const double                    tau,
        const std::vector<std::string> &more,
        FaultNodes<2>                  *faults = nullptr)
  {
    const std::vector<std::string> overrides = {
      "Time/Step size control=constant",
      "Time/Largest step=" + std::to_string(tau),
      "Time/End time=1",
      "Boundary conditions/upper top/x value=4e-3*t^4",
      "Boundary conditions/upper top/Ramp length=0",
      "Time/Rate-state tolerance=1e-11",
      "TNNMG/Tolerance=1e-11"};
    SteppingScene scene(creeping_bodies, overrides + more);
    scene.advance_until(0.9999999);
    Solution solution;
    solution.alpha = scene.state.alpha;
    for (unsigned int k = 0; k < solution.alpha.size(); ++k)
      {
        solution.slip_rate.push_back(scene.state.slip_rate[k][0]);
        solution.slip.push_back(scene.state.slip[k][0]);
      }
    if (faults != nullptr)
      *faults = std::move(scene.faults);
    return solution;
  }



  double
  distance(const FaultNodes<2>       &faults,
           const std::vector<double> &a,
           const std::vector<double> &b)
  {
    double sum = 0.;
    for (unsigned int k = 0; k < a.size(); ++k)
      sum += faults.weights()[k] * (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
  }



  // Observed orders of state, slip rate and slip from three step sizes.
  std::array<double, 3>
  observed_orders(const std::vector<std::string> &overrides)
  {
    FaultNodes<2>  faults;
    const Solution coarse = solve(0.025, overrides, &faults),
                   middle = solve(0.0125, overrides),
                   fine   = solve(0.00625, overrides);
    const auto order      = [&](const std::vector<double> Solution::*member) {
      return std::log2(distance(faults, coarse.*member, middle.*member) /
                       distance(faults, middle.*member, fine.*member));
    };
    return {{order(&Solution::alpha),
             order(&Solution::slip_rate),
             order(&Solution::slip)}};
  }
} // namespace



TEST(CoupledStep, ExponentialUpdateIsOfSecondOrder)
{
  for (const std::string law : {"aging", "slip"})
    {
      SCOPED_TRACE(law);
      const auto orders = observed_orders({"Faults/fault/State law=" + law});
      EXPECT_NEAR(orders[0], 2., 0.15);
      EXPECT_NEAR(orders[1], 2., 0.15);
      EXPECT_NEAR(orders[2], 2., 0.15);
    }
}



TEST(CoupledStep, ImplicitEulerUpdateIsOfFirstOrder)
{
  for (const std::string law : {"aging", "slip"})
    {
      SCOPED_TRACE(law);
      const auto orders = observed_orders(
        {"Faults/fault/State law=" + law, "Time/State update=implicit Euler"});
      EXPECT_NEAR(orders[0], 1., 0.15);
      EXPECT_NEAR(orders[1], 1., 0.15);
    }
}



TEST(CoupledStep, NestedAndInterleavedIterationsAgree)
{
  // Sticking and slipping, with the settings that are the defaults.
  for (const std::string reference_friction : {"0", "0.1"})
    {
      SCOPED_TRACE(reference_friction);
      std::vector<Solution> solutions;
      FaultNodes<2>         faults;
      for (const std::string method : {"nested", "interleaved"})
        solutions.push_back(solve(
          0.0125,
          {"Time/Rate-state method=" + method,
           "Faults/fault/Reference friction coefficient=" + reference_friction,
           "Time/Rate-state tolerance=1e-6",
           "TNNMG/Tolerance=1e-8"},
          &faults));
      // The error of a hundred steps, each within the tolerance.
      EXPECT_LE(distance(faults, solutions[0].alpha, solutions[1].alpha), 1e-6);
      std::vector<double> zero(faults.size());
      EXPECT_LE(distance(faults,
                         solutions[0].slip_rate,
                         solutions[1].slip_rate),
                1e-6 * distance(faults, solutions[0].slip_rate, zero));
    }
}
