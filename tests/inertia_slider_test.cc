// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "endless_layers.h"
#include "radiating_slider.h"
#include "simulation_scenes.h"
#include "slip_rate_series.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double loading_rate = 2e-4, ramp = 1.;



  /** Two layers of the spring slider's material, which shear as a whole. */
  EndlessLayers
  layers(const double viscosity)
  {
    EndlessLayers result;
    for (Material &material : result.material)
      material.shear_viscosity = material.bulk_viscosity = viscosity;
    result.thickness.fill(1.);
    result.coarse_cells.fill({{1, 2}});
    result.length                       = 0.5;
    result.friction.a                   = 0.010;
    result.friction.b                   = 0.015;
    result.friction.reference_friction  = 0.6;
    result.friction.reference_slip_rate = 1e-6;
    result.friction.characteristic_slip = 2e-5;
    result.normal_stress                = 5e3 * 9.81;
    result.velocity                     = loading_rate;
    result.ramp_length                  = ramp;
    return result;
  }



  /** Slider without space that stands for the layers. */
  RadiatingSlider
  slider(const EndlessLayers &layers, const bool radiates)
  {
    const double    G = 4.12e7 / 2.6, density = 5e3;
    RadiatingSlider result;
    result.stiffness         = G / 2.;
    result.dashpot           = layers.material[0].shear_viscosity / 2.;
    result.radiation_damping = radiates ? std::sqrt(G * density) / 2. : 0.;
    result.a                 = layers.friction.a;
    result.b                 = layers.friction.b;
    result.mu0               = layers.friction.reference_friction;
    result.V0                = layers.friction.reference_slip_rate;
    result.L                 = layers.friction.characteristic_slip;
    result.normal_stress     = layers.normal_stress;
    result.loading           = [](const double t) -> std::array<double, 2> {
      if (t >= ramp)
        return {{loading_rate * (t - ramp / 2.), loading_rate}};
      const double phase = numbers::PI * t / ramp;
      return {{loading_rate / 2. * (t - ramp / numbers::PI * std::sin(phase)),
               loading_rate / 2. * (1. - std::cos(phase))}};
    };
    return result;
  }
} // namespace



TEST(Slider, EventsOfTheQuasiDynamicLayersAreThoseOfAnODE)
{
  const EndlessLayers scene_layers = layers(1e3);
  RadiatingSlider     ode          = slider(scene_layers, true);
  ode.run(25., 0.);
  const SlipRateSeries reference{ode.time, ode.slip_rate};
  ode.tolerance = 1e-11;
  ode.run(25., 0.);
  const SlipRateSeries coarser{ode.time, ode.slip_rate};
  ASSERT_GE(reference.events(loading_rate).size(), 3u);
  for (unsigned int k = 0; k < 3; ++k)
    ASSERT_NEAR(coarser.events(loading_rate)[k],
                reference.events(loading_rate)[k],
                1e-5);

  SteppingScene  scene(scene_layers.text(),
                      {"Time/Inertia=quasi-dynamic", "Time/Tolerance=3e-8"});
  SlipRateSeries ours{{0.}, {0.}};
  while (scene.state.time < 25.)
    {
      scene.advance();
      ours.time.push_back(scene.state.time);
      ours.slip_rate.push_back(std::abs(scene.state.slip_rate[0][0]));
    }
  // Slip rates of 1e-25 m/s and more, with nothing aligned.
  for (const double t : {5., 10., 15., 19.})
    EXPECT_NEAR(ours.at(t) / reference.at(t), 1., 1e-3) << t;
  EXPECT_GT(reference.peak(), 50. * loading_rate);
  EXPECT_NEAR(ours.peak() / reference.peak(), 1., 1e-3);
  const double interval =
    reference.events(loading_rate)[1] - reference.events(loading_rate)[0];
  for (unsigned int k = 0; k < 3; ++k)
    {
      const double late =
        ours.events(loading_rate)[k] - reference.events(loading_rate)[k];
      std::cout << "event " << k << " at " << reference.events(loading_rate)[k]
                << " s, ours later by " << late << " s\n";
      EXPECT_LT(std::abs(late), 1e-4 * interval);
    }
}



TEST(Slider, SecondOrderWithoutInertia)
{
  // Slides smoothly and ever faster as the pull sets in.
  constexpr double end_time           = 0.8;
  EndlessLayers    smooth             = layers(0.);
  smooth.friction.a                   = 0.02;
  smooth.friction.b                   = 0.01;
  smooth.friction.reference_friction  = 0.;
  smooth.friction.reference_slip_rate = 1e-3;
  smooth.friction.characteristic_slip = 1e-3;
  smooth.normal_stress                = 2e4;
  smooth.velocity                     = 1e-2;

  for (const bool radiates : {true, false})
    {
      RadiatingSlider ode = slider(smooth, radiates);
      ode.is_arcsinh      = true;
      const auto slow     = ode.loading;
      ode.loading         = [slow](const double t) {
        std::array<double, 2> w = slow(t);
        for (double &x : w)
          x *= 1e-2 / loading_rate;
        return w;
      };
      ode.run(end_time, 0.);
      std::vector<double> errors;
      for (unsigned int i = 0; i < 4; ++i)
        {
          SteppingScene scene(smooth.text(),
                              {"Faults/fault/Regularisation=arcsinh",
                               std::string("Time/Inertia=") +
                                 (radiates ? "quasi-dynamic" : "quasi-static"),
                               "TNNMG/Tolerance=1e-12",
                               "Time/Rate-state tolerance=1e-12",
                               "Time/Step size control=constant",
                               "Time/End time=0.8",
                               "Time/Largest step=" +
                                 std::to_string(0.01 / (1u << i))});
          scene.advance_until(end_time * (1. - 1e-12));
          ASSERT_NEAR(scene.state.time, end_time, 1e-12);
          errors.push_back(std::abs(std::abs(scene.state.slip_rate[0][0]) -
                                    ode.slip_rate.back()));
        }
      std::cout << (radiates ? "quasi-dynamic" : "quasi-static")
                << ", errors of V =" << ode.slip_rate.back() << " m/s:";
      for (const double error : errors)
        std::cout << ' ' << error;
      std::cout << '\n';
      for (unsigned int i = 0; i < 3; ++i)
        EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2., 0.1);
      EXPECT_LT(errors.back(), 1e-4 * ode.slip_rate.back());
    }
}



TEST(Slider, QuasiStaticRunEndsWhereTheSlipRateGrowsWithoutBound)
{
  const EndlessLayers scene_layers = layers(0.);
  RadiatingSlider     ode          = slider(scene_layers, false);
  ode.run(30., 0., 1e2);
  const double time_of_blow_up = ode.time.back();
  ASSERT_LT(time_of_blow_up, 25.);

  const TemporaryFolder    folder;
  const SceneParameters<2> scene =
    read_scene(scene_layers.text(),
               {"Time/Inertia=quasi-static",
                "Time/End time=30",
                "Time/Tolerance=1e-7",
                "Output/Output directory=" + folder.file("run")});
  Simulation<2> simulation(scene, MPI_COMM_WORLD);
  std::string   message;
  try
    {
      simulation.run();
    }
  catch (const StepSizeTooSmall &error)
    {
      message = error.what();
    }
  EXPECT_NE(message.find("quasi-static slip rates can grow without bound"),
            std::string::npos)
    << message;
  EXPECT_NEAR(simulation.state().time, time_of_blow_up, 1e-3);
  std::ifstream     file(folder.file("run/summary.txt"));
  std::stringstream summary;
  summary << file.rdbuf();
  EXPECT_NE(summary.str().find("grow without bound"), std::string::npos);
  EXPECT_EQ(summary.str().find("kinetic"), std::string::npos);
}
