// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "endless_layers.h"
#include "kinds_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Layers without ends that are pressed together more and more while they
   * creep at 1 mm/s, with mu = 0.6 there: from 1e4 Pa to twice that. */
  SceneParameters<2>
  pressed_layers(const std::vector<std::string> &more)
  {
    EndlessLayers scene;
    scene.thickness                    = {{0.5, 0.5}};
    scene.coarse_cells                 = {{{{3, 2}}, {{4, 2}}}};
    scene.length                       = 1.;
    scene.friction.reference_friction  = 0.6;
    scene.friction.reference_slip_rate = 1e-3;
    scene.normal_stress                = 1e4;
    scene.velocity                     = 1e-3;
    scene.ramp_length                  = 0.5;
    for (Material &material : scene.material)
      {
        material.youngs_modulus  = 4e8;
        material.shear_viscosity = material.bulk_viscosity = 0.;
      }
    return read_scene(
      scene.text(),
      std::vector<std::string>{
        "Faults/fault/Friction=velocity strengthening",
        "Boundary conditions/upper top/y condition=traction",
        "Boundary conditions/upper top/y value=-1e4 * if(t < 4, t / 4, 1)",
        "Time/Inertia=quasi-static"} +
        more);
  }
} // namespace



TEST(NormalStress, FollowsTheContactForce)
{
  const auto traction_at_end = [](const std::vector<std::string> &more) {
    Simulation<2> simulation(pressed_layers(more), MPI_COMM_WORLD);
    run(simulation);
    const FaultSnapshot<2> fault = snapshots(simulation).front();
    EXPECT_NEAR(mean(fault, fault.slip_rate), 1e-3, 5e-5);
    return mean(fault, fault.shear_traction);
  };
  const std::vector<std::string> follows = {
    "Faults/fault/Normal stress follows=true"};
  const std::vector<std::string> to_the_end = {"Time/End time=6",
                                               "Time/Largest step=0.25"};
  EXPECT_NEAR(traction_at_end(to_the_end), 0.6 * 1e4, 2.);
  EXPECT_NEAR(traction_at_end(to_the_end + follows), 0.6 * 2e4, 4.);

  // The layers become steeper while the traction grows: the slip rate is behind
  // by mu p' (h_1 + h_2) / G.
  const double lag = 0.6 * 1e4 / 4. / (4e8 / 2.6) / 1e-3;
  // While the pressure grows too, and whatever the step size: no step lags
  // behind.
  for (const std::string step : {"0.1", "0.05", "0.025"})
    EXPECT_NEAR(traction_at_end(
                  follows +
                  std::vector<std::string>{"Time/Step size control=constant",
                                           "Time/Largest step=" + step,
                                           "Time/End time=3"}),
                1.75e4 * (0.6 + 0.01 * std::log(1. - lag)),
                0.1)
      << step;
}



namespace
{
  /** The part of the upper body's weight that the PartnerForce carries. */
  double
  force_of_partners(Simulation<2> &simulation)
  {
    SpatialProblem<2> &problem = simulation.spatial_problem();
    if (!problem.partner_force().is_there())
      return 0.;
    NodalVector force = problem.make_vector();
    problem.partner_force().add(simulation.state().time, 1., force);
    const NodalVector   nodal = problem.to_nodal_forces(force);
    const MeshLevel<2> &level = simulation.meshes().finest();
    const BodyMesh<2>  &upper = *level.bodies[1];
    double              sum   = 0.;
    for (unsigned int dof = 0; dof < upper.dof_handler().n_dofs(); ++dof)
      if (!upper.bound_nodes().is_constrained(dof))
        sum += nodal.local_element(level.node(1, dof) * 2 + 1);
    return sum;
  }
} // namespace



TEST(ContactPressure, CarriesTheWeightAtAnyOverlap)
{
  // The upper body slides off by half of its length: what is left of the
  // contact presses harder, here and there under tension.
  Simulation<2> simulation(
    read_scene(creeping_bodies,
               {"Faults/fault/Friction=velocity strengthening",
                "Faults/fault/Initial state=1",
                "Faults/fault/Normal stress=initial equilibrium",
                "Faults/fault/Normal stress follows=true",
                "Boundary conditions/upper top/x value=0.25",
                "Boundary conditions/upper top/Ramp length=0.2",
                "Faults/fault/Reference slip rate=0.25",
                "Faults/fault/Characteristic slip=0.25",
                "Gravity/Acceleration=1",
                "TNNMG/Tolerance=1e-9",
                "Time/Inertia=quasi-static",
                "Time/Largest step=0.01",
                "Time/End time=4.1"}),
    MPI_COMM_WORLD);
  simulation.set_up();
  const double weight = 2. * 0.5 * Material().density;
  unsigned int checks = 0;
  while (!simulation.is_finished())
    {
      const unsigned int builds = simulation.counts().contact_mappings;
      simulation.advance();
      // The normal stress is that of the last step: of the old mapping, where
      // there is a new one.
      if (simulation.counts().contact_mappings != builds)
        continue;
      const FaultSnapshot<2> fault = snapshots(simulation).front();
      double                 force = 0.;
      for (unsigned int k = 0; k < fault.weights.size(); ++k)
        force += fault.weights[k] * simulation.state().contact_pressure[k];
      // The contact is that of the middle of an interval.
      EXPECT_NEAR(force, weight, 0.3 * weight) << simulation.state().time;
      EXPECT_NEAR(force + force_of_partners(simulation), weight, 1e-10 * weight)
        << simulation.state().time;
      ++checks;
    }
  EXPECT_GT(checks, 100u);
  EXPECT_GT(simulation.counts().contact_mappings, 30u);
  // The body has slid by half of its length.
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  EXPECT_NEAR(mean(fault, fault.slip), 1., 0.02);
}
