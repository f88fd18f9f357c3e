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



TEST(OpeningBar, BouncesOffAWall)
{
  for (const double cfl : {0.5, 2., 8.})
    {
      OpeningScene<2> scene(bar_on_wall,
                            {"Bodies/bar/Uniform refinements=5",
                             "Bodies/bar/Upper lateral corner=0.25",
                             "Bodies/bar/Coarse cells=1, 4"});
      scene.start_free([](const unsigned int body, const Point<2> &) {
        Tensor<1, 2> v;
        v[1] = body == 1 ? -1. : 0.;
        return v;
      });
      const double start = scene.total_energy();
      const double h = 1. / 128, tau = cfl * h / 10.;
      double       lost         = 0;
      unsigned int n_iterations = 0;
      while (scene.state.time < 0.3)
        {
          const auto result = scene.advance(tau);
          ASSERT_TRUE(result.converged) << result.failure;
          lost += result.contact_energy.lost;
          n_iterations += result.counts.tnnmg_iterations;
          if (std::getenv("TALK") && scene.state.time > 0.01 &&
              scene.state.time < 0.0105)
            {
              const auto &level = scene.meshes.finest();
              const auto  pos   = level.bodies[1]->node_positions();
              for (unsigned int i = 0; i < pos.size(); ++i)
                if (pos[i][0] == 0.)
                  {
                    const auto n =
                      level.nodes.local_index(level.global_node(1, i));
                    std::cout
                      << "   y " << pos[i][1] << " vy "
                      << scene.state.velocity.local_element(2 * n + 1) << " u "
                      << scene.state.displacement.local_element(2 * n + 1)
                      << '\n';
                  }
            }
          if (std::getenv("TALK"))
            std::cout << scene.state.time << ' ' << scene.state.gap[0] << ' '
                      << scene.state.contact_pressure[0] << ' '
                      << scene.total_energy() / start << ' ' << lost / start
                      << ' ' << result.counts.tnnmg_iterations << '\n';
        }
      std::cout << cfl << " energy " << 1. - scene.total_energy() / start
                << " lost " << lost / start << " its " << n_iterations << ' '
                << scene.state.gap[0] << '\n';
    }
}
