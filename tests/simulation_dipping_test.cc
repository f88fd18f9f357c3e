// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "simulation_scenes.h"
#include "temporary_folder.h"
#include "turned_layers.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A run of the layers turned by an angle, with loads and weight that turn
   * along. */
  RunHistory
  run(const double angle, const Cells cells)
  {
    const TemporaryFolder folder;
    folder.write("layers.msh", turned_layers(angle, cells).text());
    const double speed = 2e-4;
    return RunHistory(
      SceneReader(folder.write("layers.prm", turned_scene(angle)),
                  {"Boundary conditions/upper top/x value=" +
                     shortest_form(speed * std::cos(angle)),
                   "Boundary conditions/upper top/y value=" +
                     shortest_form(speed * std::sin(angle)),
                   "Gravity/Dip=" + shortest_form(angle * 180. / numbers::PI)})
        .read<2>());
  }



  /** Largest difference along a run, over the largest value. */
  template <typename Value>
  double
  difference(const RunHistory &a, const RunHistory &b, const Value &value)
  {
    double difference = 0, largest = 0;
    for (unsigned int i = 0; i < a.steps.size(); ++i)
      {
        const double x = value(a.steps[i]), y = value(b.steps[i]);
        difference = std::max(difference, std::abs(x - y));
        largest    = std::max(largest, std::abs(x));
      }
    return difference / largest;
  }



  void
  expect_the_same_run(const double angle, const Cells cells)
  {
    const RunHistory level = run(0., cells), dipping = run(angle, cells);
    ASSERT_EQ(level.steps.size(), dipping.steps.size());
    ASSERT_FALSE(level.events.empty());
    using Step = RunHistory::Step;
    EXPECT_LE(difference(level, dipping, [](const Step &s) { return s.time; }),
              1e-8);
    EXPECT_LE(difference(level,
                         dipping,
                         [](const Step &s) { return s.fault.max_slip_rate; }),
              1e-8);
    EXPECT_LE(difference(level,
                         dipping,
                         [](const Step &s) { return s.fault.mean_slip; }),
              1e-8);
    EXPECT_LE(difference(level,
                         dipping,
                         [](const Step &s) { return s.fault.mean_state; }),
              1e-8);
  }
} // namespace



// A dipping fault is a level one in other axes: meshes do not match, waves and
// weight count, and there are events.
TEST(DippingFault, SlipsAsTheLevelOne)
{
  expect_the_same_run(numbers::PI / 6., Cells::quadrilaterals);
}

TEST(DippingFault, SlipsAsTheLevelOneOnTriangles)
{
  expect_the_same_run(-numbers::PI / 3., Cells::triangles);
}
