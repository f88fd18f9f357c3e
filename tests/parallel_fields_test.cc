// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "error_message.h"
#include "shared_and_alone.h"
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
  SharedAndAlone runs(scene);
  EXPECT_GT(runs.shared.counts().contact_mappings, 2u);
  for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
    {
      const FaultLaw               &law      = runs.shared.node_laws()[k];
      const RateAndStateParameters &friction = friction_parameters(law);
      const double                  x        = runs.one.points[k][0];
      EXPECT_DOUBLE_EQ(friction.a, 0.02 + 0.008 * std::sin(3 * x));
      EXPECT_EQ(friction.b, x < 0. ? 0.01 : 0.005);
      EXPECT_DOUBLE_EQ(law.characteristic_slip, 0.25 * (1.2 + x));
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
  SharedAndAlone runs(scene, {1e-8, 1e-8, 1e-4});
  double         largest = 0;
  for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
    {
      EXPECT_EQ(runs.shared.node_laws()[k].radiation_damping,
                runs.alone.node_laws()[k].radiation_damping);
      EXPECT_EQ(runs.shared.state().normal_stress[k],
                runs.alone.state().normal_stress[k]);
      largest = std::max(largest, std::abs(runs.one.slip_rate[k][0]));
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
