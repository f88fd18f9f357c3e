// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The spring slider on a foundation, to its first event. */
  const std::vector<std::string> one_event = {
    "Bodies/upper/Refinement passes=2",
    "Bodies/lower/Refinement passes=2",
    "Faults/fault/Normal stress=lithostatic",
    "Time/End time=12"};
} // namespace



TEST(Foundation, IsTheLimitOfStiffBodies)
{
  const RunHistory founded(
    published_scene("spring_slider",
                    one_event + Settings{"Bodies/lower/Rigid=true"}));
  ASSERT_GE(founded.events.size(), 1u);

  // The difference falls as the compliance of the lower body.
  std::vector<double> differences;
  for (const std::string modulus : {"4.12e9", "4.12e10"})
    {
      const RunHistory stiff(published_scene(
        "spring_slider",
        one_event +
          Settings{"Bodies/lower/Material/Young modulus=" + modulus}));
      ASSERT_GE(stiff.events.size(), 1u);
      differences.push_back(stiff.events[0].start - founded.events[0].start);
      std::cout << "E = " << modulus << " Pa: the first event at "
                << stiff.events[0].start << " s, on the foundation at "
                << founded.events[0].start << " s\n";
    }
  EXPECT_GT(differences[0], 0.);
  EXPECT_LT(differences[0], 0.02 * founded.events[0].start);
  EXPECT_NEAR(differences[1] / differences[0], 0.1, 0.05);
}



TEST(Foundation, ThatMovesDoesTheWorkOfADrivenSide)
{
  // The foundation is dragged below a body that is held: in the end the fault
  // slips as fast as that, and what drives it does the work of friction.
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Bodies/lower/Rigid=true",
                "Boundary conditions/lower bottom/x condition=velocity",
                "Boundary conditions/lower bottom/x value=1e-3",
                "Boundary conditions/lower bottom/Ramp length=1",
                "Boundary conditions/upper top/x condition=fixed",
                "Boundary conditions/upper top/x value=0",
                "Time/End time=8"});
  Simulation<2> simulation(scene, MPI_COMM_WORLD);
  simulation.set_up();
  while (!simulation.is_finished())
    simulation.advance();
  for (const auto &V : simulation.state().slip_rate)
    EXPECT_NEAR(std::abs(V[0]), 1e-3, 1e-6);

  const EnergyBalance<2> &energy = *simulation.energy_balance();
  const EnergyTerms      &work   = energy.work();
  EXPECT_GT(work.driven_sides, 0.);
  EXPECT_LT(std::abs(energy.defect(simulation.state())),
            1e-4 * work.driven_sides);
  EXPECT_NEAR(work.friction,
              work.driven_sides - work.viscosity -
                energy.kinetic_energy(simulation.state()) -
                energy.elastic_energy(simulation.state()),
              1e-4 * work.driven_sides);
}



TEST(Foundation, WithDipABodySlidesDownAsOnAnInclinedPlane)
{
  // Friction that hardly depends on slip rate and state: mu = 0.3. Down a plane
  // of 30 degrees the acceleration is g (sin 30 - mu cos 30), and none of 10
  // degrees.
  const auto velocity_after = [](const double dip) {
    const SceneParameters<2> scene =
      read_scene(creeping_bodies,
                 {"Bodies/lower/Rigid=true",
                  "Faults/fault/a=1e-4",
                  "Faults/fault/b=0",
                  "Faults/fault/Reference friction coefficient=0.3",
                  "Faults/fault/Reference slip rate=0.1",
                  "Faults/fault/Initial state=1",
                  "Faults/fault/Normal stress=lithostatic",
                  "Boundary conditions/upper top/x condition=free",
                  "Boundary conditions/upper top/x value=0",
                  "Bodies/upper/Material/Young modulus=1e9",
                  "Gravity/Acceleration=9.81",
                  "Gravity/Dip=" + std::to_string(dip),
                  "Output/Event start slip rate=1",
                  "Contact/Follow slip=false",
                  "Time/End time=0.2"});
    Simulation<2> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    double                 sum = 0, weights = 0;
    const FaultSnapshot<2> fault = snapshots(simulation).front();
    for (unsigned int k = 0; k < fault.weights.size(); ++k)
      {
        sum += fault.weights[k] * simulation.state().slip_rate[k][0];
        weights += fault.weights[k];
      }
    return sum / weights;
  };
  const double angle = numbers::PI / 6.;
  // Down the dip, towards positive x.
  EXPECT_NEAR(velocity_after(30.),
              0.2 * 9.81 * (std::sin(angle) - 0.3 * std::cos(angle)),
              0.01);
  EXPECT_NEAR(velocity_after(10.), 0., 1e-6);
}
