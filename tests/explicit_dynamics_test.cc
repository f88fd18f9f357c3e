// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "antiplane_scenes.h"
#include "column_scenes.h"
#include "creeping_of_any_dimension.h"
#include "simulation_scenes.h"
#include "slip_rate_series.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const Settings central_differences = {
    "Time/Step size control=central differences"};

  /** Steps that no error cuts. */
  const Settings of_one_size = {"Time/Tolerance=1e9",
                                "Time/Body tolerance=1e9"};



  template <int dim, int n_components = dim>
  void
  run(Simulation<dim, n_components> &simulation)
  {
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
  }



  /** With everything that does work, and nodes that do not face each other. */
  template <int dim, int n_components>
  void
  expect_exact_balance(const SceneParameters<dim> &scene)
  {
    Simulation<dim, n_components> simulation(scene, MPI_COMM_WORLD);
    run(simulation);
    const auto        &balance = *simulation.energy_balance();
    const EnergyTerms &work    = balance.work();
    const double       defect  = balance.defect(simulation.state()),
                 kinetic       = balance.kinetic_energy(simulation.state());
    std::cout << simulation.counts().accepted << " steps, loads " << work.loads
              << ", driven sides " << work.driven_sides << ", viscosity "
              << work.viscosity << ", friction " << work.friction
              << ", kinetic energy " << kinetic << ", defect " << defect
              << '\n';
    for (const double term :
         {work.driven_sides, work.viscosity, work.friction, kinetic})
      EXPECT_GT(std::abs(term), 1e6 * std::abs(defect));
    EXPECT_LT(std::abs(defect), 1e-10 * work.largest());
  }



  Settings
  loaded(const int dim, const double tau)
  {
    const std::string up = dim == 2 ? "y" : "z";
    return of_one_size + central_differences +
           Settings{"Time/Initial step=" + std::to_string(tau),
                    "Time/Largest step=" + std::to_string(tau),
                    "Time/End time=0.6",
                    "Gravity/Acceleration=9.81",
                    "Boundary conditions/upper top/x value=4e-3*t^4",
                    "Boundary conditions/upper top/" + up +
                      " condition=traction",
                    "Boundary conditions/upper top/" + up + " value=-1e4*t^4",
                    "Boundary conditions/upper top/Ramp length=0",
                    "Time/Loading tolerance=1e9",
                    "Output/Event start slip rate=1"};
  }



  constexpr double loading_rate = slider_loading_rate;



  /** Slip rates of a column, one cell wide. */
  SlipRateSeries
  simulate(const WaveColumn  &column,
           const unsigned int n_cells,
           const double       end_time,
           const Settings    &more)
  {
    Simulation<2> simulation(
      read_scene(scene_of(column, n_cells),
                 central_differences +
                   Settings{"Time/End time=" + std::to_string(end_time)} +
                   (column.is_arcsinh ?
                      Settings{"Faults/fault/Regularisation=arcsinh"} :
                      Settings{}) +
                   more),
      MPI_COMM_WORLD);
    simulation.set_up();
    SlipRateSeries series{{0.}, {0.}};
    while (!simulation.is_finished())
      {
        simulation.advance();
        series.time.push_back(simulation.state().time);
        series.slip_rate.push_back(
          std::abs(simulation.state().slip_rate[0][0]));
      }
    return series;
  }
} // namespace



TEST(CentralDifferences, EnergyIsBalancedExactly)
{
  const Settings cells = {"Bodies/lower/Coarse cells=4, 1",
                          "Bodies/upper/Coarse cells=3, 1"};
  // Steps of one size to the end.
  expect_exact_balance<2, 2>(
    creeping_bodies_with<2>({in_the_plane, cells, loaded(2, 4e-5)}));
  expect_exact_balance<3, 3>(
    creeping_bodies_with<3>({in_space,
                             {"Bodies/lower/Coarse cells=4, 2, 1",
                              "Bodies/upper/Coarse cells=3, 2, 1",
                              "Bodies/lower/Refinement passes=0",
                              "Bodies/upper/Refinement passes=0"},
                             loaded(3, 5e-4)}));
}



// By characteristics, with a state that evolves.
TEST(CentralDifferences, SecondOrderInMeshAndStep)
{
  constexpr double end_time = 0.8;
  WaveColumn       column   = strengthening_column();
  column.run(end_time + 0.1, 0.);
  const SlipRateSeries reference{column.time, column.slip_rate};

  std::vector<double> errors;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const std::string    tau = std::to_string(8e-4 / (1u << i));
      const SlipRateSeries ours =
        simulate(column,
                 8u << i,
                 end_time,
                 of_one_size + Settings{"Time/Largest step=" + tau,
                                        "Time/Initial step=" + tau,
                                        "Time/Ramp fraction=1"});
      double largest = 0.;
      for (std::size_t k = 0; k < ours.time.size(); ++k)
        if (ours.time[k] > 0.3)
          largest =
            std::max(largest,
                     std::abs(ours.slip_rate[k] - reference.at(ours.time[k])));
      errors.push_back(largest);
    }
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2., 0.1) << errors[i];
  EXPECT_LT(errors.back(), 1e-6);
}



// Stuck for twenty seconds, then an event, and its waves.
TEST(CentralDifferences, EventComesInTime)
{
  WaveColumn column = spring_slider();
  column.run(21., 0.);
  const SlipRateSeries reference{column.time, column.slip_rate};
  const double         start = reference.events(loading_rate)[0];
  const SlipRateSeries ours  = simulate(column, 64, 20.6, {});
  const double         late  = ours.events(loading_rate)[0] - start;
  std::cout << ours.time.size() - 1 << " steps, event at " << start
            << " s, late by " << late << " s\n";
  EXPECT_LT(std::abs(late), 2e-3);
  for (const double t : {5., 10., 15., 19.})
    EXPECT_NEAR(ours.at(t) / reference.at(t), 1., 5e-3) << t;
  for (double t = start; t < start + 0.05; t += 1e-3)
    EXPECT_NEAR(ours.at(t + late) / reference.at(t), 1., 0.03) << t;
}



TEST(CentralDifferences, StepsAreShorterWhereTheErrorAsksForIt)
{
  const WaveColumn column = spring_slider();
  const auto       sizes  = [&](const std::string &tolerance) {
    const SlipRateSeries series =
      simulate(column, 16, 20.6, {"Time/Tolerance=" + tolerance});
    double shortest = 1., longest = 0.;
    for (std::size_t k = 2; k + 1 < series.time.size(); ++k)
      {
        const double tau = series.time[k] - series.time[k - 1];
        shortest         = std::min(shortest, tau);
        longest          = std::max(longest, tau);
      }
    return std::make_pair(shortest, longest);
  };
  const auto [short_of_loose, long_of_loose] = sizes("1e-2");
  const auto [short_of_tight, long_of_tight] = sizes("1e-9");
  EXPECT_NEAR(long_of_loose, long_of_tight, 1e-9);
  EXPECT_LT(short_of_tight, 0.3 * short_of_loose);
  // Of waves of pressure along the height of a cell, 0.9 of the limit.
  const double cell  = 1. / 16.,
               speed = std::sqrt(column.shear_modulus * 3.5 / column.density);
  EXPECT_GT(long_of_loose, 0.5 * cell / speed);
  EXPECT_LT(long_of_loose, 1.0 * cell / speed);
}



TEST(CentralDifferences, AntiplaneEventsAreThoseOfNewmarksMethod)
{
  const auto slip_at_end = [](const Settings &more) {
    return end_of_antiplane_run(antiplane_bodies,
                                Settings{"Time/Inertia=dynamic",
                                         "Time/End time=2"} +
                                  more);
  };
  const FaultSnapshot<2> newmark = slip_at_end({"Time/Tolerance=1e-8"});
  std::vector<double>    differences;
  for (const std::string refinements : {"0", "1"})
    {
      const Settings cells = {"Bodies/lower/Uniform refinements=" + refinements,
                              "Bodies/upper/Uniform refinements=" +
                                refinements};
      differences.push_back(
        difference(slip_at_end(central_differences + cells),
                   slip_at_end(cells + Settings{"Time/Tolerance=1e-7"}))
          .first);
      std::cout << "slip differs by " << differences.back() << '\n';
    }
  // The masses differ, and more so on larger cells.
  EXPECT_LT(differences[0], 0.02);
  EXPECT_LT(differences[1], 0.4 * differences[0]);
}



// The upper body, pushed within 0.2 s, glides by several faces without
// friction, with a new contact mapping wherever it has slid far enough.
template <int dim>
double
energy_missing(const Settings    &corners,
               const Settings    &cells,
               const std::string &fraction)
{
  const std::string top = "Boundary conditions/upper top/",
                    up  = top + (dim == 2 ? "y" : "z");
  Simulation<dim> simulation(
    creeping_bodies_with<dim>(
      {corners,
       cells,
       central_differences,
       {top + "x condition=traction",
        top + "x value=if(t < 0.2, 3125*(1 - cos(10*pi*t)), 0)",
        up + " condition=traction",
        up + " value=-1e4",
        top + "Ramp length=0",
        "Faults/fault/Friction=frictionless",
        "Contact/Rebuild fraction=" + fraction,
        "Time/End time=2",
        "Output/Event start slip rate=1"}}),
    MPI_COMM_WORLD);
  simulation.set_up();
  const auto                &level = simulation.meshes().finest();
  const std::vector<double> &masses =
    simulation.spatial_problem().nodal_masses();
  const auto momentum = [&]() {
    double sum = 0.;
    for (unsigned int node = level.node(1, 0); node < masses.size(); ++node)
      sum +=
        masses[node] * simulation.state().velocity.local_element(dim * node);
    return sum;
  };
  double pushed = 0.;
  while (!simulation.is_finished())
    {
      simulation.advance();
      if (simulation.state().time < 0.21)
        pushed = momentum();
    }
  const auto  &balance = *simulation.energy_balance();
  const double missing =
    balance.defect(simulation.state()) / balance.work().largest();
  std::cout << simulation.counts().contact_mappings
            << " mappings, energy missing " << missing << ", momentum "
            << pushed << " and " << momentum() << '\n';
  EXPECT_GT(simulation.counts().contact_mappings, 4u);
  // Integral of the traction over the push, on 2 m (2 m x 1 m).
  EXPECT_NEAR(pushed, 2. * 0.2 * 3125., 1.);
  EXPECT_NEAR(momentum(), pushed, 1e-4 * pushed);
  return std::abs(missing);
}



TEST(CentralDifferences, MappingsKeepMomentumAndEnergyInThePlane)
{
  const Settings cells = {"Bodies/lower/Coarse cells=4, 1",
                          "Bodies/upper/Coarse cells=4, 1"};
  EXPECT_LT(energy_missing<2>(in_the_plane, cells, "0.25"), 1e-3);
}



TEST(CentralDifferences, MappingsKeepMomentumAndEnergyInSpace)
{
  const Settings cells   = {"Bodies/lower/Coarse cells=4, 2, 1",
                            "Bodies/upper/Coarse cells=3, 2, 1",
                            "Bodies/lower/Refinement passes=1",
                            "Bodies/upper/Refinement passes=1"};
  const double   missing = energy_missing<3>(in_space, cells, "0.25");
  EXPECT_LT(missing, 2e-3);
  EXPECT_LT(energy_missing<3>(in_space, cells, "0.0625"), missing);
}
