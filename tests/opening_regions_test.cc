// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies of 8 m by 4 m that are one but for 1 m in the middle, where
   * they are pulled apart; without mass and friction. */
  const char *const cracked_plate = R"(
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -4
  subsection lower
    set Lower lateral corner = -4
    set Upper lateral corner = 4
    set Thickness            = 4
    set Coarse cells         = 16, 8
    set Uniform refinements  = 3
    set Refinement passes    = 0
    subsection Material
      set Young modulus   = 1e9
      set Poisson ratio   = 0.25
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
  subsection upper
    set Lower lateral corner = -4
    set Upper lateral corner = 4
    set Thickness            = 4
    set Coarse cells         = 16, 8
    set Uniform refinements  = 3
    set Refinement passes    = 0
    subsection Material
      set Young modulus   = 1e9
      set Poisson ratio   = 0.25
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = plane
  subsection plane
    set Friction = welded
    subsection Regions
      set Names = crack
      subsection crack
        set Where    = abs(x) < 0.5
        set Friction = frictionless
        set Contact  = unilateral
      end
    end
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = fixed
    set y condition = traction
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 10
  set Inertia  = quasi-static
end
subsection TNNMG
  set Tolerance = 1e-10
end
subsection Output
  set Event start slip rate = 1
end
)";
} // namespace



TEST(OpeningRegions, ACrackBetweenWeldedPartsOpensAsGriffithSays)
{
  const double    traction = 1e5;
  OpeningScene<2> scene(cracked_plate,
                        {"Boundary conditions/upper top/y value=" +
                         std::to_string(traction)});
  for (unsigned int i = 0; i < 3; ++i)
    {
      const StepResult<2> step = scene.advance(1.);
      ASSERT_TRUE(step.converged) << step.failure;
    }
  // The last nodes that open are a cell's size inside of the tips, which are
  // where the sides first hold together; in a plate without end.
  const double a = 0.5, depth = 4. * (1. - 0.25 * 0.25) * traction * a / 1e9;
  const auto &points = scene.problem.jump_basis().faults().front().slave.points;
  unsigned int n_open = 0;
  for (unsigned int k = 0; k < points.size(); ++k)
    {
      const double x = points[k][0];
      EXPECT_EQ(scene.state.gap[k] > 0., std::abs(x) < a - 1e-9) << x;
      if (std::abs(x) < 0.7 * a)
        {
          EXPECT_NEAR(scene.state.gap[k],
                      depth * std::sqrt(1. - x * x / (a * a)),
                      0.06 * depth);
        }
      n_open += scene.state.gap[k] > 0.;
    }
  EXPECT_EQ(n_open, 15u);
}



TEST(OpeningRegions, WhatIsPressedTogetherIsAsIfItCouldNotOpen)
{
  const std::vector<std::string> pressed = {
    "Boundary conditions/upper top/y value=-1e5 * (1 + 0.2 * sin(x))"};
  std::vector<std::string> bilateral = pressed;
  bilateral.emplace_back("Faults/plane/Regions/crack/Contact=bilateral");
  OpeningScene<2> opens(cracked_plate, pressed), held(cracked_plate, bilateral);
  for (OpeningScene<2> *scene : {&opens, &held})
    for (unsigned int i = 0; i < 2; ++i)
      ASSERT_TRUE(scene->advance(1.).converged);
  EXPECT_EQ(*std::max_element(opens.state.gap.begin(), opens.state.gap.end()),
            0.);
  NodalVector difference = opens.state.displacement;
  difference -= held.state.displacement;
  EXPECT_LE(difference.linfty_norm(),
            1e-9 * held.state.displacement.linfty_norm());
}



namespace
{
  /** Two layers of 2 m without ends; the upper one is pulled up and pressed
   * down in turn along it, and drawn along. */
  std::string
  endless_scene(const double shift)
  {
    const std::string x    = "(x - " + std::to_string(shift) + ")";
    const std::string body = R"(
    set Lower lateral corner = 0
    set Upper lateral corner = 2
    set Thickness            = 0.5
    set Coarse cells         = 8, 2
    set Uniform refinements  = 2
    set Refinement passes    = 0
  end
)";
    return "subsection Bodies\n  set Names = lower, upper\n"
           "  set Base elevation = -0.5\n  subsection lower" +
           body + "  subsection upper" + body + R"(end
subsection Faults
  set Names = fault
  subsection fault
    set Contact             = unilateral
    set Reference slip rate = 0.01
    set Characteristic slip = 1e-3
  end
end
subsection Boundary conditions
  set Periodic along x = true
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = traction
    set x value     = 3e3
    set y condition = traction
    set y value     = 8e4 * sin(pi * )" +
           x + R"() * sin(60 * t)
    set Ramp length = 0.01
  end
end
subsection Time
  set End time = 1
  set Rate-state tolerance = 1e-10
end
subsection TNNMG
  set Tolerance = 1e-11
end
subsection Output
  set Event start slip rate = 1
end
)";
  }



  /** Gaps and slips by place. */
  std::map<long, std::pair<double, double>>
  on_circle(const OpeningScene<2> &scene, const double shift)
  {
    const auto &points =
      scene.problem.jump_basis().faults().front().slave.points;
    std::map<long, std::pair<double, double>> result;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        double x = points[k][0] - shift;
        x -= 2. * std::floor(x / 2. + 1e-9);
        result[std::lround(1e6 * x)] = {scene.state.gap[k],
                                        scene.state.slip[k][0]};
      }
    return result;
  }
} // namespace



TEST(OpeningRegions, PeriodicSidesAreNoSides)
{
  // Half of the wave opens; moved along, it is the same.
  const double    shift = 0.75;
  OpeningScene<2> first(endless_scene(0.)), moved(endless_scene(shift));
  unsigned int    n_changes = 0;
  for (unsigned int i = 0; i < 60; ++i)
    {
      const std::vector<double> before = first.state.gap;
      for (OpeningScene<2> *scene : {&first, &moved})
        {
          const StepResult<2> step = scene->advance(2e-3);
          ASSERT_TRUE(step.converged) << step.failure;
        }
      for (unsigned int k = 0; k < before.size(); ++k)
        n_changes += (before[k] > 0.) != (first.state.gap[k] > 0.);
      const auto one = on_circle(first, 0.), other = on_circle(moved, shift);
      ASSERT_EQ(one.size(), other.size());
      for (const auto &[place, values] : one)
        {
          EXPECT_NEAR(values.first, other.at(place).first, 1e-9);
          EXPECT_NEAR(values.second, other.at(place).second, 1e-9);
        }
    }
  EXPECT_GT(n_changes, 20u);
}
