// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/faults/fault_norm.h>
#include <stickslip/time/explicit_step.h>

#include <cmath>

#include "antiplane_scenes.h"
#include "error_message.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string explicit_steps = "Time/Step size control=Runge-Kutta";

  /** Two bodies in space that are dragged along x and y. */
  const std::string bodies_in_space = R"(
set Dimension = 3
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -0.5
  subsection lower
    set Lower lateral corner = -1, 0
    set Upper lateral corner = 1, 1
    set Thickness            = 0.5
    set Coarse cells         = 4, 2, 1
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
  subsection upper
    set Lower lateral corner = -1, 0
    set Upper lateral corner = 1, 1
    set Thickness            = 0.5
    set Coarse cells         = 3, 2, 1
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set a                              = 0.02
    set b                              = 0.01
    set Reference friction coefficient = 0.1
    set Reference slip rate            = 1e-3
    set Characteristic slip            = 1e-3
    set Regularisation                 = arcsinh
    set Initial state                  = 1 + 0.2 * x
    set Normal stress                  = function
    set Normal stress function         = 2e4
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1e-3
    set y condition = velocity
    set y value     = 5e-4 * t
    set z condition = traction
    set z value     = -1e3 * t
    set Ramp length = 1
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia  = quasi-dynamic
  set End time = 2
end
)";

  const Settings without_viscosity = {"Bodies/lower/Material/Shear viscosity=0",
                                      "Bodies/lower/Material/Bulk viscosity=0",
                                      "Bodies/upper/Material/Shear viscosity=0",
                                      "Bodies/upper/Material/Bulk viscosity=0",
                                      "Time/Inertia=quasi-dynamic"};

  /** Small errors in time, of any method. */
  const Settings exactly = {"Time/Tolerance=1e-9",
                            "Time/Rate-state tolerance=1e-10",
                            "Time/Loading tolerance=1e-7",
                            "Time/Ramp fraction=2e-3",
                            "TNNMG/Tolerance=1e-10"};



  template <int dim, int n_components = dim>
  FaultSnapshot<dim>
  at_end(const std::string &text, const Settings &settings)
  {
    const TemporaryFolder         folder;
    Simulation<dim, n_components> simulation(
      SceneReader(folder.write("scene.prm", text), settings)
        .template read<dim>(),
      MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation).front();
  }



  /** The largest differences of two faults in slip, log state, slip rate,
   * traction and normal stress, over the largest value but for the state. */
  template <int dim>
  std::array<double, 5>
  differences(const FaultSnapshot<dim> &a, const FaultSnapshot<dim> &b)
  {
    std::array<double, 5> difference = {}, largest = {};
    for (unsigned int k = 0; k < a.points.size(); ++k)
      {
        const auto compare =
          [&](const unsigned int i, const double d, const double size) {
            difference[i] = std::max(difference[i], d);
            largest[i]    = std::max(largest[i], size);
          };
        compare(0, (a.slip[k] - b.slip[k]).norm(), b.slip[k].norm());
        compare(1, std::abs(std::log(a.state[k] / b.state[k])), 1.);
        compare(2,
                (a.slip_rate[k] - b.slip_rate[k]).norm(),
                b.slip_rate[k].norm());
        compare(3,
                (a.shear_traction[k] - b.shear_traction[k]).norm(),
                b.shear_traction[k].norm());
        compare(4,
                std::abs(a.normal_stress[k] - b.normal_stress[k]),
                std::abs(b.normal_stress[k]));
      }
    for (unsigned int i = 0; i < 5; ++i)
      {
        EXPECT_GT(largest[i], 0.);
        difference[i] /= largest[i];
      }
    return difference;
  }



  template <int dim, int n_components = dim>
  void
  expect_as_implicit(const std::string &text, const Settings &settings)
  {
    const auto difference =
      differences(at_end<dim, n_components>(text,
                                            settings + exactly +
                                              Settings{explicit_steps}),
                  at_end<dim, n_components>(text, settings + exactly));
    for (unsigned int i = 0; i < difference.size(); ++i)
      {
        SCOPED_TRACE(testing::Message()
                     << dim << ' ' << n_components << ' ' << i);
        EXPECT_LT(difference[i], 1e-4);
      }
  }
} // namespace



// Implicit steps and these share friction and bodies, and no formula in time.
TEST(ExplicitSteps, GiveWhatImplicitOnesGive)
{
  expect_as_implicit<2, 1>(antiplane_bodies,
                           {"Faults/fault/a=0.02",
                            "Faults/fault/Reference friction coefficient=0.1",
                            "Faults/fault/Reference slip rate=1e-3",
                            "Faults/fault/Characteristic slip=1e-3",
                            "Time/End time=1"});
  expect_as_implicit<2>(
    creeping_bodies,
    without_viscosity +
      Settings{"Faults/fault/Normal stress follows=true",
               "Faults/fault/Reference friction coefficient=0.1",
               "Faults/fault/Regions/Names=part",
               "Faults/fault/Regions/part/Where=x - 0.3",
               "Faults/fault/Regions/part/"
               "Friction=prescribed slip rate",
               "Faults/fault/Regions/part/Slip rate along x=5e-4"});
  expect_as_implicit<3>(bodies_in_space,
                        {"Faults/fault/Normal stress follows=true"});
}



// An event, whose end depends on what it has done before.
TEST(ExplicitSteps, SmallTolerancesAgreeAfterEvents)
{
  const auto end = [](const std::string &tolerance) {
    return at_end<2, 1>(antiplane_bodies,
                        {explicit_steps, "Time/Tolerance=" + tolerance});
  };
  const FaultSnapshot<2> exact = end("1e-9");
  double                 slip  = 0.;
  for (const auto &s : exact.slip)
    slip = std::max(slip, std::abs(s[0]));
  // More than loading alone would do by the characteristic slip many times.
  EXPECT_GT(slip, 20. * 2e-5);
  const double coarse = differences(end("1e-4"), exact)[0],
               fine   = differences(end("1e-6"), exact)[0];
  EXPECT_LT(coarse, 1e-2);
  EXPECT_LT(fine, coarse / 5.);
}



// The account of the energy looks at bodies after every step.
TEST(ExplicitSteps, BodiesFollowForThoseWhoLook)
{
  const auto end = [](const std::string &energy) {
    auto simulation = std::make_unique<Simulation<2>>(
      read_scene(creeping_bodies,
                 without_viscosity +
                   Settings{explicit_steps,
                            "Faults/fault/Normal stress follows=true",
                            "Faults/fault/Regions/Names=part",
                            "Faults/fault/Regions/part/Where=x - 0.3",
                            "Faults/fault/Regions/part/"
                            "Friction=prescribed slip rate",
                            "Faults/fault/Regions/part/Slip rate along x=5e-4",
                            "Output/Energy balance=" + energy}),
      MPI_COMM_WORLD);
    simulation->set_up();
    while (!simulation->is_finished())
      simulation->advance();
    return simulation;
  };
  const auto            looked_at = end("true"), alone = end("false");
  const SystemState<2> &state = alone->state(), &expected = looked_at->state();
  EXPECT_TRUE(expected.is_complete);
  EXPECT_FALSE(state.is_complete);
  for (unsigned int k = 0; k < state.slip.size(); ++k)
    {
      EXPECT_EQ(state.slip[k], expected.slip[k]);
      EXPECT_EQ(state.alpha[k], expected.alpha[k]);
      EXPECT_EQ(state.contact_pressure[k], expected.contact_pressure[k]);
      EXPECT_EQ(state.balancing_traction[k], expected.balancing_traction[k]);
    }

  const auto difference = [](NodalVector a, const NodalVector &b) {
    a -= b;
    return a.linfty_norm() / b.linfty_norm();
  };
  EXPECT_GT(difference(state.displacement, expected.displacement), 1e-3);
  alone->complete_state();
  EXPECT_LT(difference(state.displacement, expected.displacement), 1e-11);
  EXPECT_LT(difference(state.velocity, expected.velocity), 1e-11);

  // Bodies in equilibrium have the forces that the steps have carried.
  SpatialProblem<2> &problem = alone->spatial_problem();
  NodalVector        u = problem.make_vector(), forces = u;
  problem.to_jumps(u, state.displacement);
  problem.term(SpatialProblem<2>::stiffness)
    .residual(forces, problem.load(state.time), u);
  const auto in_bodies = alone->fault_nodes().tangential_jumps(forces);
  double     largest = 0., error = 0.;
  for (unsigned int k = 0; k < state.slip.size(); ++k)
    {
      largest = std::max(largest, std::abs(in_bodies[k][0]));
      error =
        std::max(error, std::abs(in_bodies[k][0] - state.fault_force[k][0]));
    }
  EXPECT_GT(largest, 0.);
  EXPECT_LT(error, 1e-9 * largest);
}



// Loads that vary, prescribed slip and driven sides all have their parts.
TEST(ExplicitSteps, TellValuesOfBodiesThatHaveNotFollowed)
{
  SteppingScene scene(creeping_bodies,
                      without_viscosity +
                        Settings{explicit_steps,
                                 "Faults/fault/Regions/Names=part",
                                 "Faults/fault/Regions/part/Where=x - 0.3",
                                 "Faults/fault/Regions/part/"
                                 "Friction=prescribed slip rate",
                                 "Faults/fault/Regions/part/"
                                 "Slip rate along x=5e-4",
                                 "Boundary conditions/Sides="
                                 "lower bottom, upper top, upper right",
                                 "Boundary conditions/upper right/"
                                 "x condition=traction",
                                 "Boundary conditions/upper right/x value=1e3",
                                 "Boundary conditions/upper right/"
                                 "Ramp length=2"});
  scene.advance_until(1.2);
  ASSERT_FALSE(scene.state.is_complete);
  // All entries one by one, and a mean.
  std::vector<NodalFunctional> functionals(1);
  const unsigned int           n = scene.state.displacement.size();
  for (unsigned int i = 0; i < n; ++i)
    {
      functionals.push_back({{i, 1.}});
      functionals[0].emplace_back(i, 1. / n);
    }
  const FunctionalValues values =
    scene.controller->body_values(scene.state, functionals);
  const NodalVector before = scene.state.displacement;
  scene.controller->complete(scene.state);
  double change = 0.;
  for (unsigned int i = 0; i < functionals.size(); ++i)
    {
      const double u = part_of_value(functionals[i], scene.state.displacement),
                   v = part_of_value(functionals[i], scene.state.velocity);
      EXPECT_NEAR(values.of_displacement[i],
                  u,
                  1e-11 * scene.state.displacement.linfty_norm());
      EXPECT_NEAR(values.of_velocity[i],
                  v,
                  1e-11 * scene.state.velocity.linfty_norm());
      change =
        std::max(change, std::abs(part_of_value(functionals[i], before) - u));
    }
  EXPECT_GT(change, 1e-3 * scene.state.displacement.linfty_norm());
}



// The local error is of sixth order, its estimate of fifth.
TEST(ExplicitSteps, AreOfFifthOrder)
{
  SteppingScene scene(creeping_bodies,
                      without_viscosity +
                        Settings{explicit_steps,
                                 "Boundary conditions/upper top/Ramp length=0",
                                 "Time/Tolerance=1e-6"});
  scene.advance_until(0.5);
  ExplicitStep<2> step(scene.problem, scene.faults, scene.laws, {});
  const auto      after = [&](const double tau, const unsigned int n) {
    SystemState<2> state = scene.state;
    double         error = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        StepResult<2> result = step.take(state, tau, 1., error);
        EXPECT_TRUE(result.converged);
        state = std::move(result.state);
      }
    return std::make_pair(state.alpha, error);
  };
  const double tau    = 2.5e-4;
  const auto   exact  = after(tau / 16., 16).first;
  const auto   errors = [&](const unsigned int n) {
    std::vector<double> alpha = after(tau / n, n).first;
    for (unsigned int k = 0; k < alpha.size(); ++k)
      alpha[k] -= exact[k];
    return fault_norm(scene.faults, scene.laws, alpha);
  };
  EXPECT_NEAR(std::log2(errors(1) / errors(2)), 5., 0.7);
  EXPECT_NEAR(std::log2(after(tau, 1).second / after(tau / 2., 1).second),
              5.,
              0.7);
}



TEST(ExplicitSteps, WhatTheyAreNotForIsRefused)
{
  const auto expect = [](const Settings                 &settings,
                         const std::vector<std::string> &parts) {
    expect_one_sentence_with(message_of([&]() {
                               Simulation<2> simulation(
                                 read_scene(creeping_bodies,
                                            without_viscosity + settings +
                                              Settings{explicit_steps}),
                                 MPI_COMM_WORLD);
                               simulation.set_up();
                             }),
                             parts);
  };
  expect({"Time/Inertia=dynamic"}, {"quasi-dynamic"});
  expect({"Time/Inertia=quasi-static"}, {"quasi-dynamic"});
  expect({"Faults/fault/Contact=unilateral"}, {"'unilateral'"});
  expect({"Bodies/upper/Material/Shear viscosity=1e3"}, {"without viscosity"});
}
