// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "kinds_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double g = 9.81, mu = 0.3;

  const std::vector<std::string> coulomb = {
    "Faults/fault/Friction=Coulomb",
    "Faults/fault/Reference friction coefficient=0.3"};
} // namespace



TEST(Coulomb, HoldsOnAGentleSlopeAndSlidesDownASteepOne)
{
  const auto velocity_after = [](const double dip) {
    Simulation<2> simulation(
      read_scene(creeping_bodies,
                 block_on_foundation + coulomb +
                   std::vector<std::string>{"Gravity/Dip=" +
                                              std::to_string(dip),
                                            "Time/End time=0.2"}),
      MPI_COMM_WORLD);
    run(simulation);
    const FaultSnapshot<2> fault = snapshots(simulation).front();
    return mean(fault, fault.slip_rate);
  };
  const double angle = numbers::PI / 6.;
  EXPECT_NEAR(velocity_after(30.),
              0.2 * g * (std::sin(angle) - mu * std::cos(angle)),
              0.005);
  // Below tan(dip) = 0.3: no creep at all, unlike with rate and state.
  EXPECT_EQ(velocity_after(10.), 0.);
}



TEST(Coulomb, LetsABlockGoAndCatchesItAgain)
{
  // A block of 0.5 m that is pushed on its top with p(t) = 1.5e4 Pa for 0.2 s:
  // it moves with (p - mu sigma)/m, then friction stops it at mu g.
  const double m = 5e3 * 0.5, push = 1.5e4, duration = 0.2;
  const double speed = (push / m - mu * g) * duration;
  const double stop  = duration + speed / (mu * g);
  // At a twentieth of its speed.
  const double  late = stop - 0.05 * speed / (mu * g);
  Simulation<2> simulation(
    read_scene(
      creeping_bodies,
      block_on_foundation + coulomb +
        std::vector<std::string>{
          "Boundary conditions/upper top/x condition=traction",
          "Boundary conditions/upper top/x value=if(t < 0.2, 1.5e4, 0)",
          "Time/Largest step=0.004",
          "Time/End time=0.6"}),
    MPI_COMM_WORLD);
  simulation.set_up();
  double fastest = 0., last_moving = 0.;
  while (!simulation.is_finished())
    {
      simulation.advance();
      const FaultSnapshot<2> fault = snapshots(simulation).front();
      const double           V     = mean(fault, fault.slip_rate);
      fastest                      = std::max(fastest, V);
      if (V > 0.05 * speed)
        last_moving = simulation.state().time;
    }
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  std::cout << "Fastest " << fastest << " m/s (" << speed
            << "), nearly at rest from " << last_moving << " s (" << late
            << "), slip " << mean(fault, fault.slip) << " m ("
            << 0.5 * speed * stop << ")\n";
  EXPECT_NEAR(fastest, speed, 0.03 * speed);
  EXPECT_NEAR(last_moving, late, 0.02 * late);
  EXPECT_NEAR(mean(fault, fault.slip), 0.5 * speed * stop, 0.02 * speed * stop);
  // At rest no node moves, and no node is pulled by more than its threshold.
  for (unsigned int k = 0; k < fault.slip_rate.size(); ++k)
    {
      EXPECT_EQ(fault.slip_rate[k][0], 0.) << k;
      EXPECT_LE(std::abs(fault.shear_traction[k][0]),
                mu * fault.normal_stress[k] * (1. + 1e-6))
        << k;
    }
  // All that the push gave is gone.
  const EnergyBalance<2> &energy = *simulation.energy_balance();
  const EnergyTerms      &work   = energy.work();
  EXPECT_NEAR(work.friction, work.loads, 0.01 * work.loads);
  EXPECT_LT(std::abs(energy.defect(simulation.state())), 0.005 * work.loads);
}



TEST(Coulomb, LetsAPulledRodSlipAsFarAsItsForceReaches)
{
  // A thin rod on a foundation, pulled at one end without inertia. It slips
  // where the force left over is above zero: over l = F/(mu sigma), with
  // u(0) = F^2/(2 E' h mu sigma) at the end. Without the pull, half of the slip
  // stays, since it slips back over half of l only.
  const double h = 0.02, E = 1e8, nu = 0.3, sigma = 1e4;
  const double length = 0.5, F = length * mu * sigma;
  const double stiffness = E / (1. - nu * nu) * h;
  const auto   rod       = [&](const std::string &pull) {
    return coulomb +
           std::vector<std::string>{
             "Bodies/lower/Rigid=true",
             "Faults/fault/Initial state=1",
             "Output/Event start slip rate=1",
             "Contact/Follow slip=false",
             "Bodies/lower/Lower lateral corner=0",
             "Bodies/upper/Lower lateral corner=0",
             "Bodies/upper/Upper lateral corner=1",
             "Bodies/upper/Thickness=0.02",
             "Bodies/upper/Coarse cells=50, 1",
             "Bodies/upper/Uniform refinements=1",
             "Bodies/upper/Refinement passes=0",
             "Bodies/upper/Material/Young modulus=1e8",
             "Bodies/upper/Material/Poisson ratio=0.3",
             "Bodies/upper/Material/Shear viscosity=0",
             "Bodies/upper/Material/Bulk viscosity=0",
             "Faults/fault/Normal stress=function",
             "Faults/fault/Normal stress function=1e4",
             "Boundary conditions/Sides=lower bottom, upper left, upper right",
             "Boundary conditions/upper left/x condition=traction",
             "Boundary conditions/upper left/x value=" + pull,
             "Boundary conditions/upper right/x condition=fixed",
             "Gravity/Acceleration=0",
             "Time/Inertia=quasi-static",
             "Time/Step size control=constant",
             "Time/Largest step=0.05",
             "Time/End time=2"};
  };
  // Pulled by 7.5e4 Pa on 0.02 m, up to t = 1 s, and released.
  Simulation<2> simulation(
    read_scene(
      creeping_bodies.substr(0, creeping_bodies.find("subsection Boundary")),
      rod("-7.5e4 * if(t < 1, t, 2 - t)")),
    MPI_COMM_WORLD);
  ASSERT_NEAR(F, 7.5e4 * h, 1e-9);
  simulation.set_up();
  const double u0 = F * F / (2. * stiffness * mu * sigma);
  while (simulation.state().time < 1. - 1e-9)
    simulation.advance();
  const FaultSnapshot<2> pulled = snapshots(simulation).front();
  finish(simulation);
  const FaultSnapshot<2> released = snapshots(simulation).front();

  const auto end_of_slip = [](const FaultSnapshot<2> &fault) {
    double end = 0.;
    for (unsigned int k = 0; k < fault.slip.size(); ++k)
      if (std::abs(fault.slip[k][0]) > 0.)
        end = std::max(end, fault.points[k][0]);
    return end;
  };
  const auto slip_at_start = [](const FaultSnapshot<2> &fault) {
    for (unsigned int k = 0; k < fault.slip.size(); ++k)
      if (fault.points[k][0] == 0.)
        return fault.slip[k][0];
    return 0.;
  };
  std::cout << "Slips up to " << end_of_slip(pulled) << " m (" << length
            << "), by " << slip_at_start(pulled) << " m at the end (" << -u0
            << "), " << slip_at_start(released) << " m released\n";
  EXPECT_NEAR(end_of_slip(pulled), length, 0.03);
  EXPECT_NEAR(slip_at_start(pulled), -u0, 0.06 * u0);
  EXPECT_NEAR(slip_at_start(released) / slip_at_start(pulled), 0.5, 0.03);
  for (unsigned int k = 0; k < pulled.slip.size(); ++k)
    {
      const double x = pulled.points[k][0];
      EXPECT_NEAR(pulled.slip[k][0],
                  x < length ? -u0 * std::pow(1. - x / length, 2) : 0.,
                  0.06 * u0)
        << x;
    }
}



TEST(Frictionless, ResistsNothing)
{
  // A block that is pushed moves with F/m from the start.
  Simulation<2> simulation(
    read_scene(creeping_bodies,
               block_on_foundation +
                 std::vector<std::string>{
                   "Faults/fault/Friction=frictionless",
                   "Boundary conditions/upper top/x condition=traction",
                   "Boundary conditions/upper top/x value=1e3",
                   "Time/Largest step=0.002",
                   "Time/End time=0.2"}),
    MPI_COMM_WORLD);
  run(simulation);
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  EXPECT_NEAR(mean(fault, fault.slip_rate), 1e3 / 2.5e3 * 0.2, 0.005 * 0.08);
  EXPECT_NEAR(mean(fault, fault.slip), 0.5 * 1e3 / 2.5e3 * 0.04, 0.01 * 0.008);
  for (const Tensor<1, 1> &traction : fault.shear_traction)
    EXPECT_EQ(traction[0], 0.);
}



TEST(QuasiStatic, NeedsMoreThanAThresholdToHoldABody)
{
  for (const std::string kind : {"Coulomb", "frictionless"})
    expect_one_sentence_with(
      message_of([&]() {
        Simulation<2> simulation(
          read_scene(creeping_bodies,
                     block_on_foundation +
                       std::vector<std::string>{"Faults/fault/Friction=" + kind,
                                                "Time/Inertia=quasi-static"}),
          MPI_COMM_WORLD);
        simulation.set_up();
      }),
      {"nothing holds the body 'upper' along x"});
}
