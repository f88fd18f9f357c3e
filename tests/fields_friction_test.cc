// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>

#include <set>

#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The positions of the slave nodes. */
  std::vector<Point<2>>
  fault_nodes_of(const SteppingScene &scene)
  {
    return scene.problem.jump_basis().faults()[0].slave.points;
  }



  /** The text of a table of a function of x with a row for each node. */
  template <typename Function>
  std::string
  table_at_nodes(const std::vector<Point<2>> &nodes, const Function &f)
  {
    std::string text = "x\n";
    for (const Point<2> &node : nodes)
      text += shortest_form(node[0]) + " " + shortest_form(f(node[0])) + "\n";
    return text;
  }



  /** The end of a run of the creeping bodies. */
  SystemState<2>
  end_of_run(const std::vector<std::string> &overrides)
  {
    SteppingScene scene(creeping_bodies, overrides);
    scene.advance_until(0.3);
    return scene.state;
  }



  /** Friction that varies with all its parameters. */
  const std::vector<std::string> varying_friction = {
    "Faults/fault/a=0.02 + 0.008*sin(3*x)",
    "Faults/fault/b=0.01*(1 + x^2)",
    "Faults/fault/Reference friction coefficient=0.01 + 0.005*x",
    "Faults/fault/Reference slip rate=1e-3*exp(0.5*x)",
    "Faults/fault/Characteristic slip=1e-3*(1.2 + x)"};

} // namespace



TEST(FrictionFields, NumberExpressionAndTableOfTheSameValuesGiveTheSameRun)
{
  const TemporaryFolder folder;
  const std::string     as_table =
    "table " + folder.write("a.txt", "x\n-1 0.02\n1 0.02\n");
  const SystemState<2> number = end_of_run({});
  EXPECT_TRUE(same_bits(number, end_of_run({"Faults/fault/a=0.02 + 0*x"})));
  EXPECT_TRUE(same_bits(number, end_of_run({"Faults/fault/a=" + as_table})));
  // Not because nothing matters.
  EXPECT_FALSE(same_bits(number, end_of_run({"Faults/fault/a=0.021"})));

  const std::vector<Point<2>> nodes =
    fault_nodes_of(SteppingScene(creeping_bodies));
  const std::string varying_table =
    "table " + folder.write("v.txt", table_at_nodes(nodes, [](const double x) {
                              return 0.02 + 0.001 * x;
                            }));
  EXPECT_TRUE(
    same_bits(end_of_run({"Faults/fault/a=0.02 + 0.001*x",
                          "Faults/fault/Normal stress function=2e4"}),
              end_of_run({"Faults/fault/a=" + varying_table,
                          "Faults/fault/Normal stress function=1e4 + 1e4"})));
}



TEST(FrictionFields, NodesWithTheSameParametersShareALaw)
{
  EXPECT_EQ(SteppingScene(creeping_bodies).laws.laws.size(), 1u);

  const SteppingScene patch(creeping_bodies,
                            {"Faults/fault/a=if(abs(x) < 0.51, 0.005, 0.02)"});
  EXPECT_EQ(patch.laws.laws.size(), 2u);
  const std::vector<Point<2>> nodes = fault_nodes_of(patch);
  unsigned int                n_in  = 0;
  std::set<const FaultLaw *>  inside, outside;
  for (unsigned int k = 0; k < nodes.size(); ++k)
    {
      const bool is_in = std::abs(nodes[k][0]) < 0.51;
      n_in += is_in;
      EXPECT_EQ(friction_parameters(patch.laws[k]).a, is_in ? 0.005 : 0.02);
      EXPECT_EQ(&patch.laws[k], &patch.laws[is_in ? 8 : 0]);
    }
  // Every 0.125 m there is a node.
  EXPECT_EQ(n_in, 9u);
  EXPECT_EQ(nodes.size(), 17u);

  const SteppingScene       varying(creeping_bodies, varying_friction);
  const std::vector<double> a = varying.scene.faults[0]["a"].values(nodes, "");
  EXPECT_EQ(varying.laws.laws.size(), nodes.size());
  for (unsigned int k = 0; k < nodes.size(); ++k)
    EXPECT_EQ(friction_parameters(varying.laws[k]).a, a[k]);
}



/*
 * A patch that weakens with the slip rate inside a fault that strengthens. In
 * the end all of the fault slides as fast as the bodies are dragged, the state
 * is L/V, and friction is that of steady sliding at each node.
 */
TEST(FrictionFields, SteadySlidingOfAWeakeningPatchHasTheFrictionOfEachPart)
{
  const double  speed = 1e-3, sigma = 2e4, mu_0 = 0.3, V_0 = 1e-4;
  SteppingScene scene(creeping_bodies,
                      {"Faults/fault/a=if(abs(x) < 0.51, 0.005, 0.02)",
                       "Faults/fault/b=0.012",
                       "Faults/fault/Reference friction coefficient=0.3",
                       "Faults/fault/Reference slip rate=1e-4",
                       "Faults/fault/Characteristic slip=3e-4*(1.5 + x)",
                       "Time/End time=12",
                       "Time/Tolerance=1e-4"});
  // The state follows the loading of 1 s with L/V, at most 0.75 s.
  scene.advance_until(12.);

  const std::vector<Point<2>> nodes = fault_nodes_of(scene);
  double                      force = 0, area = 0;
  for (unsigned int k = 0; k < nodes.size(); ++k)
    {
      const double x = nodes[k][0];
      const double a = std::abs(x) < 0.51 ? 0.005 : 0.02;
      EXPECT_NEAR(scene.state.slip_rate[k].norm(), speed, 1e-5 * speed);
      EXPECT_NEAR(scene.state.alpha[k],
                  std::log(3e-4 * (1.5 + x) / speed),
                  1e-4);
      force += scene.faults.weights()[k] * sigma *
               (mu_0 + (a - 0.012) * std::log(speed / V_0));
      area += scene.faults.weights()[k];
    }
  EXPECT_NEAR(area, 2., 1e-12);

  // The force that holds the lower body, at rest by now, is that of its
  // deformation at its top.
  const MeshLevel<2>      &level    = scene.meshes.finest();
  const ElasticMatrices<2> matrices = assemble_elastic_matrices(
    level, {scene.scene.bodies[0].material, scene.scene.bodies[1].material});
  NodalVector forces = scene.state.displacement;
  matrices.stiffness.vmult(forces, scene.state.displacement);
  double on_top = 0;
  for (const auto node : level.surface(/*fault=*/0, /*side=*/0).nodes)
    on_top += forces.local_element(2 * node);
  EXPECT_NEAR(std::abs(on_top), force, 1e-5 * force);
  // One law alone has another one.
  EXPECT_GT(std::abs(force - sigma * area * mu_0), 1e-3 * force);
}



TEST(FrictionFields, CondensedNewtonAndTNNMGAgree)
{
  for (const std::string regularisation : {"arcsinh", "truncated"})
    {
      SCOPED_TRACE(regularisation);
      // Both take the same steps: short ones, since below Vmin, where the
      // truncated law has no friction, TNNMG takes many iterations.
      const std::vector<std::string> common =
        varying_friction +
        Settings{"Faults/fault/Regularisation=" + regularisation,
                 "TNNMG/Tolerance=1e-12",
                 "Time/Rate-state tolerance=1e-12",
                 "Faults/fault/Reference friction coefficient=0.1 + 0.005*x",
                 "Time/Step size control=constant",
                 "Time/Largest step=5e-4"};
      const SystemState<2> one = end_of_run(common);
      const SystemState<2> two =
        end_of_run(common + Settings{"Time/Rate solver=condensed Newton"});
      EXPECT_EQ(one.time, two.time);
      double largest = 0;
      for (const auto &V : one.slip_rate)
        largest = std::max(largest, V.norm());
      EXPECT_GT(largest, 1e-5);
      for (unsigned int k = 0; k < one.alpha.size(); ++k)
        {
          EXPECT_NEAR(one.slip_rate[k][0], two.slip_rate[k][0], 1e-7 * largest);
          EXPECT_NEAR(one.alpha[k], two.alpha[k], 1e-7);
        }
    }
}



// The state of each node follows the slip rate with its own characteristic slip
// and a step doubled or embedded leads to the same.
TEST(FrictionFields, StepDoublingAndTheEmbeddedControlAgree)
{
  const SystemState<2> embedded = end_of_run(
    varying_friction + Settings{"Time/Tolerance=1e-7", "Time/End time=0.3"});
  const SystemState<2> doubling = end_of_run(
    varying_friction + Settings{"Time/Step size control=step doubling",
                                "Time/Doubling threshold=1e-7",
                                "Time/End time=0.3"});
  EXPECT_NEAR(embedded.time, 0.3, 1e-12);
  EXPECT_NEAR(doubling.time, 0.3, 1e-12);
  double largest = 0;
  for (const auto &V : embedded.slip_rate)
    largest = std::max(largest, V.norm());
  for (unsigned int k = 0; k < embedded.alpha.size(); ++k)
    {
      EXPECT_NEAR(embedded.slip_rate[k][0],
                  doubling.slip_rate[k][0],
                  1e-3 * largest);
      EXPECT_NEAR(embedded.alpha[k], doubling.alpha[k], 1e-4);
    }
}
