// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "error_message.h"
#include "parallel_comparison.h"
#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * Bodies that slide by a quarter of a metre, several faces, with friction that
 * varies along the fault: the same on all processes as on one, and the
 * parameters stay with the nodes.
 */
TEST(ParallelFields, FrictionThatVariesIsTheSame)
{
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Boundary conditions/upper top/x value=0.25",
                "Boundary conditions/upper top/Ramp length=0.2",
                "Faults/fault/a=0.02 + 0.008*sin(3*x)",
                "Faults/fault/b=if(x < 0, 0.01, 0.005)",
                "Faults/fault/Reference slip rate=0.25*exp(0.5*x)",
                "Faults/fault/Characteristic slip=0.25*(1.2 + x)",
                "Faults/fault/Normal stress function=1e3*(1 + 0.1*x)",
                "Time/End time=1.1",
                "Time/Largest step=0.05",
                "Time/Tolerance=1e-3",
                "TNNMG/Tolerance=1e-9"});
  Simulation<2> shared(scene, MPI_COMM_WORLD);
  Simulation<2> alone(scene, MPI_COMM_SELF);
  for (Simulation<2> *simulation : {&shared, &alone})
    {
      simulation->set_up();
      while (!simulation->is_finished())
        simulation->advance();
    }
  EXPECT_EQ(shared.state().time, alone.state().time);
  EXPECT_GT(shared.spatial_problem().n_builds(), 2u);

  const FaultSnapshot<2> ours = snapshots(shared).front(),
                         one  = snapshots(alone).front();
  ASSERT_EQ(ours.slip.size(), one.slip.size());
  for (unsigned int k = 0; k < ours.slip.size(); ++k)
    {
      EXPECT_EQ(ours.points[k], one.points[k]);
      EXPECT_NEAR(ours.slip[k][0], one.slip[k][0], 1e-6);
      EXPECT_NEAR(ours.slip_rate[k][0], one.slip_rate[k][0], 1e-5);
      EXPECT_NEAR(ours.state[k], one.state[k], 1e-4 * one.state[k]);
      const double x = ours.points[k][0];
      EXPECT_DOUBLE_EQ(shared.fault_nodes().law(k).a,
                       0.02 + 0.008 * std::sin(3 * x));
      EXPECT_EQ(shared.fault_nodes().law(k).b, x < 0. ? 0.01 : 0.005);
      EXPECT_DOUBLE_EQ(shared.fault_nodes().law(k).characteristic_slip,
                       0.25 * (1.2 + x));
    }
}



/*
 * Bodies whose materials vary, from the initial equilibrium under their weight
 * on. Without inertia, so that the radiation damping of each node counts.
 */
TEST(ParallelFields, MaterialsThatVaryAreTheSame)
{
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Bodies/lower/Material/Young modulus=4.12e7*(1.5 + x)",
                "Bodies/lower/Material/Density=5e3*(1 - y)",
                "Bodies/upper/Material/Poisson ratio=0.25 + 0.1*x*y",
                "Bodies/upper/Material/Density=if(x < 0.3, 3e3, 6e3)",
                "Bodies/upper/Material/Shear viscosity=2e5*exp(x)",
                "Gravity/Acceleration=1",
                "Faults/fault/Normal stress=lithostatic",
                "Time/Inertia=quasi-dynamic",
                "Time/End time=0.5",
                "TNNMG/Tolerance=1e-9"});
  Simulation<2> shared(scene, MPI_COMM_WORLD);
  Simulation<2> alone(scene, MPI_COMM_SELF);
  for (Simulation<2> *simulation : {&shared, &alone})
    {
      simulation->set_up();
      while (!simulation->is_finished())
        simulation->advance();
    }
  EXPECT_EQ(shared.state().time, alone.state().time);
  const FaultSnapshot<2> ours = snapshots(shared).front(),
                         one  = snapshots(alone).front();
  ASSERT_EQ(ours.slip.size(), one.slip.size());
  double largest = 0;
  for (unsigned int k = 0; k < ours.slip.size(); ++k)
    {
      EXPECT_EQ(ours.points[k], one.points[k]);
      EXPECT_NEAR(ours.slip[k][0], one.slip[k][0], 1e-8);
      EXPECT_NEAR(ours.slip_rate[k][0], one.slip_rate[k][0], 1e-8);
      EXPECT_NEAR(ours.state[k], one.state[k], 1e-4 * one.state[k]);
      EXPECT_EQ(shared.fault_nodes().law(k).radiation_damping,
                alone.fault_nodes().law(k).radiation_damping);
      EXPECT_EQ(shared.fault_nodes().normal_stress()[k],
                alone.fault_nodes().normal_stress()[k]);
      largest = std::max(largest, std::abs(one.slip_rate[k][0]));
    }
  EXPECT_GT(largest, 1e-4);
}



TEST(ParallelFields, AllProcessesHearOfAMistakeThatOneFinds)
{
  // At one end only, away from the corners and from the fault.
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Bodies/upper/Material/Density="
                "if(x > 0.7 && x < 0.95 && y > 0.4, -3, 5e3)"});
  const std::string message =
    message_of([&]() { Simulation<2> simulation(scene, MPI_COMM_WORLD); });
  expect_one_sentence_with(message,
                           {"'Bodies/upper/Material/Density' = 'if(",
                            "is -3 at (0.",
                            "everywhere."});
}
