// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "creeping_crossing.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Entries that change how the same steps are solved.
  const std::vector<std::string> solvers = {"Time/Rate solver=condensed Newton",
                                            "TNNMG/Linear correction=UMFPACK",
                                            "Time/Rate-state method=nested"};
} // namespace



// Crossing faults in one body: all solvers give the same, and all controls of
// the step size nearly so.
class CrossingFaults : public ::testing::TestWithParam<const char *>
{};

TEST_P(CrossingFaults, AreTheSameWhateverTheSolver)
{
  const std::string inertia  = std::string("Time/Inertia=") + GetParam(),
                    constant = "Time/Step size control=constant";
  const auto faults          = end_of_crossing({inertia, constant});
  for (const std::string &solver : solvers)
    {
      SCOPED_TRACE(solver);
      expect_same_faults(faults,
                         end_of_crossing({inertia, constant, solver}),
                         1e-6);
    }
  const auto with_control = [&](const std::string &control) {
    return end_of_crossing({inertia,
                            "Time/Step size control=" + control,
                            "Time/Tolerance=1e-4",
                            "Time/Doubling threshold=1e-3"});
  };
  expect_same_faults(with_control("embedded"),
                     with_control("step doubling"),
                     0.01);
}

INSTANTIATE_TEST_SUITE_P(Inertia,
                         CrossingFaults,
                         ::testing::Values("dynamic",
                                           "quasi-dynamic",
                                           "quasi-static"),
                         [](const auto &info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
