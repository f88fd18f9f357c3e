// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_shared_and_alone_h
#define stickslip_tests_shared_and_alone_h

#include "simulation_scenes.h"

namespace StickSlip::Tests
{
  /** Bounds of the differences of a fault in two runs. */
  struct FaultTolerance
  {
    double slip      = 1e-6;
    double slip_rate = 1e-5;
    /** Relative. */
    double state = 1e-4;
  };



  /**
   * A scene with the one fault "fault", run on all processes together and on
   * each alone.
   */
  struct SharedAndAlone
  {
    Simulation<2>    shared, alone;
    FaultSnapshot<2> ours, one;

    SharedAndAlone(const SceneParameters<2> &scene,
                   const FaultTolerance     &tolerance = {})
      : shared(scene, MPI_COMM_WORLD)
      , alone(scene, MPI_COMM_SELF)
    {
      for (Simulation<2> *simulation : {&shared, &alone})
        {
          simulation->set_up();
          while (!simulation->is_finished())
            simulation->advance();
        }
      ours = snapshots(shared).front();
      one  = snapshots(alone).front();
      expect_equal(tolerance);
    }

  private:
    void
    expect_equal(const FaultTolerance &tolerance) const
    {
      EXPECT_EQ(shared.state().time, alone.state().time);
      ASSERT_EQ(ours.slip.size(), one.slip.size());
      for (unsigned int k = 0; k < ours.slip.size(); ++k)
        {
          EXPECT_EQ(ours.points[k], one.points[k]);
          EXPECT_NEAR(ours.slip[k][0], one.slip[k][0], tolerance.slip);
          EXPECT_NEAR(ours.slip_rate[k][0],
                      one.slip_rate[k][0],
                      tolerance.slip_rate);
          EXPECT_NEAR(ours.state[k],
                      one.state[k],
                      tolerance.state * one.state[k]);
        }
    }
  };
} // namespace StickSlip::Tests

#endif
