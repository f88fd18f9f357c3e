// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Three creeping bodies whose meshes match nowhere.
  std::string
  three_bodies()
  {
    std::string                                   text   = R"(
subsection Bodies
  set Names          = lower, middle, upper
  set Base elevation = -1
)";
    const std::vector<std::array<std::string, 3>> bodies = {
      {{"lower", "0.5", "4, 1"}},
      {{"middle", "0.2", "7, 1"}},
      {{"upper", "0.5", "5, 1"}}};
    for (const auto &body : bodies)
      text += "subsection " + body[0] +
              "\n set Lower lateral corner = -1\n set Upper lateral corner = 1"
              "\n set Thickness = " +
              body[1] + "\n set Coarse cells = " + body[2] +
              "\n set Refinement passes = 2\n subsection Material\n"
              "  set Shear viscosity = 2e5\n  set Bulk viscosity = 2e5\n"
              " end\nend\n";
    text += "end\nsubsection Faults\n set Names = first, second\n";
    for (const std::string fault : {"first", "second"})
      text += "subsection " + fault +
              "\n set a = 0.02\n set b = 0.01\n"
              " set Reference friction coefficient = 0\n"
              " set Reference slip rate = 1e-3\n"
              " set Characteristic slip = 1e-3\n"
              " set Regularisation = arcsinh\n"
              " set Initial state = 1\n"
              " set Normal stress = lithostatic\nend\n";
    text += R"(
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1e-3
    set Ramp length = 1
  end
end
subsection Time
  set End time             = 1.5
  set Rate-state tolerance = 1e-10
end
subsection TNNMG
  set Tolerance = 1e-11
end
)";
    return text;
  }



  std::vector<FaultSnapshot<2>>
  faults_at_end(const SceneParameters<2>       &scene,
                const std::vector<std::string> &names)
  {
    Simulation<2> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation, names);
  }



  std::vector<FaultSnapshot<2>>
  faults_at_end(const std::string              &text,
                const std::vector<std::string> &overrides,
                const std::vector<std::string> &names)
  {
    return faults_at_end(read_scene(text, overrides), names);
  }
} // namespace



TEST(Symmetry, MirroredLoadingGivesTheMirroredResult)
{
  const std::vector<std::string> names = {"first", "second"};
  const auto right = faults_at_end(three_bodies(), {}, names);
  const auto left =
    faults_at_end(three_bodies(),
                  {"Boundary conditions/upper top/x value=-1e-3"},
                  names);
  for (unsigned int f = 0; f < 2; ++f)
    {
      SCOPED_TRACE(names[f]);
      const unsigned int n = right[f].points.size();
      ASSERT_EQ(left[f].points.size(), n);
      EXPECT_GT(right[f].slip[n / 2][0], 1e-5);
      // Not rounding alone: the iterations stop at their tolerance.
      for (unsigned int k = 0; k < n; ++k)
        {
          const unsigned int m = n - 1 - k;
          EXPECT_NEAR(left[f].points[m][0], -right[f].points[k][0], 1e-12);
          EXPECT_NEAR(left[f].weights[m], right[f].weights[k], 1e-12);
          EXPECT_NEAR(left[f].slip[m][0], -right[f].slip[k][0], 1e-9);
          EXPECT_NEAR(left[f].slip_rate[m][0], -right[f].slip_rate[k][0], 1e-8);
          EXPECT_NEAR(left[f].state[m], right[f].state[k], 1e-6);
          EXPECT_NEAR(left[f].shear_traction[m][0],
                      -right[f].shear_traction[k][0],
                      1e-6 * right[f].normal_stress[k]);
        }
    }
}



TEST(Symmetry, BodiesAndFaultsInAnyOrderGiveTheSameResult)
{
  const SceneParameters<2> stack    = read_scene(three_bodies());
  const auto               expected = faults_at_end(stack, {"first", "second"});

  // Bodies and faults in another order, and the sides of one fault exchanged.
  SceneParameters<2> scene = stack;
  scene.bodies          = {stack.bodies[2], stack.bodies[0], stack.bodies[1]};
  scene.faults          = {stack.faults[1], stack.faults[0]};
  constexpr auto top    = BodyMesh<2>::upper_side,
                 bottom = BodyMesh<2>::lower_side;
  scene.topology        = FaultTopology({"upper", "lower", "middle"},
                                 {{"second", {{{{0, bottom}}, {{2, top}}}}},
                                         {"first", {{{{1, top}}, {{2, bottom}}}}}});
  const auto found      = faults_at_end(scene, {"second", "first"});

  for (unsigned int f = 0; f < 2; ++f)
    {
      const FaultSnapshot<2> &a    = expected[f];
      const FaultSnapshot<2> &b    = found[1 - f];
      const double            sign = f == 0 ? 1. : -1.;
      SCOPED_TRACE(b.name);
      EXPECT_EQ(a.name, b.name);
      ASSERT_EQ(a.points, b.points);
      for (unsigned int k = 0; k < a.points.size(); ++k)
        {
          EXPECT_GT(std::abs(a.slip[k][0]), 1e-6);
          EXPECT_NEAR(a.weights[k], b.weights[k], 1e-12);
          EXPECT_NEAR(a.normal_stress[k],
                      b.normal_stress[k],
                      1e-10 * a.normal_stress[k]);
          EXPECT_NEAR(a.slip[k][0], sign * b.slip[k][0], 1e-9);
          EXPECT_NEAR(a.slip_rate[k][0], sign * b.slip_rate[k][0], 1e-8);
          EXPECT_NEAR(a.state[k], b.state[k], 1e-6);
        }
    }
}



TEST(Symmetry, TwoRigidBodiesSideBySideActAsOne)
{
  const SceneParameters<2> one =
    read_scene(creeping_bodies, {"Bodies/lower/Rigid=true"});
  const auto expected = faults_at_end(one, {"fault"});

  SceneParameters<2> two = one;
  two.bodies.push_back(one.bodies[0]);
  two.bodies[2].name                      = "right";
  two.bodies[0].geometry.lateral_upper[0] = 0.3;
  two.bodies[2].geometry.lateral_lower[0] = 0.3;
  constexpr auto top                      = BodyMesh<2>::upper_side,
                 bottom                   = BodyMesh<2>::lower_side;
  two.topology =
    FaultTopology({"lower", "upper", "right"},
                  {{"fault", {{{{0, top}, {2, top}}, {{1, bottom}}}}}});
  const auto found = faults_at_end(two, {"fault"});

  ASSERT_EQ(found[0].points, expected[0].points);
  for (unsigned int k = 0; k < found[0].points.size(); ++k)
    {
      EXPECT_GT(expected[0].slip[k][0], 1e-5);
      EXPECT_NEAR(found[0].weights[k], expected[0].weights[k], 1e-12);
      EXPECT_NEAR(found[0].slip[k][0], expected[0].slip[k][0], 1e-9);
      EXPECT_NEAR(found[0].slip_rate[k][0], expected[0].slip_rate[k][0], 1e-8);
      EXPECT_NEAR(found[0].state[k], expected[0].state[k], 1e-6);
    }
}



TEST(Symmetry, BothFaultsOfThreeBodiesShareTheLoading)
{
  const auto faults = faults_at_end(three_bodies(), {}, {"first", "second"});
  double     slip   = 0;
  for (const FaultSnapshot<2> &fault : faults)
    {
      const FaultStatistics statistics = fault_statistics(fault);
      EXPECT_GT(statistics.mean_slip, 0.);
      EXPECT_GT(statistics.mean_shear_traction, 0.);
      slip += statistics.mean_slip;
    }
  // Motion of the top side that is not shear of the bodies.
  EXPECT_LT(slip, 1e-3);
  EXPECT_GT(slip, 0.8e-3);
}



TEST(Symmetry, TheChoiceOfTheSlaveChangesOnlyTheDiscretisationError)
{
  double mean_slip[2], traction[2], state[2];
  for (const unsigned int finer : {0, 1})
    {
      const std::string body  = finer == 0 ? "lower" : "upper";
      const auto        scene = read_scene(creeping_bodies,
                                    {"Bodies/" + body + "/Coarse cells=6, 2",
                                            "Faults/fault/Initial state=1"});
      Simulation<2>     simulation(scene, MPI_COMM_WORLD);
      EXPECT_EQ(simulation.spatial_problem()
                  .jump_basis()
                  .faults()
                  .front()
                  .sides.slave_is_second(),
                finer == 1);
      simulation.set_up();
      while (!simulation.is_finished())
        simulation.advance();
      const FaultStatistics statistics =
        fault_statistics(snapshots(simulation).front());
      mean_slip[finer] = statistics.mean_slip;
      traction[finer]  = statistics.mean_shear_traction;
      state[finer]     = statistics.mean_state;
    }
  EXPECT_GT(mean_slip[0], 1e-3);
  EXPECT_NEAR(mean_slip[0], mean_slip[1], 1e-3 * mean_slip[0]);
  EXPECT_NEAR(traction[0], traction[1], 1e-3 * traction[0]);
  EXPECT_NEAR(state[0], state[1], 1e-3 * state[0]);
}
