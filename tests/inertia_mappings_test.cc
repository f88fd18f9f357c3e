// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>

#include "creeping_scene.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Settings = std::vector<std::string>;

  const Settings in_the_plane = {"Bodies/lower/Lower lateral corner=-1",
                                 "Bodies/upper/Lower lateral corner=-1",
                                 "Bodies/lower/Upper lateral corner=1",
                                 "Bodies/upper/Upper lateral corner=1",
                                 "Bodies/lower/Coarse cells=4, 1",
                                 "Bodies/upper/Coarse cells=4, 1"};

  const Settings in_space = {"Dimension=3",
                             "Bodies/lower/Lower lateral corner=-1, 0",
                             "Bodies/upper/Lower lateral corner=-1, 0",
                             "Bodies/lower/Upper lateral corner=1, 1",
                             "Bodies/upper/Upper lateral corner=1, 1",
                             "Bodies/lower/Coarse cells=4, 2, 1",
                             "Bodies/upper/Coarse cells=3, 2, 1",
                             "Bodies/lower/Refinement passes=1",
                             "Bodies/upper/Refinement passes=1",
                             "Boundary conditions/lower bottom/z "
                             "condition=fixed"};

  const Settings steps_of_a_centisecond = {"Time/Step size control=constant",
                                           "Time/Largest step=0.01",
                                           "TNNMG/Tolerance=1e-8",
                                           "Time/Rate-state tolerance=1e-8",
                                           "Output/Event start slip rate=1"};

  /** The upper body, pressed on and free to slide: pushed to the right within
   * 0.2 s, it glides on by several faces, without friction. */
  Settings
  gliding(const int dim)
  {
    const std::string top = "Boundary conditions/upper top/",
                      up  = top + (dim == 2 ? "y" : "z");
    return {top + "x condition=traction",
            top + "x value=if(t < 0.2, 3125*(1 - cos(10*pi*t)), 0)",
            up + " condition=traction",
            up + " value=-1e4",
            top + "Ramp length=0",
            "Faults/fault/Friction=frictionless",
            "Time/End time=2"};
  }

  /** The upper body, pulled along at 0.25 m/s against friction. */
  const Settings pulled = {"Boundary conditions/upper top/x value=0.25",
                           "Boundary conditions/upper top/Ramp length=0.2",
                           "Faults/fault/Reference slip rate=0.25",
                           "Faults/fault/Characteristic slip=0.25",
                           "Faults/fault/Normal stress function=1e3",
                           "Time/End time=2"};



  struct Outcome
  {
    /** Energy that is missing, over the largest work. */
    double missing = 0.;
    /** Of the upper body along the fault, at 0.2 s and at the end. */
    double       pushed = 0., momentum = 0.;
    unsigned int mappings = 0;
  };



  template <int dim>
  Outcome
  run(const std::vector<Settings> &settings)
  {
    Settings overrides;
    for (const Settings &more : settings)
      overrides.insert(overrides.end(), more.begin(), more.end());
    const TemporaryFolder folder;
    Simulation<dim>       simulation(
      SceneReader(folder.write("scene.prm", creeping_bodies_of_any_dimension()),
                  overrides)
        .template read<dim>(),
      MPI_COMM_WORLD);
    simulation.set_up();
    Outcome outcome;
    while (!simulation.is_finished())
      {
        simulation.advance();
        if (simulation.state().acceleration.size() == 0)
          continue;
        const auto                &level = simulation.meshes().finest();
        const std::vector<double> &masses =
          simulation.spatial_problem().nodal_masses();
        outcome.momentum = 0.;
        for (unsigned int node = level.node(1, 0); node < masses.size(); ++node)
          outcome.momentum +=
            masses[node] *
            simulation.state().velocity.local_element(dim * node);
        if (simulation.state().time < 0.205)
          outcome.pushed = outcome.momentum;
      }
    const EnergyBalance<dim> &balance = *simulation.energy_balance();
    outcome.missing =
      balance.defect(simulation.state()) / balance.work().largest();
    outcome.mappings = simulation.counts().contact_mappings;
    std::cout << outcome.mappings << " mappings, energy missing "
              << outcome.missing << ", momentum " << outcome.pushed << " and "
              << outcome.momentum << '\n';
    return outcome;
  }



  template <int dim>
  void
  expect_momentum_and_energy(const Settings &space)
  {
    const auto run_with = [&](const std::string &fraction) {
      return run<dim>({space,
                       steps_of_a_centisecond,
                       gliding(dim),
                       {"Contact/Rebuild fraction=" + fraction}});
    };
    const Outcome coarse = run_with("0.25"), fine = run_with("0.0625");
    EXPECT_GT(coarse.mappings, 4u);
    EXPECT_GT(fine.mappings, 3 * coarse.mappings);
    // Integral of the traction over the push, on 2 m (2 m x 1 m).
    EXPECT_NEAR(coarse.pushed, 2. * 0.2 * 3125., 1e-3);
    EXPECT_NEAR(coarse.momentum, coarse.pushed, 3e-5 * coarse.pushed);
    EXPECT_NEAR(fine.momentum, fine.pushed, 3e-5 * coarse.pushed);
    EXPECT_LT(std::abs(coarse.missing), 1e-3);
    EXPECT_LT(std::abs(fine.missing), std::abs(coarse.missing));
  }
} // namespace



TEST(Mappings, KeepMomentumAndEnergyInThePlane)
{
  expect_momentum_and_energy<2>(in_the_plane);
}



TEST(Mappings, KeepMomentumAndEnergyInSpace)
{
  expect_momentum_and_energy<3>(in_space);
}



TEST(Mappings, KeepTheEnergyWithAnyInertia)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic", "quasi-static"})
    {
      SCOPED_TRACE(inertia);
      const Outcome plane = run<2>({in_the_plane,
                                    steps_of_a_centisecond,
                                    pulled,
                                    {"Time/Inertia=" + inertia}});
      EXPECT_GT(plane.mappings, 8u);
      EXPECT_LT(std::abs(plane.missing), 1e-3);
      const Outcome space = run<3>({in_space,
                                    steps_of_a_centisecond,
                                    pulled,
                                    {"Time/Inertia=" + inertia}});
      EXPECT_GT(space.mappings, 3u);
      EXPECT_LT(std::abs(space.missing), 1e-3);
    }
}
