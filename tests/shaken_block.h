// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_shaken_block_h
#define stickslip_tests_shaken_block_h

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>

#include <algorithm>
#include <cmath>

#include "opening_scene.h"

namespace StickSlip::Tests
{
  /** A block on a table that goes up and down with up to three times the
   * acceleration of gravity. */
  inline const char *const shaken_block = R"(
subsection Bodies
  set Names          = table, block
  set Base elevation = -1
  subsection table
    set Lower lateral corner = -2
    set Upper lateral corner = 2
    set Thickness            = 1
    set Rigid                = true
  end
  subsection block
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 1
    set Coarse cells         = 2, 1
    set Uniform refinements  = 1
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 1e4
      set Bulk viscosity  = 1e4
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Contact             = unilateral
    set Reference slip rate = 0.01
    set Characteristic slip = 1e-3
  end
end
subsection Boundary conditions
  set Sides = table bottom
  subsection table bottom
    set x condition = velocity
    set x value     = 0.05 * sin(31 * t)
    set y condition = velocity
    set y value     = 0.3 * sin(100 * t)
  end
end
subsection Gravity
  set Acceleration = 9.81
end
subsection Time
  set End time = 1
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** Shake the block until it has come off and back so many times, with steps
   * of 1 to 3 ms, and look at gaps, friction and states in each. */
  inline void
  expect_clean_contacts(const unsigned int              n_contacts,
                        const std::vector<std::string> &overrides = {})
  {
    OpeningScene<2> scene(shaken_block, overrides);
    unsigned int    landings = 0, closings = 0, healed = 0, n_steps = 0;
    bool            was_off = false;
    while (landings < n_contacts && scene.state.time < 0.5 * n_contacts)
      {
        const SystemState<2> before = scene.state;
        const double         tau    = 1e-3 * (1 + n_steps++ % 3);
        const StepResult<2>  step   = scene.advance(tau);
        ASSERT_TRUE(step.converged)
          << step.failure << " at " << before.time << " s";
        const SystemState<2> &now = scene.state;
        for (unsigned int k = 0; k < scene.faults.size(); ++k)
          {
            ASSERT_GE(now.gap[k], 0.);
            const double traction =
              shear_traction(scene.faults, scene.laws, now, k).norm();
            if (now.gap[k] == 0.)
              {
                ASSERT_EQ(now.opening_rate[k], 0.);
                ASSERT_GE(now.contact_pressure[k], -1e-6);
                closings += before.gap[k] > 0.;
                continue;
              }
            ASSERT_EQ(now.normal_stress[k], 0.);
            ASSERT_LE(traction, 2e-8);
            if (before.gap[k] == 0.)
              continue;
            ++healed;
            if (scene.laws[k].is_frozen_open)
              ASSERT_EQ(now.alpha[k], before.alpha[k]);
            else
              {
                const double theta = std::exp(before.alpha[k]) + tau;
                ASSERT_NEAR(std::exp(now.alpha[k]), theta, 1e-12 * theta);
              }
          }
        const bool is_off =
          *std::min_element(now.gap.begin(), now.gap.end()) > 0.;
        landings += was_off && !is_off;
        was_off = is_off;
      }
    EXPECT_EQ(landings, n_contacts);
    EXPECT_GE(closings, 3 * n_contacts);
    EXPECT_GT(healed, 10 * n_contacts);
  }
} // namespace StickSlip::Tests

#endif
