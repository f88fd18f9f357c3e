// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A bar of length 1 m above a rigid wall, whose waves travel at 10 m/s. */
  const char *const bar_on_wall = R"(
subsection Bodies
  set Names          = wall, bar
  set Base elevation = -1
  subsection wall
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 1
    set Rigid                = true
  end
  subsection bar
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 1
    set Uniform refinements  = 7
    set Refinement passes    = 0
    set Coarse cells         = 1, 1
    subsection Material
      set Young modulus = 100
      set Poisson ratio = 0
      set Density       = 1
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Friction    = frictionless
    set Contact     = unilateral
    set Initial gap = 0.01
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 1
end
subsection Output
  set Event start slip rate = 1
end
)";
} // namespace



TEST(OpeningBar, StepsThatCloseGapsAreSplit)
{
  for (const double cfl : {0.5, 2., 8.})
    {
      double       lost[2] = {0., 0.};
      unsigned int n = 0, solved[2] = {0, 0};
      for (const double gap :
           {0.0100, 0.0103, 0.0107, 0.0111, 0.0114, 0.0118, 0.0121, 0.0125})
        {
          ++n;
          for (const bool split : {false, true})
            {
              const double    tau = cfl / 128. / 10.;
              OpeningScene<2> scene(
                bar_on_wall,
                {"Bodies/bar/Uniform refinements=5",
                 "Bodies/bar/Upper lateral corner=0.25",
                 "Bodies/bar/Coarse cells=1, 4",
                 "Faults/contact/Initial gap=" + std::to_string(gap),
                 "Time/Step size control=constant",
                 "Time/Largest step=" + std::to_string(tau)});
              scene.scene.time.impact_tolerance = split ? 1e-3 : 1e9;
              scene.scene.time.largest_step     = tau;
              scene.start_free([](const unsigned int body, const Point<2> &) {
                Tensor<1, 2> v;
                v[1] = body == 1 ? -1. : 0.;
                return v;
              });
              const double start = scene.total_energy();
              const auto   controller =
                make_step_size_controller(*scene.step,
                                          scene.scene.time,
                                          scene.boundary_values);
              StepMemory<2> memory;
              while (scene.state.time < 0.1)
                for (auto &step : controller->advance(scene.state, memory))
                  {
                    lost[split] += step.contact_energy.lost / start;
                    scene.state = step.state;
                  }
              solved[split] += memory.n_solved;
            }
        }
      std::cout << "cfl " << cfl << " lost " << lost[0] / n << " split "
                << lost[1] / n << " solved " << solved[0] << ' ' << solved[1]
                << '\n';
    }
}
