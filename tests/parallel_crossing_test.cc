// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "creeping_crossing.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

// Crossing faults in one body, whose nodes belong to several processes.
TEST(ParallelCrossing, FaultsAreTheSame)
{
  for (const char *inertia : {"dynamic", "quasi-dynamic"})
    {
      SCOPED_TRACE(inertia);
      const std::vector<std::string> settings = {
        std::string("Time/Inertia=") + inertia,
        "Time/Step size control=constant",
        "Bodies/block/Uniform refinements=1"};
      expect_same_faults(end_of_crossing(settings, MPI_COMM_SELF),
                         end_of_crossing(settings),
                         1e-6);
    }
}
