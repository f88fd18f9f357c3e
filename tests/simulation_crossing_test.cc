// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "creeping_crossing.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A way to compute the same, and how much of the slip it may differ by. */
  struct Way
  {
    const char *name;
    const char *setting;
    double      tolerance;
  };

  const std::vector<Way> ways = {
    {"condensed", "Time/Rate solver=condensed Newton", 1e-6},
    {"direct correction", "TNNMG/Linear correction=UMFPACK", 1e-6},
    {"nested", "Time/Rate-state method=nested", 1e-6},
    {"step doubling", "Time/Step size control=step doubling", 2e-2}};
} // namespace



// Crossing faults in one body: all solvers and controls give the same.
class CrossingFaults : public ::testing::TestWithParam<const char *>
{};

TEST_P(CrossingFaults, AreTheSameWhateverTheSolver)
{
  const std::string inertia = std::string("Time/Inertia=") + GetParam();
  const auto        faults  = end_of_crossing({inertia});
  for (const Way &way : ways)
    {
      SCOPED_TRACE(way.name);
      expect_same_faults(faults,
                         end_of_crossing({inertia, way.setting}),
                         way.tolerance);
    }
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
