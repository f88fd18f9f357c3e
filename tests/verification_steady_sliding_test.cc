// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "endless_layers.h"
#include "sliding_wave.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Complex = SteadySliding::Complex;



  SteadySliding
  two_layers(const double wave_length)
  {
    SteadySliding theory;
    for (Material &material : theory.material)
      material.shear_viscosity = material.bulk_viscosity = 0.;
    theory.friction.characteristic_slip = 5e-6;
    theory.normal_stress                = 5e4;
    theory.slip_rate                    = 2e-5;
    theory.wave_number                  = 2. * numbers::PI / wave_length;
    theory.thickness                    = {{0.5, 0.5}};
    return theory;
  }



  /** The layers of a theory, one wave length of them. */
  SteppingScene
  make_scene(const SteadySliding &theory,
             const std::string   &law,
             const unsigned int   n_halvings,
             const std::string   &inertia)
  {
    EndlessLayers layers;
    layers.material  = theory.material;
    layers.thickness = theory.thickness;
    layers.length    = 2. * numbers::PI / theory.wave_number;
    for (unsigned int layer = 0; layer < 2; ++layer)
      layers.coarse_cells[layer] = {
        {4,
         static_cast<unsigned int>(std::max(
           1., std::round(4. * theory.thickness[layer] / layers.length)))}};
    layers.uniform_refinements = n_halvings;
    layers.friction            = theory.friction;
    layers.normal_stress       = theory.normal_stress;
    layers.velocity            = theory.slip_rate;
    // Relative to the rates of strain, which the wave alone has: without mass
    // the translation of a layer, a thousand times as fast, does not count, but
    // for its rounding.
    const std::string tolerance = inertia == "dynamic" ? "1e-12" : "1e-8",
                      settled   = inertia == "dynamic" ? "1e-12" : "1e-10";
    return SteppingScene(layers.text(),
                         {std::string("Faults/fault/State law=") + law,
                          "Time/Inertia=" + inertia,
                          "TNNMG/Tolerance=" + tolerance,
                          "Time/Rate-state tolerance=" + settled,
                          "Time/Largest step=1e6",
                          "Time/Initial step=1e-3"});
  }



  /** Steady sliding, perturbed by a little slip in the shape of the growing
   * wave. */
  void
  set_state(SteppingScene       &scene,
            const SteadySliding &theory,
            const Complex        s,
            const double         slip)
  {
    const double               k = theory.wave_number;
    const std::vector<Complex> c = theory.coefficients(s);
    const double               shear_stress =
      theory.normal_stress *
        (theory.friction.reference_friction +
         (theory.friction.a - theory.friction.b) *
           std::log(theory.slip_rate / theory.friction.reference_slip_rate)) +
      theory.radiation_damping * theory.slip_rate;

    set_sliding_bodies(scene,
                       theory,
                       shear_stress,
                       s,
                       [&](const unsigned int b, const Point<2> &point) {
                         const auto field = theory.field(b, point[1], s, c);
                         return std::array<Complex, 2>{
                           {slip * field.X * std::cos(k * point[0]),
                            slip * field.Y * std::sin(k * point[0])}};
                       });

    SystemState<2>        &state = scene.state;
    const FaultContact<2> &fault = scene.problem.jump_basis().faults().front();
    const double           sign  = fault.sides.sign();
    for (unsigned int p = 0; p < state.alpha.size(); ++p)
      {
        const double wave = std::cos(k * fault.slave.points[p][0]);
        state.slip_rate[p][0] =
          sign * (theory.slip_rate + (s * slip).real() * wave);
        state.slip[p][0] = sign * slip * wave;
        state.alpha[p] =
          std::log(theory.friction.characteristic_slip / theory.slip_rate) +
          (theory.state(s) * slip).real() * wave;
      }
  }



  /** The part of ln(theta) that varies as cos kx. */
  double
  amplitude(const SteppingScene &scene, const double k)
  {
    const FaultContact<2> &fault  = scene.problem.jump_basis().faults().front();
    const auto            &points = fault.slave.points;
    double                 sum    = 0;
    for (unsigned int p = 0; p < points.size(); ++p)
      sum += 2. * scene.state.alpha[p] * std::cos(k * points[p][0]);
    return sum / points.size();
  }



  /** The exponent of a series Re[A exp(s t)], from the recurrence of three
   * values that follow each other. */
  Complex
  exponent(const std::vector<double> &values, const double tau)
  {
    // Least squares for c(n+1) = p c(n) + q c(n-1).
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    for (unsigned int n = 1; n + 1 < values.size(); ++n)
      {
        const double x = values[n], y = values[n - 1], z = values[n + 1];
        xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
      }
    const double determinant = xx * yy - xy * xy;
    const double p           = (xz * yy - yz * xy) / determinant,
                 q           = (yz * xx - xz * xy) / determinant;
    const Complex root       = (p + std::sqrt(Complex(p * p + 4. * q))) / 2.;
    return std::log(root) / tau;
  }



  /** The growth rate that the program finds: of the wave of the theory over
   * one and a half turns of its phase. */
  Complex
  simulated_growth_rate(const SteadySliding &theory,
                        const std::string   &law,
                        const unsigned int   n_halvings   = 4,
                        const unsigned int   steps_a_turn = 120,
                        const std::string   &inertia      = "dynamic")
  {
    const Complex s     = theory.growth_rate();
    SteppingScene scene = make_scene(theory, law, n_halvings, inertia);
    set_state(scene, theory, s, 1e-3 * theory.friction.characteristic_slip);
    const double        tau    = 2. * numbers::PI / s.imag() / steps_a_turn;
    std::vector<double> values = {amplitude(scene, theory.wave_number)};
    for (unsigned int n = 0; n < steps_a_turn * 3 / 2; ++n)
      {
        StepResult<2> step = scene.step->take(scene.state, tau);
        EXPECT_TRUE(step.converged) << step.failure;
        scene.state = std::move(step.state);
        values.push_back(amplitude(scene, theory.wave_number));
      }
    return exponent(values, tau);
  }



  /** The wave length whose stiffness is critical for two layers of the same
   * kind as these. */
  double
  critical_wave_length(SteadySliding theory = two_layers(1.))
  {
    double lower = 0.1, upper = 10.;
    while (upper / lower > 1. + 1e-12)
      {
        const double middle = std::sqrt(lower * upper);
        theory.wave_number  = 2. * numbers::PI / middle;
        theory.with_inertia = false;
        (theory.stiffness(0.).real() > theory.critical_stiffness() ? lower :
                                                                     upper) =
          middle;
      }
    return lower;
  }
  /** Also a row of the table in doc/accuracy.md: number of the row, law, wave
   * length over the critical one, growth rates in 1/s. */
  void
  expect_within_two_percent(const Complex      found,
                            const Complex      expected,
                            const std::string &law,
                            const double       factor)
  {
    static unsigned int n_rows = 0;
    std::ostringstream  row;
    row.precision(6);
    row << law << ' ' << factor << ' ' << expected.real() << ' '
        << expected.imag() << ' ' << found.real() << ' ' << found.imag();
    ::testing::Test::RecordProperty("row " + std::to_string(n_rows++),
                                    row.str());
    EXPECT_NEAR(found.real() / expected.real(), 1., 0.02);
    EXPECT_NEAR(found.imag() / expected.imag(), 1., 0.02);
  }
} // namespace



TEST(SteadySliding, LimitsOfTheTheory)
{
  // Half-spaces: G k / (2 (1 - nu)), Rice and Ruina (1983); and layers that
  // shear as a whole.
  SteadySliding theory = two_layers(0.05);
  const double  G      = theory.material[0].shear_modulus();
  theory.with_inertia  = false;
  EXPECT_NEAR(theory.stiffness(0.).real() / (G * theory.wave_number / 2. / 0.7),
              1.,
              1e-10);
  theory.wave_number = 1e-3;
  EXPECT_NEAR(theory.stiffness(0.).real() / (G / 1.), 1., 1e-5);

  // With inertia, long waves are those of a column, G q coth(q H) / 2.
  theory.with_inertia = true;
  const Complex s(30., 100.);
  const Complex q      = s * std::sqrt(theory.material[0].density / G);
  const Complex column = 0.5 * G * q / std::tanh(q * 0.5);
  EXPECT_LT(std::abs(theory.stiffness(s) / column - 1.), 1e-5);

  // Slow waves have no inertia.
  theory              = two_layers(0.7);
  const Complex slow  = theory.stiffness(1e-2);
  theory.with_inertia = false;
  EXPECT_LT(std::abs(slow / theory.stiffness(1e-2) - 1.), 1e-6);
}



TEST(SteadySliding, SlowGrowthOnBothSidesOfTheCriticalWaveLength)
{
  const double critical = critical_wave_length();
  for (const std::string law : {"aging", "slip"})
    for (const double factor : {0.5, 0.8, 1.25, 2.})
      {
        const SteadySliding theory = two_layers(factor * critical);
        SteadySliding       slow   = theory;
        slow.with_inertia          = false;
        const Complex expected     = slow.growth_rate();
        EXPECT_EQ(expected.real() > 0., factor > 1.);
        EXPECT_LT(std::abs(theory.growth_rate() / expected - 1.), 1e-3);
        expect_within_two_percent(simulated_growth_rate(theory, law),
                                  expected,
                                  law,
                                  factor);
      }
}



TEST(SteadySliding, FastGrowthOfUnequalViscousLayers)
{
  const double critical = critical_wave_length();
  for (const std::string law : {"aging", "slip"})
    for (const double factor : {0.6, 1.7})
      {
        SteadySliding theory               = two_layers(factor * critical);
        theory.slip_rate                   = 4e-3;
        theory.thickness                   = {{0.6, 0.4}};
        theory.material[0].youngs_modulus  = 6e7;
        theory.material[1].poissons_ratio  = 0.2;
        theory.material[1].density         = 3e3;
        theory.material[0].shear_viscosity = 2e3;
        theory.material[1].bulk_viscosity  = 4e3;
        const Complex expected             = theory.growth_rate();
        SteadySliding slow                 = theory;
        slow.with_inertia                  = false;
        EXPECT_GT(std::abs(slow.growth_rate() / expected - 1.), 0.1);
        expect_within_two_percent(simulated_growth_rate(theory, law),
                                  expected,
                                  law,
                                  factor);
      }
}



TEST(SteadySliding, SecondOrderInMeshAndStep)
{
  const SteadySliding theory   = two_layers(1.25 * critical_wave_length());
  const Complex       expected = theory.growth_rate();
  std::vector<double> errors;
  for (unsigned int i = 0; i < 3; ++i)
    errors.push_back(std::abs(
      simulated_growth_rate(theory, "aging", 2 + i, 40u << i) - expected));
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2., 0.2) << errors[i];
}



namespace
{
  SteadySliding
  unequal_layers(const double slip_rate)
  {
    SteadySliding theory              = two_layers(1.);
    theory.slip_rate                  = slip_rate;
    theory.thickness                  = {{0.6, 0.4}};
    theory.material[0].youngs_modulus = 6e7;
    theory.material[1].poissons_ratio = 0.2;
    theory.material[1].density        = 3e3;
    theory.with_inertia               = false;
    return theory;
  }



  /** On both sides of the critical wave length, for both laws; largest
   * relative error. */
  double
  check_without_inertia(SteadySliding theory, const std::string &inertia)
  {
    const double critical = critical_wave_length(theory);
    double       largest  = 0.;
    for (const std::string law : {"aging", "slip"})
      for (const double factor : {0.6, 0.85, 1.2, 1.7})
        {
          theory.wave_number     = 2. * numbers::PI / (factor * critical);
          const Complex expected = theory.growth_rate();
          EXPECT_EQ(expected.real() > 0., factor > 1.);
          SteadySliding other     = theory;
          other.with_inertia      = true;
          other.radiation_damping = 0.;
          // The models differ here.
          EXPECT_GT(std::abs(other.growth_rate() / expected - 1.), 0.04);
          const Complex found =
            simulated_growth_rate(theory, law, 4, 120, inertia);
          EXPECT_NEAR(found.real() / expected.real(), 1., 0.02)
            << inertia << ' ' << factor;
          EXPECT_NEAR(found.imag() / expected.imag(), 1., 0.02)
            << inertia << ' ' << factor;
          largest = std::max({largest,
                              std::abs(found.real() / expected.real() - 1.),
                              std::abs(found.imag() / expected.imag() - 1.)});
        }
    std::cout << inertia << ": critical wave length " << critical
              << " m, largest relative error of a growth rate " << largest
              << '\n';
    return critical;
  }
} // namespace



TEST(SteadySliding, GrowthWithoutInertia)
{
  check_without_inertia(unequal_layers(4e-3), "quasi-static");
}



TEST(SteadySliding, GrowthWithRadiationDamping)
{
  SteadySliding theory  = unequal_layers(7e-4);
  const double  without = critical_wave_length(theory);
  double        sum     = 0.;
  for (const Material &material : theory.material)
    sum += 1. / std::sqrt(material.density * material.youngs_modulus / 2. /
                          (1. + material.poissons_ratio));
  theory.radiation_damping = 1. / sum;
  EXPECT_GT(check_without_inertia(theory, "quasi-dynamic"), 1.2 * without);
}
