// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "antiplane_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

TEST(ParallelAntiplane, FaultIsTheSame)
{
  const Settings settings = {"Bodies/lower/Uniform refinements=1",
                             "Bodies/upper/Uniform refinements=1",
                             "Faults/fault/Initial slip rate along x=1e-9",
                             "TNNMG/Tolerance=1e-9",
                             "Time/End time=1"};
  const auto [slip, rate] =
    difference(end_of_antiplane_run(antiplane_bodies, settings),
               end_of_antiplane_run(antiplane_bodies, settings, MPI_COMM_SELF));
  EXPECT_LT(slip, 1e-6);
  EXPECT_LT(rate, 1e-4);
}
