// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/load_breaks.h>
#include <stickslip/scene/scene_reader.h>

#include <cmath>

#include "creeping_scene.h"
#include "error_message.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  std::vector<double>
  breaks(const std::function<double(const double)> &function)
  {
    return breaks_of(function, 60., 1e-4);
  }



  void
  expect_times(const std::vector<double> &found,
               const std::vector<double> &expected)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (unsigned int i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-8);
  }
} // namespace



TEST(LoadBreaks, AreJumpsAndKinks)
{
  const auto pulse = [](const double t) {
    return std::abs(t - 3.3) < 0.01 ? 1. : 0.;
  };
  expect_times(breaks(pulse), {3.29, 3.31});
  // Jumps are behind their times.
  for (const double time : breaks(pulse))
    EXPECT_EQ(pulse(time), time < 3.3 ? 0. : 1.);
  expect_times(breaks([](const double t) { return std::abs(t - 30.); }), {30.});
  expect_times(breaks([](const double t) {
                 return std::max(0., 1. - std::abs(t - 7.) / 0.05) +
                        std::sin(t);
               }),
               {6.95, 7., 7.05});
  expect_times(breaks([](const double t) { return t > 59. ? 1e9 : 1.; }),
               {59.});
  // A ramp whose kinks are hardly larger than the tolerance.
  expect_times(breaks([](const double t) {
                 return std::min(std::max(t - 10., 0.), 1.);
               }),
               {10., 11.});
}



TEST(LoadBreaks, AreNoneWhereLoadsAreSmooth)
{
  expect_times(breaks([](const double t) { return 1e-9 * t; }), {});
  expect_times(breaks([](const double) { return 0.; }), {});
  for (const double period : {0.03, 0.1, 1., 60.})
    expect_times(breaks([&](const double t) {
                   return std::sin(2. * numbers::PI * t / period);
                 }),
                 {});
  expect_times(breaks([](const double t) { return std::exp(-1e4 * t); }), {});
  // One wave of a squared cosine, without a kink.
  expect_times(breaks([](const double t) {
                 return std::abs(t - 20.) < 0.1 ?
                          std::pow(std::cos(numbers::PI * (t - 20.) / 0.2), 2) :
                          0.;
               }),
               {});
}



TEST(LoadBreaks, AreThoseOfAllSidesAndOfTheScene)
{
  const auto ends = [](const std::vector<std::string> &settings) {
    return read_scene(creeping_bodies, settings).time.step_ends;
  };
  const std::string end = "Time/End time=10";
  expect_times(ends({end}), {});
  expect_times(ends({end, "Time/Load times=3 s, 1e-4 h, 0.5"}),
               {0.36, 0.5, 3.});
  expect_times(
    ends({end,
          "Time/Load times=3",
          "Boundary conditions/upper top/x value=if(t > 3, 2e-3, 1e-3)",
          "Boundary conditions/upper top/y condition=traction",
          "Boundary conditions/upper top/y value=-1e3*max(0, t-4-0.25*x)"}),
    {3., 3.75, 4., 4.25});
  expect_one_sentence_with(message_of([&]() { ends({"Time/Load times=-1"}); }),
                           {"'Time/Load times' = '-1'",
                            "a list of numbers >= 0"});
}
