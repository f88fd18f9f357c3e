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
  /** Nodal values at the x of each node of a horizontal side, by x. */
  std::map<double, Tensor<1, 2>>
  values_on_side(const Simulation<2> &simulation,
                 const unsigned int   body,
                 const unsigned int   side)
  {
    const MeshLevel<2>            &level   = simulation.meshes().finest();
    const FaultSurface<2>          surface = level.bodies[body]->surface(side);
    std::map<double, Tensor<1, 2>> values;
    for (unsigned int k = 0; k < surface.nodes.size(); ++k)
      for (unsigned int d = 0; d < 2; ++d)
        values[surface.points[k][0]][d] =
          simulation.state().displacement.local_element(
            level.node(body, surface.nodes[k]) * 2 + d);
    return values;
  }



  /** Two layers of 1 m that are 2 m wide; G = 4e7 and 2e7 Pa. */
  EndlessLayers
  layers(const bool lower_is_softer)
  {
    EndlessLayers scene;
    for (unsigned int i = 0; i < 2; ++i)
      {
        scene.material[i].poissons_ratio = 0.25;
        scene.material[i].youngs_modulus =
          2.5 * ((i == 0) == lower_is_softer ? 4e6 : 4e7);
        scene.material[i].density         = 5e3;
        scene.material[i].shear_viscosity = 0.;
        scene.material[i].bulk_viscosity  = 0.;
      }
    scene.thickness           = {{1., 1.}};
    scene.coarse_cells        = {{{{2, 1}}, {{2, 1}}}};
    scene.length              = 2.;
    scene.uniform_refinements = 2;
    scene.normal_stress       = 1e4;
    return scene;
  }
} // namespace



TEST(Welded, TwoBodiesMoveAsOne)
{
  // Equal waves run through two bodies with meshes that match and through
  // one of the same size.
  const std::string one_body = R"(
subsection Bodies
  set Names          = lower
  set Base elevation = -0.5
  subsection lower
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 1
    set Coarse cells         = 4, 2
    set Uniform refinements  = 2
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 2e3
      set Bulk viscosity  = 0
    end
  end
end
subsection Boundary conditions
  set Sides = lower bottom, lower top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection lower top
    set x condition = velocity
    set x value     = 1e-2 * (1 + x)
    set y condition = traction
    set y value     = -1e4 * t
    set Ramp length = 0
  end
end
subsection Time
  set Step size control = constant
  set Largest step      = 1e-3
  set End time          = 0.05
end
subsection TNNMG
  set Tolerance = 1e-12
end
)";
  Simulation<2>     whole(read_scene(one_body), MPI_COMM_WORLD);
  run(whole);
  std::vector<std::string> two = {
    "Faults/fault/Friction=welded",
    "Faults/fault/Normal stress=initial equilibrium",
    "Faults/fault/Initial state=1",
    "Boundary conditions/upper top/x value=1e-2 * (1 + x)",
    "Boundary conditions/upper top/Ramp length=0",
    "Boundary conditions/upper top/y condition=traction",
    "Boundary conditions/upper top/y value=-1e4 * t",
    "Gravity/Acceleration=9.81",
    "TNNMG/Tolerance=1e-12",
    "Time/Step size control=constant",
    "Time/Largest step=1e-3",
    "Time/End time=0.05"};
  for (const std::string body : {"upper", "lower"})
    for (const std::string entry : {"Uniform refinements=2",
                                    "Refinement passes=0",
                                    "Material/Shear viscosity=2e3",
                                    "Material/Bulk viscosity=0"})
      two.push_back("Bodies/" + body + "/" + entry);
  Simulation<2> halves(read_scene(creeping_bodies, two), MPI_COMM_WORLD);
  run(halves);

  const auto expected = values_on_side(whole, 0, 3);
  const auto found    = values_on_side(halves, 1, 3);
  ASSERT_EQ(expected.size(), 17u);
  ASSERT_EQ(found.size(), 17u);
  double largest = 0.;
  for (const auto &[x, u] : expected)
    largest = std::max(largest, u.norm());
  EXPECT_GT(largest, 1e-4);
  for (const auto &[x, u] : expected)
    EXPECT_LT((found.at(x) - u).norm(), 1e-8 * largest) << x;
  for (const Tensor<1, 1> &V : halves.state().slip_rate)
    EXPECT_EQ(V[0], 0.);
  // The weld carries the load.
  const FaultSnapshot<2> fault = snapshots(halves).front();
  EXPECT_GT(mean(fault, fault.shear_traction), 100.);
}



TEST(PrescribedSlip, IsThatOfTheUpperSideWhicheverIsTheSlave)
{
  // Both outer sides are held: the shear stress is that of the slip over both
  // layers, which resists a slip to the right.
  for (const bool lower_is_softer : {false, true})
    {
      const EndlessLayers scene = layers(lower_is_softer);
      Simulation<2>       simulation(
        read_scene(scene.text(),
                   {"Faults/fault/Friction=prescribed slip rate",
                          "Faults/fault/Slip rate along x=2e-3",
                          "Faults/fault/Slip rate ramp length=1",
                          "TNNMG/Tolerance=1e-12",
                          "Time/Inertia=quasi-static",
                          "Time/Largest step=0.25",
                          "Time/End time=3"}),
        MPI_COMM_WORLD);
      run(simulation);
      const FaultSnapshot<2> fault = snapshots(simulation).front();
      // The ramp costs half of its length.
      const double slip = 2e-3 * 2.5;
      // Resistance is negative: the layers pull back.
      const double traction = -slip / (1. / scene.material[0].shear_modulus() +
                                       1. / scene.material[1].shear_modulus());
      for (unsigned int k = 0; k < fault.slip.size(); ++k)
        {
          EXPECT_NEAR(fault.slip_rate[k][0], 2e-3, 1e-17) << k;
          EXPECT_NEAR(fault.slip[k][0], slip, 1e-3 * slip) << k;
          EXPECT_NEAR(fault.shear_traction[k][0] / traction,
                      fault.slip[k][0] / slip,
                      1e-6)
            << k;
        }
      EXPECT_EQ(event_start_slip_rate(
                  read_scene(scene.text(),
                             {"Faults/fault/Friction=prescribed slip rate",
                              "Faults/fault/Slip rate along x=2e-3"})),
                4e-3);
      // The force that keeps the slip going puts the energy into the layers.
      const EnergyBalance<2> &energy = *simulation.energy_balance();
      EXPECT_NEAR(energy.work().driven_sides,
                  energy.elastic_energy(simulation.state()),
                  1e-3 * energy.work().driven_sides);
      EXPECT_NEAR(energy.elastic_energy(simulation.state()),
                  -0.5 * traction * slip * scene.length,
                  -2e-3 * traction * slip);
    }
}



TEST(PrescribedSlip, OnAPartOfTheFaultLeavesFrictionToTheRest)
{
  // The outer parts of the fault creep with the plate; the middle, which
  // strengthens with the slip rate, must follow, more and more loaded.
  Simulation<2> simulation(
    read_scene(creeping_bodies,
               {"Faults/fault/Friction=velocity strengthening",
                "Faults/fault/Reference friction coefficient=0.6",
                "Faults/fault/Regions/Names=ends",
                "Faults/fault/Regions/ends/Where=abs(x) > 0.5",
                "Faults/fault/Regions/ends/Friction=prescribed slip rate",
                "Faults/fault/Regions/ends/Slip rate along x=1e-3",
                "Faults/fault/Regions/ends/Slip rate ramp length=1",
                "Faults/fault/Initial state=1",
                "Time/End time=6"}),
    MPI_COMM_WORLD);
  run(simulation);
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  for (unsigned int k = 0; k < fault.slip.size(); ++k)
    {
      const double x = fault.points[k][0], V = std::abs(fault.slip_rate[k][0]);
      if (std::abs(x) > 0.5)
        EXPECT_EQ(V, 1e-3) << x;
      else
        // Friction and slip rate belong together, with
        // mu = a asinh(V/(2 V0) exp(mu0/a)).
        EXPECT_NEAR(std::abs(fault.shear_traction[k][0]) / 2e4,
                    0.02 * (std::log(V / 1e-3) + 0.6 / 0.02),
                    1e-6)
          << x;
    }
  // The middle has come to slide as fast as the ends let it.
  const unsigned int middle =
    std::min_element(fault.points.begin(),
                     fault.points.end(),
                     [](const Point<2> &p, const Point<2> &q) {
                       return std::abs(p[0]) < std::abs(q[0]);
                     }) -
    fault.points.begin();
  EXPECT_NEAR(fault.slip_rate[middle][0], 1e-3, 1e-4);
  EXPECT_LT(std::abs(simulation.energy_balance()->defect(simulation.state())),
            1e-3 * simulation.energy_balance()->work().friction);
}



TEST(Regions, RunTheSameWithEachRateSolverAndCorrection)
{
  // One fault with all kinds of friction.
  const auto slips = [](const std::vector<std::string> &more) {
    Simulation<2> simulation(
      read_scene(creeping_bodies,
                 std::vector<std::string>{
                   "Faults/fault/Regions/Names=a, b, c, d, e",
                   "Faults/fault/Regions/a/Where=x < -0.6",
                   "Faults/fault/Regions/a/Friction=welded",
                   "Faults/fault/Regions/b/Where=x > -0.6 && x < -0.2",
                   "Faults/fault/Regions/b/Friction=Coulomb",
                   "Faults/fault/Regions/b/Reference friction coefficient=0.1",
                   "Faults/fault/Regions/c/Where=x > 0 && x < 0.3",
                   "Faults/fault/Regions/c/Friction=frictionless",
                   "Faults/fault/Regions/d/Where=x > 0.3 && x < 0.6",
                   "Faults/fault/Regions/d/Friction=velocity strengthening",
                   "Faults/fault/Regions/e/Where=x > 0.6",
                   "Faults/fault/Regions/e/Friction=prescribed slip rate",
                   "Faults/fault/Regions/e/Slip rate along x=1e-3",
                   "Faults/fault/Regions/e/Slip rate ramp length=1",
                   "TNNMG/Tolerance=1e-11",
                   "Time/Rate-state tolerance=1e-11",
                   "Time/Step size control=constant",
                   "Time/Largest step=0.02",
                   "Time/End time=1"} +
                   more),
      MPI_COMM_WORLD);
    run(simulation);
    const FaultSnapshot<2>   fault = snapshots(simulation).front();
    std::map<double, double> result;
    for (unsigned int k = 0; k < fault.slip.size(); ++k)
      result[fault.points[k][0]] = fault.slip[k][0];
    return result;
  };
  const std::map<double, double> expected = slips({});
  EXPECT_EQ(expected.at(-0.75), 0.);
  EXPECT_GT(expected.at(0.125), 1e-5);
  EXPECT_GT(expected.at(0.75), 4e-4);
  for (const std::string other : {"Time/Rate solver=condensed Newton",
                                  "TNNMG/Linear correction=UMFPACK",
                                  "TNNMG/Linear correction=MUMPS",
                                  "Time/Rate-state method=nested"})
    {
      const std::map<double, double> found = slips({other});
      for (const auto &[x, slip] : expected)
        EXPECT_NEAR(found.at(x), slip, 1e-9) << other << " at " << x;
    }
}
