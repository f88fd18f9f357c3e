// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct Account
  {
    EnergyTerms work;
    double      defect = 0, energy = 0;
    unsigned    n_mappings = 0;
  };



  Account
  run(const SceneParameters<2> &scene)
  {
    Simulation<2> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    const EnergyBalance<2> &balance = *simulation.energy_balance();
    Account                 account;
    account.work   = balance.work();
    account.defect = balance.defect(simulation.state());
    account.energy = balance.kinetic_energy(simulation.state()) +
                     balance.elastic_energy(simulation.state());
    account.n_mappings = simulation.counts().contact_mappings;
    return account;
  }
} // namespace



namespace
{
  /** With everything that does work: a driven side, a traction, weight,
   * viscosity, friction. */
  void
  expect_exact_balance(const std::vector<std::string> &entries)
  {
    for (const std::string inertia :
         {"dynamic", "quasi-dynamic", "quasi-static"})
      for (const double tau : {0.02, 0.005})
        {
          std::vector<std::string> overrides = {
            "Time/Inertia=" + inertia,
            "Time/Step size control=constant",
            "Time/Largest step=" + std::to_string(tau),
            "Time/Rate-state tolerance=1e-12",
            "TNNMG/Tolerance=1e-12",
            "Gravity/Acceleration=9.81",
            "Boundary conditions/upper top/x value=4e-3*t^4",
            "Boundary conditions/upper top/y condition=traction",
            "Boundary conditions/upper top/y value=-1e4*t^4",
            "Boundary conditions/upper top/Ramp length=0",
            "Output/Event start slip rate=1"};
          overrides.insert(overrides.end(), entries.begin(), entries.end());
          const Account account   = run(read_scene(creeping_bodies, overrides));
          const EnergyTerms &work = account.work;
          std::cout << inertia << ", tau = " << tau << " s: loads "
                    << work.loads << ", driven sides " << work.driven_sides
                    << ", viscosity " << work.viscosity << ", friction "
                    << work.friction << ", radiation " << work.radiation
                    << ", defect " << account.defect << '\n';
          double largest = 0.;
          for (const double term :
               {work.loads, work.driven_sides, work.viscosity, work.friction})
            {
              EXPECT_GT(std::abs(term), 1e6 * std::abs(account.defect));
              largest = std::max(largest, std::abs(term));
            }
          EXPECT_LT(std::abs(account.defect), 1e-10 * largest);
        }
  }
} // namespace



TEST(Energy, BalanceIsExact)
{
  expect_exact_balance({});
  expect_exact_balance(
    {"Bodies/lower/Material/Young modulus=4.12e7*(1.5 + x)",
     "Bodies/lower/Material/Density=5e3*(1 - y)",
     "Bodies/upper/Material/Shear viscosity=2e5*exp(x)",
     "Bodies/upper/Material/Poisson ratio=0.25 + 0.1*x*y",
     "Bodies/upper/Material/Bulk viscosity=if(x < 0.3, 0, 4e5)"});
}



TEST(Energy, StuckBodiesKeepWhatTheyAreGiven)
{
  // Slowly sheared, without viscosity: 1/2 G gamma^2 in each cubic metre but
  // near the ends.
  const Account account =
    run(published_scene("spring_slider",
                        {"Time/End time=10",
                         "Bodies/lower/Material/Shear viscosity=0",
                         "Bodies/lower/Material/Bulk viscosity=0",
                         "Bodies/upper/Material/Shear viscosity=0",
                         "Bodies/upper/Material/Bulk viscosity=0"}));
  EXPECT_EQ(account.work.viscosity, 0.);
  EXPECT_LT(account.work.friction, 1e-6 * account.work.driven_sides);
  EXPECT_LT(std::abs(account.defect), 1e-4 * account.work.driven_sides);
  const double gamma = 2e-4 * 9.5 / 2., shear_modulus = 4.12e7 / 2.6;
  const double sheared = 10. * 0.5 * shear_modulus * gamma * gamma;
  EXPECT_LT(account.work.driven_sides, sheared);
  EXPECT_GT(account.work.driven_sides, 0.7 * sheared);
}



TEST(Energy, EventsAreAccountedForAsExactlyAsTheyAreResolved)
{
  // Through the first event.
  const std::string end    = "Time/End time=22.6";
  const Account     coarse = run(published_scene("spring_slider", {end}));
  const Account     fine =
    run(published_scene("spring_slider", {end, "Time/Tolerance=3e-7"}));
  std::cout << "defects " << coarse.defect << " and " << fine.defect
            << " J/m, dissipated by friction " << coarse.work.friction
            << " J/m\n";
  EXPECT_GT(coarse.work.friction, 1.);
  EXPECT_LT(std::abs(coarse.defect), 1e-5 * coarse.work.friction);
  EXPECT_LT(std::abs(fine.defect), std::abs(coarse.defect));
}



TEST(Energy, ANewContactMappingTakesLittle)
{
  const auto run_with = [](const std::string &fraction) {
    return run(published_scene("spring_slider",
                               {"Time/End time=22.6",
                                "Contact/Rebuild fraction=" + fraction}));
  };
  const Account one = run_with("1"), many = run_with("1e-3");
  const double  taken = many.defect - one.defect;
  std::cout << many.n_mappings << " mappings take " << taken
            << " J/m, dissipated by friction " << many.work.friction
            << " J/m\n";
  EXPECT_EQ(one.n_mappings, 1u);
  EXPECT_GT(many.n_mappings, 15u);
  EXPECT_LT(std::abs(taken), 3e-7 * many.work.friction);
}
