// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct Errors
  {
    double centre, mean_square;
  };



  /** The errors of the slip of parameters/crack.prm against the closed form of
   * a shear crack in plane strain (Starr 1928), over the largest slip,
   *
   *   2 (1 - nu) / G stress drop sqrt(a^2 - x^2),
   *
   * when the stress drop is @p drop; @p strength: the traction that is left.
   */
  Errors
  crack(const unsigned int              refinements,
        const double                    drop,
        const double                    strength,
        const std::vector<std::string> &more = {})
  {
    std::vector<std::string> settings = more;
    settings.insert(settings.end(),
                    {"Bodies/rock/Uniform refinements=" +
                       std::to_string(refinements),
                     "Output/Write volume=false",
                     "Output/Write faults=false"});
    Simulation<2> simulation(published_scene("crack", settings),
                             MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    const FaultSnapshot<2> fault   = snapshots(simulation).front();
    const double           largest = 2. * 0.75 / 30e9 * drop * 1e3;
    Errors                 errors  = {};
    double                 weights = 0, nearest = 1e3;
    for (unsigned int k = 0; k < fault.points.size(); ++k)
      {
        const double x     = fault.points[k][0];
        const double error = fault.slip[k][0] / largest -
                             std::sqrt(std::max(1. - x * x * 1e-6, 0.));
        if (std::abs(x) < nearest)
          {
            nearest       = std::abs(x);
            errors.centre = error;
          }
        errors.mean_square += fault.weights[k] * error * error;
        weights += fault.weights[k];
        if (fault.weights[k] > 0.)
          {
            EXPECT_NEAR(fault.shear_traction[k][0], strength, 1e-5 * 30e6);
            EXPECT_NEAR(fault.normal_stress[k], 50e6, 1.);
          }
      }
    errors.mean_square = std::sqrt(errors.mean_square / weights);
    std::cout << refinements << " refinements: " << 100. * errors.centre
              << " % at the centre, " << 100. * errors.mean_square
              << " % in the mean square\n";
    return errors;
  }
} // namespace



// Both sides of the fault are on one body, and its tips inside of it: the error
// is of first order, that of the singular stress there.
TEST(Crack, SlipsAsInTheClosedForm)
{
  std::vector<Errors> errors;
  for (const unsigned int refinements : {0, 1, 2})
    errors.push_back(crack(refinements, 3e6, 30e6));
  EXPECT_NEAR(std::log2(errors[0].mean_square / errors[1].mean_square),
              1.,
              0.3);
  EXPECT_NEAR(std::log2(errors[1].mean_square / errors[2].mean_square),
              1.,
              0.3);
  // Cells of a / 160.
  EXPECT_LT(std::abs(errors[2].centre), 0.005);
  EXPECT_LT(errors[2].mean_square, 0.01);
}



// All of the background shear is released at once.
TEST(Crack, WithoutFriction)
{
  const Errors errors = crack(1,
                              29e6,
                              0.,
                              {"Faults/fault/Friction=frictionless",
                               "Boundary conditions/rock sides/x value=0",
                               "Time/Step size control=constant",
                               "Output/Event start slip rate=1"});
  EXPECT_LT(std::abs(errors.centre), 0.015);
  EXPECT_LT(errors.mean_square, 0.025);
}
