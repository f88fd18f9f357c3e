// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>

#include <cmath>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::vector<std::string> without_inertia = {"quasi-dynamic",
                                                    "quasi-static"};

  const std::vector<std::string> inviscid = {
    "Bodies/lower/Material/Shear viscosity=0",
    "Bodies/lower/Material/Bulk viscosity=0",
    "Bodies/upper/Material/Shear viscosity=0",
    "Bodies/upper/Material/Bulk viscosity=0"};



  double
  largest_difference(const NodalVector &a, const NodalVector &b)
  {
    NodalVector difference = a;
    difference -= b;
    return difference.linfty_norm();
  }



  /** After steps of one size that are short enough for the fault, whose
   * friction and stiffness give it a time of 0.01 s; solved exactly. */
  SystemState<2>
  state_after(const std::string              &inertia,
              const double                    tau,
              const std::vector<std::string> &more)
  {
    SteppingScene scene(
      creeping_bodies,
      Settings{"Time/Inertia=" + inertia,
               "Time/Step size control=constant",
               "Time/Largest step=" + std::to_string(tau),
               "Time/End time=0.5",
               "Time/Rate-state tolerance=1e-12",
               "TNNMG/Tolerance=1e-12",
               "Boundary conditions/upper top/x value=4e-3*t^4",
               "Boundary conditions/upper top/Ramp length=0",
               "Output/Event start slip rate=1"} +
        more);
    scene.advance_until(0.5 - 1e-9);
    EXPECT_NEAR(scene.state.time, 0.5, 1e-9);
    return scene.state;
  }



  /** One body between two others, held by friction alone; coarse enough for
   * dense matrices. */
  const std::string floating_body = R"(
subsection Bodies
  set Names = lower, middle, upper
  subsection lower
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 4, 1
    set Refinement passes    = 2
  end
  subsection middle
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.2
    set Coarse cells         = 10, 1
    set Refinement passes    = 1
  end
  subsection upper
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 4, 1
    set Refinement passes    = 2
  end
end
subsection Faults
  set Names = one, two
  subsection one
    set Characteristic slip = 5e-6
  end
  subsection two
    set Characteristic slip = 5e-6
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 2e-4
    set Ramp length = 1
  end
end
subsection Time
  set End time = 100
end
)";



  /** All states of some steps, as long as the slip rates are small enough for
   * a quasi-static run to go on. */
  std::vector<SystemState<2>>
  run_floating(const std::vector<std::string> &overrides,
               const unsigned int              n_steps)
  {
    const SceneParameters<2> scene = read_scene(floating_body, overrides);
    Simulation<2>            simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    std::vector<SystemState<2>> states;
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        simulation.advance();
        states.push_back(simulation.state());
        if (states.back().velocity.linfty_norm() > 0.05)
          break;
      }
    return states;
  }
} // namespace



TEST(Inertia, OnlyTheTermsOfTheSceneAreThere)
{
  using Problem = SpatialProblem<2>;
  std::vector<std::size_t> bytes;
  for (const bool is_dynamic : {true, false})
    for (const bool is_viscous : {true, false})
      {
        SteppingScene scene(creeping_bodies,
                            Settings{
                              std::string("Time/Inertia=") +
                              (is_dynamic ? "dynamic" : "quasi-dynamic")} +
                              (is_viscous ? Settings() : inviscid));
        Problem      &problem = scene.problem;
        EXPECT_EQ(problem.has(Problem::mass), is_dynamic);
        EXPECT_EQ(problem.has(Problem::damping), is_viscous);
        EXPECT_TRUE(problem.has(Problem::stiffness));
        if (!is_dynamic)
          {
            EXPECT_ANY_THROW(problem.term(Problem::mass));
            EXPECT_EQ(scene.state.acceleration.size(), 0u);
          }
        if (!is_viscous)
          {
            EXPECT_ANY_THROW(problem.term(Problem::damping));
          }
        // All levels are made by the first step.
        scene.advance();
        EXPECT_EQ(scene.state.acceleration.size() > 0, is_dynamic);
        bytes.push_back(problem.hierarchy().memory_consumption());

        // A new contact mapping keeps it so.
        problem.build_contact(scene.state.displacement);
        EXPECT_EQ(problem.has(Problem::mass), is_dynamic);
        EXPECT_EQ(problem.has(Problem::damping), is_viscous);
        const std::size_t matrix =
          problem.operators().matrix().memory_consumption();
        if (bytes.size() > 1)
          {
            // Each term less saves a matrix in double precision on the finest
            // level, of which mass has a number for each block and viscosity
            // one triangle, and in single precision on all below.
            const double on_finest =
                           matrix * (0.5 * !is_viscous + 0.25 * !is_dynamic),
                         below = matrix * (!is_viscous + !is_dynamic);
            EXPECT_GE(bytes.front() - bytes.back(), on_finest);
            EXPECT_LE(bytes.front() - bytes.back(), on_finest + 0.5 * below);
          }
      }
}



TEST(Inertia, WithoutMassVelocitiesAreOfSecondOrderInTheBodiesToo)
{
  // With the trapezoidal rule those of inviscid bodies would swing for ever.
  for (const std::string &inertia : without_inertia)
    for (const bool is_viscous : {true, false})
      {
        const std::vector<std::string> more =
          is_viscous ? std::vector<std::string>() : inviscid;
        std::vector<SystemState<2>> states;
        for (const double tau : {0.005, 0.0025, 0.00125, 0.000625})
          states.push_back(state_after(inertia, tau, more));
        for (unsigned int i = 0; i < 2; ++i)
          {
            const auto order = [&](const auto member) {
              return std::log2(
                largest_difference(states[i].*member, states[i + 1].*member) /
                largest_difference(states[i + 1].*member,
                                   states[i + 2].*member));
            };
            EXPECT_NEAR(order(&SystemState<2>::velocity), 2., 0.15)
              << inertia << ' ' << is_viscous;
            EXPECT_NEAR(order(&SystemState<2>::displacement), 2., 0.15)
              << inertia << ' ' << is_viscous;
          }
        EXPECT_LT(largest_difference(states[2].velocity, states[3].velocity),
                  1e-3 * states[3].velocity.linfty_norm());
      }
}



TEST(Inertia, BodiesHeldByFrictionAlone)
{
  // Multigrid against dense matrices, from rest into an event.
  for (const std::string &inertia : without_inertia)
    {
      SCOPED_TRACE(inertia);
      const std::vector<std::string> common = {
        "Time/Inertia=" + inertia,
        "Bodies/middle/Material/Shear viscosity=0",
        "Bodies/middle/Material/Bulk viscosity=0",
        "Time/Tolerance=1e-4",
        "TNNMG/Tolerance=1e-11",
        "Time/Rate-state tolerance=1e-10"};
      constexpr unsigned int            n_steps = 1000;
      const std::vector<SystemState<2>> ours    = run_floating(common, n_steps);
      const std::vector<SystemState<2>> exact =
        run_floating(common + Settings{"Time/Rate solver=condensed Newton"},
                     n_steps);
      ASSERT_EQ(ours.size(), exact.size());
      double largest = 0., error = 0.;
      for (unsigned int n = 0; n < ours.size(); ++n)
        {
          ASSERT_EQ(ours[n].time, exact[n].time);
          const double size = exact[n].velocity.linfty_norm();
          largest           = std::max(largest, size);
          error =
            std::max(error,
                     largest_difference(ours[n].velocity, exact[n].velocity) /
                       size);
        }
      std::cout << inertia << ": " << ours.size() << " steps until "
                << ours.back().time << " s, largest velocity " << largest
                << " m/s, largest relative difference " << error << '\n';
      EXPECT_GT(largest, 1e-3);
      EXPECT_LT(error, 1e-5);
    }
}



TEST(Inertia, NothingHoldsTheBody)
{
  const auto run = [](const std::string &inertia) -> std::string {
    try
      {
        run_floating({"Time/Inertia=" + inertia,
                      "Faults/one/Normal stress=function",
                      "Faults/one/Normal stress function=0",
                      "Faults/two/Normal stress=function",
                      "Faults/two/Normal stress function=0"},
                     3);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  };
  const std::string message = run("quasi-static");
  for (const std::string part :
       {"'Time/Inertia' = 'quasi-static'", "'middle'", "along x"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(run("quasi-dynamic"), "no error");
  EXPECT_EQ(run("dynamic"), "no error");
}
