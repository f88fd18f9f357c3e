// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/mesh_adaptation.h>

#include <cmath>
#include <sstream>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Times = std::vector<double>;



  /** Starts of the first two events, s. */
  Times
  first_events(const SceneParameters<2> &scene)
  {
    Times times;
    for (const SlipEvent &event : RunHistory(scene).events)
      times.push_back(event.start);
    times.resize(2, std::nan(""));
    return times;
  }



  /** The spring slider with that many uniform refinements of the published
   * coarse cells, and a pass at the fault. */
  Times
  on_cells_of_one_size(const unsigned int n_refinements)
  {
    std::vector<std::string> entries = {"Time/End time=24.5"};
    for (const std::string body : {"lower", "upper"})
      {
        entries.push_back("Bodies/" + body + "/Uniform refinements=" +
                          std::to_string(n_refinements));
        entries.push_back("Bodies/" + body + "/Refinement passes=1");
      }
    return first_events(published_scene("spring_slider", entries));
  }
} // namespace



TEST(EventTimes, ConvergeWithTheMesh)
{
  // Corners between held and free sides have the exponent 0.71 at nu = 0.3, so
  // that the order is 1.42.
  const double ratio  = std::pow(2., 1.42);
  const Times  coarse = on_cells_of_one_size(1), fine = on_cells_of_one_size(2);
  Times        limit(2);
  for (unsigned int i = 0; i < 2; ++i)
    limit[i] = fine[i] + (fine[i] - coarse[i]) / (ratio - 1.);

  // Extrapolated from twice as many cells along each axis.
  EXPECT_NEAR(limit[0], 22.4206, 0.003);
  // The mean interval of the events.
  const double interval = 1.8;

  // Half as many nodes again as the finer one, and half of its error.
  SceneParameters<2> accurate =
    published_scene("spring_slider_accurate", {"Time/End time=24.5"});
  std::ostringstream report;
  adapt_meshes(accurate, 1e10, report);
  const Times adapted = first_events(accurate);
  for (unsigned int i = 0; i < 2; ++i)
    {
      SCOPED_TRACE("event " + std::to_string(i));
      EXPECT_LT(std::abs(adapted[i] - limit[i]), 0.005 * interval);
      EXPECT_GT(std::abs(fine[i] - limit[i]), 0.005 * interval);
    }
}
