// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "column_scenes.h"
#include "slip_rate_series.h"
#include "step_errors.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double loading_rate = slider_loading_rate;



  SlipRateSeries
  simulate(const WaveColumn               &column,
           const unsigned int              n_cells,
           const double                    end_time,
           const std::vector<std::string> &overrides = {})
  {
    SteppingScene  scene(scene_of(column, n_cells), overrides);
    SlipRateSeries series;
    series.time      = {0.};
    series.slip_rate = {0.};
    while (scene.state.time < end_time)
      {
        scene.advance();
        series.time.push_back(scene.state.time);
        series.slip_rate.push_back(std::abs(scene.state.slip_rate[0][0]));
      }
    return series;
  }



  /** A traction on top in place of the pull, whose waves nearly reach the
   * strength. */
  const Settings waves_of_traction = {
    "Boundary conditions/upper top/x condition=traction",
    "Boundary conditions/upper top/x value=16e3",
    "Boundary conditions/upper top/Ramp length=0.05",
    "Output/Event start slip rate=1e-3",
    "Time/End time=3"};



  /** Of the velocities on a vertical line, relative to their size; they are
   * late by some time, s. */
  double
  error_of_profile(const SteppingScene &scene,
                   const WaveColumn    &column,
                   const double         late)
  {
    const MeshLevel<2> &level = scene.meshes.finest();
    double              error = 0, norm = 0;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const std::vector<Point<2>> points = level.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          if (points[i][0] == 0. && points[i][1] != 0.)
            {
              const double exact =
                column.velocity(points[i][1], scene.state.time - late);
              const double ours =
                scene.state.velocity.local_element(level.node(b, i) * 2);
              error += (ours - exact) * (ours - exact);
              norm += exact * exact;
            }
      }
    return std::sqrt(error / norm);
  }
} // namespace



TEST(Column, LoadingEventAndRadiation)
{
  WaveColumn column = spring_slider();
  column.run(24., 0.);
  const SlipRateSeries coarser{column.time, column.slip_rate};
  column.steps_a_passage = 2000;
  column.run(24., 0.);
  const SlipRateSeries reference{column.time, column.slip_rate};
  const double         start = reference.events(loading_rate)[0],
               interval      = reference.events(loading_rate)[1] - start;
  ASSERT_NEAR(coarser.events(loading_rate)[0], start, 1e-8);
  ASSERT_NEAR(coarser.at(start + 0.08) / reference.at(start + 0.08), 1., 1e-5);

  SteppingScene  scene(scene_of(column, 128), {"Time/Tolerance=3e-8"});
  SlipRateSeries ours{{0.}, {0.}};
  double         largest_of_profiles = 0;
  while (scene.state.time < start + 0.1)
    {
      scene.advance();
      ours.time.push_back(scene.state.time);
      ours.slip_rate.push_back(std::abs(scene.state.slip_rate[0][0]));
      // The waves that the event sends up and down, on the whole height.
      if (scene.state.time > start + 0.02 && scene.state.time < start + 0.06)
        largest_of_profiles =
          std::max(largest_of_profiles,
                   error_of_profile(scene,
                                    column,
                                    ours.events(loading_rate).front() - start));
    }
  EXPECT_LT(largest_of_profiles, 0.01);

  // Slip rates of 1e-25 m/s and more, with nothing aligned.
  for (const double t : {5., 10., 15., 19., 20.})
    EXPECT_NEAR(ours.at(t) / reference.at(t), 1., 1e-3) << t;
  // Above half of the loading rate, from the start of the event.
  const double late = ours.events(loading_rate)[0] - start;
  EXPECT_LT(std::abs(late), 1e-3 * interval);
  double peak = 0, largest = 0;
  for (double t = start - 0.5; t < start + 0.09; t += 1e-3)
    {
      peak = std::max(peak, reference.at(t));
      if (reference.at(t) > 0.5 * loading_rate)
        {
          const double error = ours.at(t + late) / reference.at(t) - 1.;
          largest            = std::max(largest, std::abs(error));
        }
    }
  EXPECT_LT(largest, 0.01);
  RecordProperty("largest relative error of the slip rate",
                 std::to_string(largest));
  EXPECT_GT(peak, 100. * loading_rate);
  RecordProperty("largest relative error of the velocities of a profile",
                 std::to_string(largest_of_profiles));
  RecordProperty("steps", static_cast<int>(ours.time.size()) - 1);
  RecordProperty("shift of the event, s", std::to_string(late));
}



TEST(Column, EventTimeConverges)
{
  WaveColumn column = spring_slider();
  column.run(20.5, 0.);
  const double start =
    SlipRateSeries{column.time, column.slip_rate}.events(loading_rate).front();

  // The steps follow the third root of the tolerance, and their error is of
  // second order: a hundredth of the tolerance for a twentieth of the error.
  std::vector<double> errors;
  for (const std::string tolerance : {"1e-4", "1e-6"})
    errors.push_back(
      std::abs(simulate(column, 64, 20.5, {"Time/Tolerance=" + tolerance})
                 .events(loading_rate)
                 .front() -
               start));
  EXPECT_LT(errors[0], 3e-3);
  EXPECT_LT(errors[1], errors[0] / 15.);
}



TEST(Column, SecondOrderInMeshAndStep)
{
  constexpr double end_time = 0.8;
  WaveColumn       column   = strengthening_column();
  column.run(end_time + 0.1, 0.);
  const SlipRateSeries reference{column.time, column.slip_rate};

  const auto error = [&](const unsigned int i, const std::string &update) {
    SteppingScene scene(scene_of(column, 8u << i),
                        {"Faults/fault/Regularisation=arcsinh",
                         "TNNMG/Tolerance=1e-12",
                         "Time/Rate-state tolerance=1e-12",
                         "Time/Step size control=constant",
                         "Time/State update=" + update,
                         "Time/Largest step=" +
                           std::to_string(0.005 / (1u << i))});
    double        largest = 0;
    while (scene.state.time < end_time * (1. - 1e-12))
      {
        scene.advance();
        if (scene.state.time > 0.3)
          largest = std::max(largest,
                             std::abs(std::abs(scene.state.slip_rate[0][0]) -
                                      reference.at(scene.state.time)));
      }
    return largest;
  };
  for (const std::string update : {"exponential", "implicit Euler"})
    {
      std::vector<double> errors;
      for (unsigned int i = 0; i < 4; ++i)
        errors.push_back(error(i, update));
      for (unsigned int i = 0; i < 3; ++i)
        EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]),
                    update == "exponential" ? 2. : 1.,
                    0.06)
          << update << ' ' << errors[i];
      EXPECT_LT(errors.back(), 1e-6);
    }
}



// As the pull sets in, while the bodies ring with their fault stuck, and in the
// waves of a traction that is switched on.
TEST(Column, EstimatesAreThatOfTheError)
{
  const WaveColumn column = spring_slider();
  // Estimates of some steps over their errors, and the largest of these.
  const auto compare = [&](const double start, const Settings &overrides) {
    SteppingScene scene(scene_of(column, 16),
                        Settings{"TNNMG/Tolerance=1e-12",
                                 "Time/Rate-state tolerance=1e-12"} +
                          overrides);
    scene.advance_until(start);
    std::vector<double> ratios;
    double              largest = 0.;
    for (unsigned int i = 0; i < 40; ++i)
      {
        const SystemState<2> before = scene.state;
        const double         tau    = scene.advance().front().step_size;
        const double error = error_of_last_step(scene, before, tau).bodies;
        ratios.push_back(scene.memory.last_error.bodies / error);
        largest = std::max(largest, error);
      }
    std::sort(ratios.begin(), ratios.end());
    RecordProperty("median ratio from " + std::to_string(start) + " s",
                   std::to_string(ratios[20]));
    return std::make_pair(ratios, largest);
  };
  const std::string tolerance = "Time/Body tolerance=";
  for (const auto &[start, settings] :
       {std::make_pair(2., Settings{tolerance + "1e-6"}),
        std::make_pair(20.8, Settings()),
        std::make_pair(0.5, waves_of_traction)})
    {
      const std::vector<double> ratios = compare(start, settings).first;
      // A step may pass the moment at which its error changes sign.
      EXPECT_GT(ratios[4], 1. / 3.) << start;
      EXPECT_LT(ratios[36], 3.) << start;
    }
  // Steps as long as waves tell less of their error, and are taken only where
  // it is far below what is allowed.
  EXPECT_LT(compare(2., {}).second, 0.1 * TimeParameters().body_tolerance);
}



// Waves that do not quite reach the strength let the fault slip all the same,
// by the exponential of the traction: it has to be right to a percent.
TEST(Column, WavesThroughAStuckFaultAreFollowed)
{
  const WaveColumn column = spring_slider();
  const auto       slip   = [&](const Settings &overrides) {
    SteppingScene scene(scene_of(column, 8), waves_of_traction + overrides);
    scene.advance_until(2.);
    return std::abs(scene.state.slip[0][0]);
  };
  const double exact = slip(
                 {"Time/Step size control=constant", "Time/Largest step=2e-4"}),
               ours = slip({}), unaware = slip({"Time/Body tolerance=1e9"});
  EXPECT_NEAR(ours / exact, 1., 0.03);
  EXPECT_GT(std::abs(unaware / exact - 1.), 0.1);
  RecordProperty("slip, m", std::to_string(exact * 1e6) + "e-6");
}
