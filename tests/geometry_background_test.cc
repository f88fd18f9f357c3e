// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "endless_layers.h"
#include "error_message.h"
#include "kinds_scenes.h"
#include "turned_layers.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * A stress that acts on faults only, against the same stress in the bodies and
 * against closed forms.
 */

namespace
{
  constexpr double shear_load = 5.5e3;

  /** Layers without ends, sheared by a traction on top that changes, with
   * friction that is not the same everywhere. */
  SceneParameters<2>
  sheared_layers(const Settings &more)
  {
    EndlessLayers scene;
    scene.thickness                    = {{0.5, 0.5}};
    scene.coarse_cells                 = {{{{6, 2}}, {{8, 2}}}};
    scene.length                       = 1.;
    scene.friction.reference_friction  = 0.6;
    scene.friction.reference_slip_rate = 1e-3;
    scene.friction.a                   = 0.02;
    scene.friction.b                   = 0.01;
    scene.friction.characteristic_slip = 1e-4;
    scene.velocity                     = 1e-3;
    for (Material &material : scene.material)
      {
        material.youngs_modulus  = 4e7;
        material.shear_viscosity = material.bulk_viscosity = 1e3;
      }
    return read_scene(scene.text(),
                      Settings{"Faults/fault/Initial state=0.1 + 0.05 * "
                               "cos(6.283185307179586 * x)",
                               "Boundary conditions/upper top/x condition="
                               "traction",
                               "Time/Step size control=constant",
                               "Time/End time=0.2",
                               "Time/Largest step=2e-3",
                               "Time/Rate-state tolerance=1e-10",
                               "TNNMG/Tolerance=1e-11",
                               "Output/Event start slip rate=1"} +
                        more);
  }



  /** Equality of two runs: with a background stress alone, and with the same
   * shear stress in the bodies and a given normal stress. */
  void
  expect_equivalent(const Settings &more, const double tolerance = 1e-7)
  {
    const std::string load = "1e3 * sin(20 * t)";
    Simulation<2>     in_bodies(
      sheared_layers(more +
                     Settings{"Faults/fault/Normal stress function=1e4",
                              "Boundary conditions/upper top/x value=" + load +
                                " + " + std::to_string(shear_load)}),
      MPI_COMM_WORLD);
    Simulation<2> on_fault(
      sheared_layers(more +
                     Settings{"Faults/fault/Normal stress function=4e3",
                              "Faults/fault/Background stress=-1e6, -6e3, " +
                                std::to_string(shear_load),
                              "Boundary conditions/upper top/x value=" + load}),
      MPI_COMM_WORLD);
    run(in_bodies);
    run(on_fault);
    ASSERT_EQ(in_bodies.counts().accepted, on_fault.counts().accepted);
    EXPECT_NEAR(on_fault.state().time, in_bodies.state().time, 1e-9);
    const FaultSnapshot<2> a = snapshots(in_bodies).front(),
                           b = snapshots(on_fault).front();
    const double slip = mean(a, a.slip), rate = mean(a, a.slip_rate);
    for (unsigned int k = 0; k < a.points.size(); ++k)
      {
        EXPECT_NEAR(b.normal_stress[k], 1e4, 1e-9);
        EXPECT_NEAR(b.slip[k][0], a.slip[k][0], tolerance * slip);
        EXPECT_NEAR(b.slip_rate[k][0],
                    a.slip_rate[k][0],
                    tolerance * std::abs(rate));
        EXPECT_NEAR(b.shear_traction[k][0],
                    a.shear_traction[k][0],
                    tolerance * shear_load);
      }
    const double scale = in_bodies.energy_balance()->work().friction;
    EXPECT_GT(slip, 1e-6);
    EXPECT_NEAR(on_fault.energy_balance()->work().friction,
                scale,
                tolerance * scale);
    std::cout << "slip " << slip << " m, dissipated " << scale
              << " J/m, defects "
              << in_bodies.energy_balance()->defect(in_bodies.state())
              << " and " << on_fault.energy_balance()->defect(on_fault.state())
              << " J/m\n";
    for (Simulation<2> *simulation : {&in_bodies, &on_fault})
      EXPECT_LT(std::abs(
                  simulation->energy_balance()->defect(simulation->state())),
                1e-2 * scale);
  }
} // namespace



TEST(BackgroundStress, IsThatOfBodiesWithInertia)
{
  expect_equivalent({});
  expect_equivalent({"Faults/fault/Friction=velocity strengthening",
                     "Faults/fault/Normal stress follows=true"});
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    expect_equivalent({"Time/Rate solver=condensed Newton"});
}



TEST(BackgroundStress, IsThatOfBodiesWithoutInertia)
{
  expect_equivalent({"Time/Inertia=quasi-dynamic"});
  expect_equivalent({"Time/Inertia=quasi-dynamic",
                     "Faults/fault/Friction=Coulomb",
                     "Faults/fault/Reference friction coefficient=0.5"});
}



TEST(BackgroundStress, IsCarriedByWhatIsWeldedOrPrescribed)
{
  for (const std::string friction : {"welded", "prescribed slip rate"})
    {
      Simulation<2> simulation(
        sheared_layers({"Faults/fault/Friction=" + friction,
                        "Faults/fault/Background stress=0, -1e4, 5500",
                        "Boundary conditions/upper top/x value=1e3 * t",
                        "Faults/fault/Slip rate along x=1e-9",
                        "Time/Inertia=quasi-static"}),
        MPI_COMM_WORLD);
      run(simulation);
      const FaultSnapshot<2> fault = snapshots(simulation).front();
      for (const Tensor<1, 1> &traction : fault.shear_traction)
        EXPECT_NEAR(traction[0], 5700., 1e-5) << friction;
    }
}



namespace
{
  /** A layered scene with a fault that dips, at the start. */
  FaultSnapshot<2>
  dipping_fault(const double angle, const Settings &more)
  {
    const TemporaryFolder folder;
    folder.write("layers.msh",
                 turned_layers(angle, Cells::quadrilaterals).text());
    Simulation<2> simulation(
      SceneReader(folder.write("layers.prm", turned_scene(angle)),
                  Settings{"Gravity/Acceleration=0",
                           "Faults/fault/Normal stress=initial equilibrium",
                           "Output/Event start slip rate=1"} +
                    more)
        .read<2>(),
      MPI_COMM_WORLD);
    simulation.set_up();
    return snapshots(simulation).front();
  }
} // namespace



TEST(BackgroundStress, UniformOnAFaultThatDips)
{
  const double angle = numbers::PI / 6., s = std::sin(angle),
               c = std::cos(angle);
  // The normal is (-s, c), the tangent (c, s).
  const FaultSnapshot<2> uniaxial =
    dipping_fault(angle, {"Faults/fault/Background stress=-8e4, 0, 0"});
  const FaultSnapshot<2> general =
    dipping_fault(angle, {"Faults/fault/Background stress=-8e4, -5e4, 1e4"});
  for (unsigned int k = 0; k < uniaxial.points.size(); ++k)
    {
      EXPECT_NEAR(uniaxial.normal_stress[k], 8e4 * s * s, 1e-7);
      EXPECT_NEAR(uniaxial.shear_traction[k][0], 8e4 * s * c, 1e-7);
      EXPECT_NEAR(general.normal_stress[k],
                  8e4 * s * s + 5e4 * c * c + 2e4 * s * c,
                  1e-7);
      EXPECT_NEAR(general.shear_traction[k][0],
                  3e4 * s * c + 1e4 * (c * c - s * s),
                  1e-7);
    }
}



TEST(BackgroundStress, DependsOnThePosition)
{
  const FaultSnapshot<2> fault =
    dipping_fault(0.,
                  {"Faults/fault/Background stress="
                   "0, if(x > 0, -2e4, -1e4 * (1 + x^2)), 1e3 * x"});
  for (unsigned int k = 0; k < fault.points.size(); ++k)
    {
      const double x = fault.points[k][0];
      EXPECT_NEAR(fault.normal_stress[k],
                  x > 0. ? 2e4 : 1e4 * (1. + x * x),
                  1e-7);
      EXPECT_NEAR(fault.shear_traction[k][0], 1e3 * x, 1e-7);
    }
}



// A table of a function that is linear between its points is that function.
TEST(BackgroundStress, IsThatOfATable)
{
  const TemporaryFolder folder;
  const std::string     table =
    folder.write("stress.txt", "x\n-100 -101e3\n0 -1e3\n100 -201e3\n");
  const auto stress = [&](const std::string &syy) {
    return dipping_fault(0.,
                         {"Faults/fault/Background stress=0, " + syy +
                          ", 500"});
  };
  const FaultSnapshot<2> by_table = stress("table " + table),
                         by_expression =
                           stress("-1e3 + if(x < 0, 1e3, -2e3) * x");
  for (unsigned int k = 0; k < by_table.points.size(); ++k)
    {
      EXPECT_GT(by_table.normal_stress[k], 999.);
      EXPECT_NEAR(by_table.normal_stress[k],
                  by_expression.normal_stress[k],
                  1e-7);
    }
}



TEST(BackgroundStress, VariesAlongAFaultThatBends)
{
  // The disc in a ring: the normal is along the radius.
  const TemporaryFolder folder;
  std::filesystem::copy(STICKSLIP_SOURCE_DIR "/tests/meshes/ring.msh",
                        folder.file("ring.msh"));
  const std::string text = R"(
subsection Bodies
  set Names     = disc, ring
  set Mesh file = ring.msh
end
subsection Faults
  set Names = fault
  subsection fault
    set Between           = disc, ring
    set Background stress = -1e4, -3e4, 2e3
  end
end
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Output
  set Event start slip rate = 1
end
)";
  Simulation<2>     simulation(
    SceneReader(folder.write("ring.prm", text)).read<2>(), MPI_COMM_WORLD);
  simulation.set_up();
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  double                 error = 0;
  for (unsigned int k = 0; k < fault.points.size(); ++k)
    {
      const Tensor<1, 2> n = fault.points[k] / fault.points[k].norm();
      const double       normal_stress =
        1e4 * n[0] * n[0] + 3e4 * n[1] * n[1] - 4e3 * n[0] * n[1];
      // Along (n_y, -n_x).
      const double shear =
        2e4 * n[0] * n[1] + 2e3 * (n[1] * n[1] - n[0] * n[0]);
      error = std::max(error, std::abs(fault.normal_stress[k] - normal_stress));
      error = std::max(error, std::abs(fault.shear_traction[k][0] - shear));
    }
  std::cout << fault.points.size() << " nodes, largest error " << error
            << " Pa\n";
  EXPECT_LT(error, 1e-6);
}



TEST(BackgroundStress, IsThereWhenARunGoesOn)
{
  const TemporaryFolder    folder;
  const SceneParameters<2> scene =
    sheared_layers({"Faults/fault/Background stress=0, -1e4, 5500 + 100 * x",
                    "Boundary conditions/upper top/x value=1e3 * sin(20 * t)",
                    "Time/End time=0.02"});
  Simulation<2> kept(scene, MPI_COMM_WORLD), resumed(scene, MPI_COMM_WORLD);
  kept.set_up();
  for (unsigned int step = 0; step < 5; ++step)
    kept.advance();
  kept.write_state(folder.file("state"));
  resumed.resume(folder.file("state"));
  finish(kept);
  finish(resumed);
  const FaultSnapshot<2> a = snapshots(kept).front(),
                         b = snapshots(resumed).front();
  for (unsigned int k = 0; k < a.points.size(); ++k)
    {
      EXPECT_EQ(b.slip_rate[k][0], a.slip_rate[k][0]);
      EXPECT_EQ(b.shear_traction[k][0], a.shear_traction[k][0]);
    }
  EXPECT_EQ(resumed.energy_balance()->work().loads,
            kept.energy_balance()->work().loads);
}



TEST(BackgroundStress, ErrorsAreInOneSentence)
{
  const auto message = [](const std::string &stress) {
    return message_of([&]() {
      dipping_fault(0., {"Faults/fault/Background stress=" + stress});
    });
  };
  const std::string entry = "Faults/fault/Background stress";
  for (const std::string text : {"1, 2", "1, 2,", "1, 2, 3, 4"})
    expect_one_sentence_with(
      message(text),
      {entry,
       "must be nothing, or 3 components, each a number, an expression in x, y "
       "(z), or table FILE, separated by commas: sxx, syy, sxy"});
  expect_one_sentence_with(message("1, -2, table nowhere.txt"),
                           {entry, "nowhere.txt"});
  expect_one_sentence_with(message("1, -2, x +"),
                           {entry + " (sxy)' = '1, -2, x +'",
                            "cannot be used"});
  expect_one_sentence_with(message("0, 1e3 * x, 0"),
                           {entry, "pulls the fault apart at ("});
}
