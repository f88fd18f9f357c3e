// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "antiplane_scenes.h"
#include "column_scenes.h"
#include "error_message.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The relative error in the mean square of the slip rate of two columns one
   * cell wide, against the characteristics of shear waves. */
  double
  error_of_column(const unsigned int n_cells)
  {
    WaveColumn column = strengthening_column(0.1);
    column.height     = 0.5;
    column.run(0.3, 0.);

    const std::string cells = "1, " + std::to_string(n_cells);
    Simulation<2, 1>  simulation(
      read_scene(antiplane_bodies,
                 {"Bodies/lower/Coarse cells=" + cells,
                   "Bodies/upper/Coarse cells=" + cells,
                   "Faults/fault/a=0.02",
                   "Faults/fault/b=0.01",
                   "Faults/fault/Reference friction coefficient=0",
                   "Faults/fault/Reference slip rate=1e-3",
                   "Faults/fault/Characteristic slip=1e-3",
                   "Faults/fault/Initial state=1",
                   "Faults/fault/Normal stress function=2e4",
                   "Boundary conditions/upper top/z value=1e-2",
                   "Boundary conditions/upper top/Ramp length=0.1",
                   "Time/Inertia=dynamic",
                   "Time/Step size control=constant",
                   "Time/Largest step=" + std::to_string(0.064 / n_cells),
                   "Time/End time=0.3"}),
      MPI_COMM_WORLD);
    simulation.set_up();
    double error = 0, norm = 0;
    while (!simulation.is_finished())
      {
        simulation.advance();
        const double t = simulation.state().time;
        const auto   n = static_cast<std::size_t>(
          std::min<double>(std::round(t / column.time[1]),
                           column.time.size() - 1.));
        const double exact = column.slip_rate[n],
                     ours  = simulation.state().slip_rate[0][0];
        error += (ours - exact) * (ours - exact);
        norm += exact * exact;
      }
    return std::sqrt(error / norm);
  }
} // namespace



// Five passages of the columns, from the loading through the fault and back.
TEST(Antiplane, ShearWavesInColumns)
{
  const double coarse = error_of_column(32), fine = error_of_column(64);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.4);
}



namespace
{
  /** The relative errors at the centre and in the mean square of the slip of a
   * row of cracks without friction, abs(x) < 1, with the period 2 W = 4, under
   * a shear stress tau far away,
   *
   *   4 W tau/(pi mu) arcosh(cos(pi x/(2 W)) / cos(pi/(2 W))),
   *
   * which tends to 2 tau/mu sqrt(1 - x^2) for large W. */
  std::pair<double, double>
  errors_of_crack(const unsigned int refinements)
  {
    const double           tau = 1e5, mu = 1e9, W = 2.;
    const std::string      n     = std::to_string(refinements);
    const FaultSnapshot<2> fault = end_of_antiplane_run(
      antiplane_bodies,
      {"Bodies/Base elevation=-6",
       "Bodies/lower/Lower lateral corner=-2",
       "Bodies/lower/Upper lateral corner=2",
       "Bodies/lower/Thickness=6",
       "Bodies/lower/Coarse cells=8, 12",
       "Bodies/lower/Uniform refinements=" + n,
       "Bodies/lower/Material/Young modulus=2.5e9",
       "Bodies/lower/Material/Poisson ratio=0.25",
       "Bodies/upper/Lower lateral corner=-2",
       "Bodies/upper/Upper lateral corner=2",
       "Bodies/upper/Thickness=6",
       "Bodies/upper/Coarse cells=8, 12",
       "Bodies/upper/Uniform refinements=" + n,
       "Bodies/upper/Material/Young modulus=2.5e9",
       "Bodies/upper/Material/Poisson ratio=0.25",
       "Faults/fault/Friction=welded",
       "Faults/fault/Regions/Names=crack",
       "Faults/fault/Regions/crack/Where=1 - abs(x)",
       "Faults/fault/Regions/crack/Friction=frictionless",
       "Boundary conditions/upper top/z condition=traction",
       "Boundary conditions/upper top/z value=1e5",
       "Boundary conditions/upper top/Ramp length=0",
       "Output/Event start slip rate=1",
       "Time/Inertia=quasi-static",
       "Time/Step size control=constant",
       "Time/Largest step=1",
       "Time/End time=1"});
    const auto exact = [&](const double x) {
      const double ratio =
        std::cos(numbers::PI * x / (2. * W)) / std::cos(numbers::PI / (2. * W));
      return ratio > 1. ?
               4. * W * tau / (numbers::PI * mu) * std::acosh(ratio) :
               0.;
    };
    double centre = 0, square = 0, norm = 0;
    for (unsigned int k = 0; k < fault.points.size(); ++k)
      {
        const double x = fault.points[k][0];
        const double e = fault.slip[k][0] - exact(x);
        square += fault.weights[k] * e * e;
        norm += fault.weights[k] * exact(x) * exact(x);
        if (std::abs(x) < 1e-9)
          centre = e / exact(0.);
      }
    return {centre, std::sqrt(square / norm)};
  }
} // namespace



// Of first order, that of the singular stress at the tips.
TEST(Antiplane, CrackSlipsAsInTheClosedForm)
{
  const auto coarse = errors_of_crack(2), fine = errors_of_crack(3);
  EXPECT_NEAR(std::log2(coarse.second / fine.second), 1., 0.2);
  EXPECT_LT(std::abs(fine.first), 0.02);
  EXPECT_LT(fine.second, 0.03);
}



namespace
{
  /** The bodies as a slice of three dimensions, endless along y, whose sides
   * are driven along y; the third axis is y of the plane. */
  SceneParameters<3>
  slice(const std::vector<std::string> &more)
  {
    std::string text = antiplane_bodies;
    const auto  swap = [&text](const std::string &from, const std::string &to) {
      for (std::size_t at = text.find(from); at != std::string::npos;
           at             = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    };
    swap("set Deformation = antiplane", "set Dimension = 3");
    swap("corner = -1", "corner = -1, 0");
    swap("corner = 1", "corner = 1, 0.5");
    swap("cells         = 8, 2", "cells         = 8, 2, 2");
    swap(
      "set z condition = fixed",
      "set x condition = fixed\n set y condition = fixed\n set z condition = "
      "fixed");
    swap(
      "set z condition = velocity",
      "set x condition = fixed\n set z condition = fixed\n set y condition = "
      "velocity");
    swap("set z value ", "set y value ");
    const TemporaryFolder folder;
    return SceneReader(folder.write("scene.prm", text),
                       Settings{"Boundary conditions/Periodic along y=true"} +
                         more)
      .read<3>();
  }
} // namespace



// Loading, slip and rest, with every kind of inertia.
TEST(Antiplane, SlipsAsASliceOfThreeDimensions)
{
  for (const std::string inertia : {"quasi-static", "quasi-dynamic", "dynamic"})
    {
      SCOPED_TRACE(inertia);
      const std::vector<std::string> settings = {
        "Time/Inertia=" + inertia,
        "Time/Step size control=constant",
        "Time/Largest step=0.02",
        "Time/End time=3",
        "TNNMG/Tolerance=1e-10",
        "Time/Rate-state tolerance=1e-10"};
      Simulation<3> simulation(slice(settings), MPI_COMM_WORLD);
      simulation.set_up();
      while (!simulation.is_finished())
        simulation.advance();
      const FaultSnapshot<2> ours =
        end_of_antiplane_run(antiplane_bodies, settings);
      const auto [slip, rate] =
        difference(ours, snapshots(simulation).front(), 1);
      EXPECT_LT(slip, 1e-6);
      EXPECT_LT(rate, 1e-5);
      EXPECT_GT(ours.slip[0][0], 1e-6);
    }
}



// Both sides are mirror images: one of them, with half of modulus and density,
// on a rigid foundation.
TEST(Antiplane, SymmetricHalf)
{
  const Settings         settings = {"TNNMG/Tolerance=1e-10",
                                     "Time/Rate-state tolerance=1e-10",
                                     "Time/Step size control=constant",
                                     "Time/Largest step=0.02",
                                     "Time/End time=3",
                                     "Boundary conditions/upper top/Ramp length=0"};
  const FaultSnapshot<2> both     = end_of_antiplane_run(
    antiplane_bodies,
    settings + Settings{"Boundary conditions/lower bottom/z condition=velocity",
                        "Boundary conditions/lower bottom/z value=-2e-4",
                        "Boundary conditions/lower bottom/Ramp length=0",
                        "Boundary conditions/upper top/z value=2e-4"});
  const FaultSnapshot<2> half = end_of_antiplane_run(
    antiplane_bodies,
    settings + Settings{"Bodies/lower/Rigid=true",
                        "Bodies/upper/Material/Young modulus=2.06e7",
                        "Bodies/upper/Material/Density=2.5e3"});
  const auto [slip, rate] = difference(half, both);
  EXPECT_LT(slip, 1e-7);
  EXPECT_LT(rate, 1e-6);
}



TEST(Antiplane, BothSolversOfTheRateProblem)
{
  const Settings         settings = {"TNNMG/Tolerance=1e-10",
                                     "Time/Rate-state tolerance=1e-10",
                                     "Time/Step size control=constant",
                                     "Time/Largest step=0.05"};
  const FaultSnapshot<2> tnnmg =
    end_of_antiplane_run(antiplane_bodies, settings);
  const FaultSnapshot<2> condensed = end_of_antiplane_run(
    antiplane_bodies, settings + Settings{"Time/Rate solver=condensed Newton"});
  const auto [slip, rate] = difference(condensed, tnnmg);
  EXPECT_LT(slip, 1e-7);
  EXPECT_LT(rate, 1e-6);
}



TEST(Antiplane, KindsOfFriction)
{
  for (const std::string kind : {"rate and state",
                                 "velocity strengthening",
                                 "Coulomb",
                                 "frictionless",
                                 "welded",
                                 "prescribed slip rate"})
    for (const std::string control : {"embedded", "constant"})
      {
        SCOPED_TRACE(kind + ", " + control);
        const FaultSnapshot<2> fault =
          end_of_antiplane_run(antiplane_bodies,
                               {"Faults/fault/Friction=" + kind,
                                "Faults/fault/Slip rate along x=1e-4",
                                "Time/Step size control=" + control,
                                "Time/Inertia=dynamic",
                                "Time/Largest step=0.01",
                                "Time/End time=1"});
        for (unsigned int k = 0; k < fault.slip.size(); ++k)
          {
            EXPECT_TRUE(std::isfinite(fault.slip[k][0]));
            if (kind == "welded")
              {
                EXPECT_EQ(fault.slip[k][0], 0.);
              }
            if (kind == "prescribed slip rate")
              {
                EXPECT_NEAR(fault.slip[k][0], 1e-4, 1e-6);
              }
            if (kind == "frictionless")
              {
                EXPECT_EQ(fault.shear_traction[k][0], 0.);
              }
          }
      }
}



TEST(Antiplane, WhatThereIsNotIsRefused)
{
  const auto expect = [](const Settings                 &settings,
                         const std::vector<std::string> &parts) {
    expect_one_sentence_with(
      message_of([&]() { read_scene(antiplane_bodies, settings); }), parts);
  };
  expect({"Faults/fault/Contact=unilateral"},
         {"'Faults/fault/Contact' = 'unilateral'", "antiplane"});
  expect({"Faults/fault/Normal stress follows=true"},
         {"'Faults/fault/Normal stress follows' = 'true'", "antiplane"});
  expect({"Faults/fault/Normal stress=initial equilibrium"},
         {"'Faults/fault/Normal stress' = 'initial equilibrium'",
          "function or lithostatic"});
  expect({"Faults/fault/Background stress=0, 0, 1e3"},
         {"'Faults/fault/Background stress'", "Initial shear stress"});
  expect({"Boundary conditions/upper top/Axes=side"},
         {"'Boundary conditions/upper top/Axes' = 'side'", "antiplane"});
  expect({"Boundary conditions/lower bottom/z condition=free",
          "Boundary conditions/upper top/z condition=free",
          "Boundary conditions/upper top/z value=0"},
         {"'z condition' = 'fixed' or 'velocity'"});
}
