// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "shared_and_alone.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * A fault with regions of all kinds, whose normal stress follows, on bodies
 * that slide by several faces.
 */
TEST(ParallelKinds, RegionsAreTheSame)
{
  SharedAndAlone runs(read_scene(
    creeping_bodies,
    {"Faults/fault/Regions/Names=threshold, smooth, strong, plate",
     "Faults/fault/Regions/threshold/Where=x < -0.5",
     "Faults/fault/Regions/threshold/Friction=Coulomb",
     "Faults/fault/Regions/threshold/Reference friction coefficient=0.1",
     "Faults/fault/Regions/smooth/Where=x > -0.1 && x < 0.2",
     "Faults/fault/Regions/smooth/Friction=frictionless",
     "Faults/fault/Regions/strong/Where=x > 0.2 && x < 0.5",
     "Faults/fault/Regions/strong/Friction=velocity strengthening",
     "Faults/fault/Regions/plate/Where=x > 0.5",
     "Faults/fault/Regions/plate/Friction=prescribed slip rate",
     "Faults/fault/Regions/plate/Slip rate along x=0.1",
     "Faults/fault/Regions/plate/Slip rate ramp length=0.2",
     "Faults/fault/Normal stress follows=true",
     "Faults/fault/Reference slip rate=0.1",
     "Faults/fault/Characteristic slip=0.1",
     "Boundary conditions/upper top/x value=0.1",
     "Boundary conditions/upper top/Ramp length=0.2",
     "Time/End time=1",
     "Time/Largest step=0.02",
     "Time/Step size control=constant",
     "TNNMG/Tolerance=1e-10"}));
  EXPECT_GT(runs.alone.counts().contact_mappings, 2u);
  for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
    {
      EXPECT_NEAR(runs.ours.normal_stress[k], runs.one.normal_stress[k], 0.1);
      EXPECT_NEAR(runs.ours.shear_traction[k][0],
                  runs.one.shear_traction[k][0],
                  0.1);
      if (runs.one.points[k][0] > 0.5 && runs.one.weights[k] > 0.)
        {
          EXPECT_EQ(std::abs(runs.one.slip_rate[k][0]), 0.1);
        }
    }
}



/* Two welded bodies, of which each process has a part. */
TEST(ParallelKinds, WeldedBodiesAreTheSame)
{
  SharedAndAlone runs(read_scene(creeping_bodies,
                                 {"Faults/fault/Friction=welded",
                                  "Time/End time=0.2",
                                  "TNNMG/Tolerance=1e-10"}));
  double         largest = 0;
  for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
    {
      EXPECT_EQ(runs.ours.slip[k][0], 0.);
      EXPECT_NEAR(runs.ours.shear_traction[k][0],
                  runs.one.shear_traction[k][0],
                  1e-3);
      largest = std::max(largest, std::abs(runs.one.shear_traction[k][0]));
    }
  EXPECT_GT(largest, 10.);
}
