// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "antiplane_scenes.h"
#include "error_message.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A fault with the friction of the benchmark BP1 that creeps as a whole: in
   * SI units a(x) = 0.010 for x < 0, else up to 0.025. */
  const Settings creeping_as_a_whole = {
    "Faults/fault/a=0.010 + 0.015 * max(0, x)",
    "Faults/fault/b=0.015",
    "Faults/fault/Characteristic slip=0.008",
    "Faults/fault/Reference friction coefficient=0.6",
    "Faults/fault/Normal stress function=50e6",
    "Faults/fault/Initial state=",
    "Faults/fault/Initial slip rate along x=1e-9",
    "Bodies/lower/Material/Young modulus=80.0953008e9",
    "Bodies/lower/Material/Poisson ratio=0.25",
    "Bodies/lower/Material/Density=2670",
    "Bodies/upper/Material/Young modulus=80.0953008e9",
    "Bodies/upper/Material/Poisson ratio=0.25",
    "Bodies/upper/Material/Density=2670",
    "Boundary conditions/upper top/z value=1e-9",
    "Boundary conditions/upper top/Ramp length=0",
    "Output/Event start slip rate=1e-3",
    "Time/Initial step=1e-3",
    "Time/Smallest step=1e-6",
    "Time/Largest step=1",
    "Time/End time=1"};

  /** Its shear stress at 1e-9 m/s with a = 0.025, Pa. */
  const std::string prestress =
    "Faults/fault/Initial shear stress along x=26546122.365133364";
} // namespace



// The numbers are those of the description of BP1 (Erickson and Jiang, 2018).
TEST(InitialSliding, StateFollowsFromStressAndSlipRate)
{
  Simulation<2, 1> simulation(
    read_scene(antiplane_bodies, creeping_as_a_whole + Settings{prestress}),
    MPI_COMM_WORLD);
  simulation.set_up();
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  for (unsigned int k = 0; k < fault.points.size(); ++k)
    {
      EXPECT_EQ(fault.slip_rate[k][0], 1e-9);
      EXPECT_EQ(fault.slip[k][0], 0.);
      if (fault.points[k][0] <= 0.)
        {
          EXPECT_NEAR(fault.state[k], 8000., 8.);
        }
      if (fault.points[k][0] > 0.999)
        {
          EXPECT_NEAR(fault.state[k], 8e6, 8e3);
        }
      // Without radiation damping, that of sqrt(rho mu)/2.
      EXPECT_NEAR(fault.shear_traction[k][0],
                  26546122.365133364 - 4624440e-9,
                  1e-10 * 26546122.);
    }
  // Bodies move with the fault, each like its far side.
  const NodalVector &velocity = simulation.state().velocity;
  for (unsigned int i = 0; i < velocity.locally_owned_size(); ++i)
    EXPECT_LT(std::min(std::abs(velocity.local_element(i)),
                       std::abs(velocity.local_element(i) - 1e-9)),
              1e-19);
}



TEST(InitialSliding, GoesOnWithoutAJump)
{
  Simulation<2, 1> simulation(
    read_scene(antiplane_bodies, creeping_as_a_whole + Settings{prestress}),
    MPI_COMM_WORLD);
  simulation.set_up();
  const FaultSnapshot<2> before = snapshots(simulation).front();
  simulation.advance();
  const FaultSnapshot<2> after = snapshots(simulation).front();
  EXPECT_LT(simulation.state().time, 0.01);
  for (unsigned int k = 0; k < before.points.size(); ++k)
    {
      EXPECT_NEAR(after.shear_traction[k][0] / before.shear_traction[k][0],
                  1.,
                  1e-10);
      EXPECT_NEAR(after.slip_rate[k][0], 1e-9, 1e-12);
    }
}



// Slip rate and state give the stress, stress and state the slip rate.
TEST(InitialSliding, AnyTwoOfThree)
{
  const Settings   state = {"Faults/fault/Initial state=8000"};
  Simulation<2, 1> by_rate(read_scene(antiplane_bodies,
                                      creeping_as_a_whole + state),
                           MPI_COMM_WORLD);
  by_rate.set_up();
  const FaultSnapshot<2> fault = snapshots(by_rate).front();
  for (unsigned int k = 0; k < fault.points.size(); ++k)
    {
      const double a = 0.010 + 0.015 * std::max(0., fault.points[k][0]);
      const double f =
        a * std::asinh(
              1e-9 / 2e-6 *
              std::exp((0.6 + 0.015 * std::log(1e-6 * 8000. / 0.008)) / a));
      EXPECT_NEAR(fault.shear_traction[k][0], 50e6 * f, 1e-3);
    }

  Simulation<2, 1> by_stress(
    read_scene(antiplane_bodies,
               creeping_as_a_whole + state +
                 Settings{"Faults/fault/Initial slip rate along x=",
                          "Faults/fault/a=0.010",
                          prestress}),
    MPI_COMM_WORLD);
  by_stress.set_up();
  for (const Tensor<1, 1> &rate : by_stress.state().slip_rate)
    EXPECT_NEAR(rate[0], 1e-9, 1e-13);
}



TEST(InitialSliding, ContradictionsAreRefused)
{
  const auto expect = [](const Settings                 &settings,
                         const std::vector<std::string> &parts) {
    expect_one_sentence_with(message_of([&]() {
                               Simulation<2, 1> simulation(
                                 read_scene(antiplane_bodies,
                                            creeping_as_a_whole + settings),
                                 MPI_COMM_WORLD);
                               simulation.set_up();
                             }),
                             parts);
  };
  const std::string entry = "'Faults/fault/Initial shear stress along x'";
  expect({prestress, "Faults/fault/Initial state=1e5"},
         {entry, "slip rate and state need", "left out"});
  expect({"Faults/fault/Initial shear stress along x=-26e6"},
         {entry, "direction of the initial slip rate"});
  expect({"Faults/fault/Initial shear stress along x=60e6",
          "Faults/fault/Initial slip rate along x=",
          "Faults/fault/Initial state=1"},
         {entry, "above the strength"});
  expect({"Faults/fault/Friction=Coulomb",
          "Faults/fault/Initial shear stress along x=60e6",
          "Faults/fault/Initial slip rate along x="},
         {entry, "above the strength"});
}
