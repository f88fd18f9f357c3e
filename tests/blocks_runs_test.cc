// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "simulation_scenes.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A wedge on a layer, as a stack. */
  const std::string stack = R"(
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -0.5
  subsection lower
    set Lower lateral corner = -1.5
    set Upper lateral corner = 1.5
    set Thickness            = 0.5
    set Coarse cells         = 6, 1
    set Refinement passes    = 2
  end
  subsection upper
    set Lower lateral corner = -1.2
    set Upper lateral corner = 1.3
    set Thickness            = 0.3
    set Upper slope          = 0.2
    set Coarse cells         = 5, 1
    set Refinement passes    = 2
  end
end
)";

  const std::string rest = R"(
subsection Faults
  set Names = fault
  subsection fault
    set Characteristic slip    = 4e-6
    set Normal stress          = function
    set Normal stress function = 1e4
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper right
  subsection lower bottom
    set x condition = velocity
    set y condition = velocity
  end
  subsection upper right
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Time
  set End time             = 5
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
)";



  /** Wedge and layer by their corners, turned about the origin. */
  std::string
  blocks(const double angle)
  {
    const auto corners = [angle](const std::array<Point<2>, 4> &points) {
      std::string text;
      for (const Point<2> &p : points)
        text += (text.empty() ? "" : ", ") +
                shortest_form(std::cos(angle) * p[0] - std::sin(angle) * p[1]) +
                " " +
                shortest_form(std::sin(angle) * p[0] + std::cos(angle) * p[1]);
      return text;
    };
    return "subsection Bodies\n  set Names = lower, upper\n"
           "  subsection lower\n    set Corners = " +
           corners({{{-1.5, -0.5}, {1.5, -0.5}, {1.5, 0.}, {-1.5, 0.}}}) +
           "\n    set Coarse cells = 6, 1\n    set Refinement passes = 2\n"
           "  end\n  subsection upper\n    set Corners = " +
           corners({{{-1.2, 0.}, {1.3, 0.}, {1.3, 0.8}, {-1.2, 0.3}}}) +
           "\n    set Coarse cells = 5, 1\n    set Refinement passes = 2\n"
           "  end\nend\n"
           "subsection Faults\n  subsection fault\n"
           "    set Between = lower top, upper bottom\n  end\nend\n";
  }



  RunHistory
  run(const std::string &bodies, const double angle)
  {
    const TemporaryFolder folder;
    const double          speed = 2e-4;
    return RunHistory(
      SceneReader(folder.write("scene.prm", bodies + rest),
                  {"Boundary conditions/lower bottom/x value=" +
                     shortest_form(speed * std::cos(angle)),
                   "Boundary conditions/lower bottom/y value=" +
                     shortest_form(speed * std::sin(angle)),
                   "Gravity/Dip=" + shortest_form(angle * 180. / numbers::PI)})
        .read<2>());
  }



  void
  expect_the_same(const RunHistory &a, const RunHistory &b)
  {
    ASSERT_EQ(a.steps.size(), b.steps.size());
    ASSERT_FALSE(a.events.empty());
    const auto expect_near = [&](const auto &value) {
      double difference = 0., largest = 0.;
      for (unsigned int i = 0; i < a.steps.size(); ++i)
        {
          difference =
            std::max(difference,
                     std::abs(value(a.steps[i]) - value(b.steps[i])));
          largest = std::max(largest, std::abs(value(a.steps[i])));
        }
      EXPECT_LE(difference, 1e-8 * largest);
    };
    using Step = RunHistory::Step;
    expect_near([](const Step &s) { return s.time; });
    expect_near([](const Step &s) { return s.fault.max_slip_rate; });
    expect_near([](const Step &s) { return s.fault.mean_slip; });
    expect_near([](const Step &s) { return s.fault.mean_state; });
    expect_near([](const Step &s) { return s.fault.mean_shear_traction; });
  }
} // namespace



// Over a run with events, loads and weight turned along.
TEST(BlockRuns, WedgeByCornersIsThatBySlope)
{
  const RunHistory sloped = run(stack, 0.);
  expect_the_same(sloped, run(blocks(0.), 0.));
  expect_the_same(sloped, run(blocks(numbers::PI / 6.), numbers::PI / 6.));
}
