// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /**
   * Two layers of 1 m without ends slide without friction along a sine of
   * length 1 m. Material and top side are such that the closed form below is
   * one of half spaces: waves decay by exp(-2 pi) over a layer.
   */
  const std::string layers = R"(
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -1
  subsection lower
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 1
    set Coarse cells         = 12, 12
    set Refinement passes    = 0
    set Uniform refinements  = 1
    subsection Material
      set Young modulus   = 1e6
      set Poisson ratio   = 0.25
      set Density         = 1
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
  subsection upper
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 1
    set Coarse cells         = 16, 16
    set Refinement passes    = 0
    set Uniform refinements  = 1
    subsection Material
      set Young modulus   = 1e6
      set Poisson ratio   = 0.25
      set Density         = 1
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Friction               = frictionless
    set Elevation              = 0.01 * sin(2 * pi * x)
    set Normal stress          = function
    set Normal stress function = 1
  end
end
subsection Boundary conditions
  set Sides            = lower bottom, upper top
  set Periodic along x = true
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1
    set y condition = fixed
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Contact
  set Rebuild fraction = 0.25
end
subsection Time
  set Inertia           = quasi-static
  set End time          = 1
  set Step size control = constant
  set Largest step      = 0.001953125
end
subsection Output
  set Fault fields = contact_pressure
end
)";



  /**
   * Half spaces that are pressed together over the whole of a wavy interface
   * (Westergaard 1939; Johnson 1985, section 13.2): sides that differ by
   * d cos(kx) have the contact pressure E* k d / 2 cos(kx), with
   * 1/E* = 2 (1 - nu^2) / E of equal bodies, and store the energy
   * E* k d^2 / 8 an area. Two sines that have slid by s differ by
   *
   *   A sin(k(X + s)) - A sin(kX) = 2 A sin(ks/2) cos(kX + ks/2)
   *
   * in the coordinate X of the upper one.
   */
  constexpr double amplitude     = 0.01;
  constexpr double k             = 2. * numbers::PI;
  constexpr double contact       = 1e6 / (2. * (1. - 0.25 * 0.25));
  constexpr double most_pressure = contact * k * amplitude;
  constexpr double most_energy   = contact * k * amplitude * amplitude / 2.;

  std::complex<double>
  expected_pressure(const double slip)
  {
    return most_pressure * std::sin(k * slip / 2.) *
           std::polar(1., k * slip / 2.);
  }

  double
  expected_energy(const double slip)
  {
    return most_energy * std::pow(std::sin(k * slip / 2.), 2);
  }

  /** The change of the pressure in a step of 1/512 of a wave, over
   * most_pressure. */
  constexpr double most_pressure_step = k / 2. / 512.;

  /** The derivative of the energy, N: the force that slides the upper body. */
  constexpr double most_drag = most_energy * k / 2.;

  double
  expected_drag(const double slip)
  {
    return most_drag * std::sin(k * slip);
  }



  /** The largest departures from the closed form along a run, over what is
   * largest of it. */
  struct Departures
  {
    double pressure = 0, roughness = 0, pressure_step = 0, gap = 0, energy = 0,
           work = 0, missing = 0, drag = 0;
    /** Energy that contact mappings have added after each wave. */
    std::vector<double> added;
    /** The sine in the pressure after each step. */
    std::vector<std::complex<double>> waves;
  };

  Departures
  slide(const std::vector<std::string> &overrides)
  {
    const SceneParameters<2> scene = read_scene(layers, overrides);
    Simulation<2>            simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    const bool          has_inertia = scene.time.inertia == Inertia::dynamic;
    Departures          worst;
    std::vector<double> before;
    double              slip_before = 0, work_before = 0;
    while (!simulation.is_finished())
      {
        simulation.advance();
        const FaultSnapshot<2> fault = snapshots(simulation).front();
        const double           slip  = fault_statistics(fault).mean_slip;
        std::complex<double>   wave;
        double                 mean = 0, area = 0;
        for (unsigned int p = 0; p < fault.points.size(); ++p)
          {
            wave += 2. * fault.weights[p] * fault.contact_pressure[p] *
                    std::polar(1., -k * fault.points[p][0]);
            mean += fault.weights[p] * fault.contact_pressure[p];
            area += fault.weights[p];
          }
        wave /= area;
        mean /= area;
        const auto note = [](double &largest, const double value) {
          largest = std::max(largest, std::abs(value));
        };
        worst.waves.push_back(wave);
        note(worst.pressure,
             std::abs(wave - expected_pressure(slip)) / most_pressure);
        for (unsigned int p = 0; p < fault.points.size(); ++p)
          {
            const double smooth =
              mean + (wave * std::polar(1., k * fault.points[p][0])).real();
            note(worst.roughness,
                 (fault.contact_pressure[p] - smooth) / most_pressure);
            if (!before.empty())
              note(worst.pressure_step,
                   (fault.contact_pressure[p] - before[p]) / most_pressure);
          }
        before = fault.contact_pressure;
        note(worst.gap,
             simulation.spatial_problem().gaps().front()->absolute / amplitude);
        const EnergyBalance<2> &energy = *simulation.energy_balance();
        note(worst.energy,
             (energy.elastic_energy(simulation.state()) -
              expected_energy(slip)) /
               most_energy);
        const double added = energy.work().mappings / most_energy;
        note(worst.work,
             (energy.work().driven_sides - expected_energy(slip)) /
                 most_energy +
               added);
        note(worst.missing, energy.defect(simulation.state()) / most_energy);
        // Waves that run to and fro between the driven side and the fault are
        // in the force on that side as well.
        if (const double work = energy.work().driven_sides; !has_inertia)
          {
            note(worst.drag,
                 ((work - work_before) / (slip - slip_before) -
                  expected_drag(0.5 * (slip + slip_before))) /
                   most_drag);
            work_before = work;
            slip_before = slip;
          }
        if (simulation.state().time > worst.added.size() + 1. - 1e-9)
          worst.added.push_back(added);
      }
    return worst;
  }
} // namespace



TEST(SlidingOverASine, HasThePressureAndTheEnergyOfHalfSpaces)
{
  const Departures worst = slide({"Time/End time=2"});
  // Forces lag by an eighth of a face, k h/16 of the phase, but change as
  // smoothly as those of the closed form.
  EXPECT_LT(worst.pressure, 0.02);
  EXPECT_LT(worst.roughness, 0.03);
  EXPECT_LT(worst.pressure_step, 1.3 * most_pressure_step);
  EXPECT_LT(worst.gap, 1.5e-3);
  EXPECT_LT(worst.energy, 0.01);
  EXPECT_LT(worst.work, 0.01);
  EXPECT_LT(worst.drag, 0.07);
  EXPECT_LT(worst.missing, 1e-8);
  ASSERT_EQ(worst.added.size(), 2u);
  EXPECT_LT(std::abs(worst.added[0]), 0.09);
  // The second wave repeats the first.
  EXPECT_NEAR(worst.added[1], 2. * worst.added[0], 1e-3);
  const unsigned int n = worst.waves.size() / 2;
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_LT(std::abs(worst.waves[n + i] - worst.waves[i]),
              2e-2 * most_pressure);
  std::cout << "pressure " << worst.pressure << ", roughness "
            << worst.roughness << ", step " << worst.pressure_step << ", gap "
            << worst.gap << ", energy " << worst.energy << ", work "
            << worst.work << ", drag " << worst.drag << ", added "
            << worst.added[0] << ", missing " << worst.missing << '\n';
}



// Intervals are the default, and steps a thirtieth of those that follow waves.
TEST(SlidingOverASine, WithInertiaLosesLittleEnergy)
{
  const Departures worst = slide({"Time/Inertia=dynamic",
                                  "Time/Largest step=0.00048828125",
                                  "Contact/Rebuild fraction=0.0625"});
  std::cout << "pressure " << worst.pressure << ", roughness "
            << worst.roughness << ", step " << worst.pressure_step << ", gap "
            << worst.gap << ", energy " << worst.energy << ", added "
            << worst.added[0] << ", missing " << worst.missing << '\n';
  EXPECT_LT(worst.pressure, 0.012);
  EXPECT_LT(worst.pressure_step, 0.015);
  EXPECT_LT(worst.gap, 1.5e-3);
  EXPECT_LT(std::abs(worst.added[0]), 0.01);
}



TEST(SlidingOverASine, LosesLessTheShorterTheIntervals)
{
  const Departures quarter = slide({});
  const Departures eighth  = slide({"Contact/Rebuild fraction=0.125"});
  EXPECT_LT(eighth.gap, 0.6 * quarter.gap);
  EXPECT_LT(eighth.added[0] / quarter.added[0], 0.7);
}
