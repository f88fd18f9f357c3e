// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  double
  relative_difference(const NodalVector &a, const NodalVector &b)
  {
    NodalVector difference = a;
    difference -= b;
    return difference.linfty_norm() / b.linfty_norm();
  }



  /** Advance both scenes and compare what they have come to. */
  void
  expect_same_run(SteppingScene &scene,
                  SteppingScene &reference,
                  const double   end)
  {
    scene.advance_until(end);
    reference.advance_until(end);
    ASSERT_EQ(scene.state.time, reference.state.time);
    double fastest = 0, difference = 0;
    for (unsigned int k = 0; k < reference.state.slip_rate.size(); ++k)
      {
        fastest    = std::max(fastest, reference.state.slip_rate[k].norm());
        difference = std::max(
          difference,
          (scene.state.slip_rate[k] - reference.state.slip_rate[k]).norm());
      }
    EXPECT_GT(fastest, 0.);
    EXPECT_LE(difference, 1e-6 * fastest);
    EXPECT_LE(relative_difference(scene.state.velocity,
                                  reference.state.velocity),
              1e-6);
    EXPECT_LE(relative_difference(scene.state.displacement,
                                  reference.state.displacement),
              1e-6);
  }
} // namespace



TEST(RateSolver, CondensedNewtonGivesTheSlipRatesOfTNNMG)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic", "quasi-static"})
    for (const std::string method : {"interleaved", "nested"})
      {
        SCOPED_TRACE(inertia + ", " + method);
        const std::string option   = "Time/Rate-state method=" + method,
                          inertial = "Time/Inertia=" + inertia;
        SteppingScene reference(creeping_bodies, {option, inertial});
        SteppingScene scene(creeping_bodies,
                            {option,
                             inertial,
                             "Time/Rate solver=condensed Newton"});
        expect_same_run(scene, reference, 1.5);
        EXPECT_EQ(scene.memory.work.multigrid_cycles, 0u);
        EXPECT_GT(reference.memory.work.multigrid_cycles, 0u);
      }
}



TEST(RateSolver, OtherCorrectionsGiveTheSlipRatesOfMultigrid)
{
  // Differences that iterations leave are none of the corrections.
  const Settings accurate = {"TNNMG/Tolerance=1e-11",
                             "Time/Rate-state tolerance=1e-10"};
  SteppingScene  reference(creeping_bodies, accurate);
  for (const std::string correction : {"UMFPACK", "MUMPS"})
    {
      SCOPED_TRACE(correction);
      SteppingScene scene(creeping_bodies,
                          accurate +
                            Settings{"TNNMG/Linear correction=" + correction});
      expect_same_run(scene, reference, 0.5);
    }
}
