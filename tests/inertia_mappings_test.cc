// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>

#include "creeping_of_any_dimension.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Settings = std::vector<std::string>;

  const Settings cells_in_the_plane = {"Bodies/lower/Coarse cells=4, 1",
                                       "Bodies/upper/Coarse cells=4, 1"};

  const Settings cells_in_space = {"Bodies/lower/Coarse cells=4, 2, 1",
                                   "Bodies/upper/Coarse cells=3, 2, 1",
                                   "Bodies/lower/Refinement passes=1",
                                   "Bodies/upper/Refinement passes=1"};

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
    /** Energy that contact mappings have added, and that is missing, over the
     * largest work. */
    double added = 0., missing = 0.;
    /** Of the upper body along the fault, at 0.2 s and at the end. */
    double       pushed = 0., momentum = 0.;
    unsigned int mappings = 0;
  };



  template <int dim>
  Outcome
  run(std::vector<Settings> settings)
  {
    settings.push_back(dim == 2 ? in_the_plane : in_space);
    settings.push_back(dim == 2 ? cells_in_the_plane : cells_in_space);
    settings.push_back(steps_of_a_centisecond);
    Simulation<dim> simulation(creeping_bodies_with<dim>(settings),
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
    outcome.added    = balance.work().mappings / balance.work().largest();
    std::cout << outcome.mappings << " mappings, energy added " << outcome.added
              << ", missing " << outcome.missing << ", momentum "
              << outcome.pushed << " and " << outcome.momentum << '\n';
    return outcome;
  }



  template <int dim>
  void
  expect_momentum_and_energy()
  {
    const auto run_with = [](const std::string &fraction) {
      return run<dim>({gliding(dim), {"Contact/Rebuild fraction=" + fraction}});
    };
    const Outcome coarse = run_with("0.25"), fine = run_with("0.0625");
    EXPECT_GT(coarse.mappings, 4u);
    EXPECT_GT(fine.mappings, 3 * coarse.mappings);
    // Integral of the traction over the push, on 2 m (2 m x 1 m).
    EXPECT_NEAR(coarse.pushed, 2. * 0.2 * 3125., 1e-3);
    EXPECT_NEAR(coarse.momentum, coarse.pushed, 3e-5 * coarse.pushed);
    EXPECT_NEAR(fine.momentum, fine.pushed, 3e-5 * coarse.pushed);
    // Partners that go on between mappings are of second order.
    EXPECT_LT(std::abs(coarse.added), 2e-3);
    EXPECT_LT(std::abs(fine.added), std::abs(coarse.added) / 10.);
    EXPECT_LT(std::abs(coarse.missing), 1e-6);
    EXPECT_LT(std::abs(fine.missing), 1e-6);
  }
} // namespace



TEST(Mappings, KeepMomentumAndEnergyInThePlane)
{
  expect_momentum_and_energy<2>();
}



TEST(Mappings, KeepMomentumAndEnergyInSpace)
{
  expect_momentum_and_energy<3>();
}



TEST(Mappings, KeepTheEnergyWithAnyInertia)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic", "quasi-static"})
    {
      SCOPED_TRACE(inertia);
      const std::vector<Settings> settings = {pulled,
                                              {"Time/Inertia=" + inertia}};
      const Outcome plane = run<2>(settings), space = run<3>(settings);
      EXPECT_GT(plane.mappings, 8u);
      EXPECT_GT(space.mappings, 3u);
      EXPECT_LT(std::abs(plane.added), 1e-3);
      EXPECT_LT(std::abs(space.added), 1e-2);
      for (const Outcome &outcome : {plane, space})
        EXPECT_LT(std::abs(outcome.missing), 1e-6);
    }
}



// Friction that grows linearly with the slip rate says at once what a contact
// mapping does to the balance of forces.
TEST(Mappings, DoNotJolt)
{
  for (const std::string inertia : {"dynamic", "quasi-static"})
    {
      SCOPED_TRACE(inertia);
      Simulation<2> simulation(
        creeping_bodies_with<2>(
          {in_the_plane,
           cells_in_the_plane,
           steps_of_a_centisecond,
           pulled,
           {"Time/Inertia=" + inertia,
            "Time/End time=3",
            "Faults/fault/Friction=velocity strengthening",
            "Faults/fault/Regularisation=arcsinh",
            "Faults/fault/Normal stress function=1e5",
            "Faults/fault/Reference friction coefficient=0",
            "Faults/fault/a=0.6"}}),
        MPI_COMM_WORLD);
      simulation.set_up();
      unsigned int n_mappings = 0;
      double       largest    = 0.;
      while (!simulation.is_finished())
        {
          const unsigned int n_before = simulation.counts().contact_mappings;
          simulation.advance();
          if (simulation.counts().contact_mappings == n_before ||
              simulation.state().time < 1. || simulation.is_finished())
            continue;
          ++n_mappings;
          const std::vector<Tensor<1, 1>> before = simulation.state().slip_rate;
          simulation.advance();
          for (unsigned int k = 0; k < before.size(); ++k)
            if (simulation.fault_nodes().in_contact(k) && before[k].norm() > 0.)
              largest =
                std::max(largest,
                         (simulation.state().slip_rate[k] - before[k]).norm() /
                           before[k].norm());
        }
      std::cout << n_mappings << " mappings change slip rates by up to "
                << largest << " in a step\n";
      EXPECT_GT(n_mappings, 5u);
      // Without the PartnerForce by 0.02.
      EXPECT_LT(largest, 5e-3);
    }
}
