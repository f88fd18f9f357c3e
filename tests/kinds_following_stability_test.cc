// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "endless_layers.h"
#include "sliding_wave.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Complex = SteadySliding::Complex;

  constexpr double length = 1.;



  /** Two layers that slide at 1 cm/s, where mu is @p mu; the normal stress
   * follows, and the upper one is pressed by a constant traction. */
  SteadySliding
  sliding_layers(const double mu, const double a)
  {
    SteadySliding theory;
    for (Material &material : theory.material)
      {
        material.youngs_modulus  = 4e7;
        material.shear_viscosity = material.bulk_viscosity = 100.;
      }
    theory.friction.a                   = a;
    theory.friction.b                   = 0.;
    theory.friction.reference_friction  = mu;
    theory.friction.reference_slip_rate = 1e-2;
    theory.normal_stress                = 1e4;
    theory.slip_rate                    = 1e-2;
    theory.wave_number                  = 2. * numbers::PI / length;
    theory.top_is_held                  = false;
    theory.normal_stress_follows        = true;
    return theory;
  }



  SteppingScene
  make_scene(const SteadySliding            &theory,
             const unsigned int              n_halvings,
             const std::vector<std::string> &more = {})
  {
    EndlessLayers layers;
    layers.material                          = theory.material;
    layers.thickness                         = theory.thickness;
    layers.length                            = length;
    layers.coarse_cells                      = {{{{8, 4}}, {{8, 4}}}};
    layers.uniform_refinements               = n_halvings;
    layers.friction                          = theory.friction;
    layers.normal_stress                     = theory.normal_stress;
    layers.velocity                          = theory.slip_rate;
    const std::vector<std::string> overrides = {
      "Faults/fault/Friction=velocity strengthening",
      "Faults/fault/Normal stress follows=true",
      std::string("Boundary conditions/upper top/y condition=") +
        (theory.top_is_held ? "fixed" : "traction"),
      "Contact/Follow slip=false",
      "TNNMG/Tolerance=1e-12",
      "Time/Rate-state tolerance=1e-12",
      "Time/Largest step=1e6"};
    return SteppingScene(layers.text(), overrides + more);
  }



  /** Steady sliding, and a wave exp(ikx + st) with a slip of this size. */
  void
  set_state(SteppingScene       &scene,
            const SteadySliding &theory,
            const Complex        s,
            const double         slip)
  {
    const double               k = theory.wave_number;
    const std::vector<Complex> c = theory.coefficients(s);
    const double               shear_stress =
      theory.normal_stress * theory.friction.reference_friction;

    set_sliding_bodies(scene,
                       theory,
                       shear_stress,
                       s,
                       [&](const unsigned int b, const Point<2> &point) {
                         const auto    field = theory.field(b, point[1], s, c);
                         const Complex phase =
                           slip * std::exp(Complex(0., k * point[0]));
                         return std::array<Complex, 2>{
                           {phase * field.X,
                            Complex(0., -1.) * phase * field.Y}};
                       });

    SystemState<2>        &state  = scene.state;
    const FaultContact<2> &fault  = scene.problem.jump_basis().faults().front();
    const double           sign   = fault.sides.sign();
    const Complex          normal = theory.field(1, 0., s, c).normal;
    for (unsigned int p = 0; p < state.slip_rate.size(); ++p)
      {
        const Complex phase =
          slip * std::exp(Complex(0., k * fault.slave.points[p][0]));
        state.slip[p][0]      = sign * phase.real();
        state.slip_rate[p][0] = sign * (theory.slip_rate + (s * phase).real());
        state.contact_pressure[p] = (Complex(0., 1.) * phase * normal).real();
      }
  }



  /** The part of the slip rate that varies as exp(ikx). */
  Complex
  amplitude(const SteppingScene &scene, const double k)
  {
    const FaultContact<2> &fault  = scene.problem.jump_basis().faults().front();
    const auto            &points = fault.slave.points;
    const double           sign   = fault.sides.sign();
    Complex                sum    = 0;
    for (unsigned int p = 0; p < points.size(); ++p)
      sum += sign * scene.state.slip_rate[p][0] *
             std::exp(Complex(0., -k * points[p][0]));
    return sum / double(points.size());
  }



  /** Let friction follow the contact pressure, which is zero at the start. */
  void
  follow(SteppingScene &scene)
  {
    scene.state.contact_pressure.assign(scene.state.slip_rate.size(), 0.);
    scene.prepare(
      FollowingStress<2>({true}, scene.faults, scene.state.normal_stress));
  }



  /** Exponent that the program gives a wave of the theory with exponent s over
   * one and a half turns of its phase. */
  Complex
  simulated_exponent(SteppingScene       &scene,
                     const SteadySliding &theory,
                     const Complex        s,
                     const unsigned int   steps_a_turn)
  {
    follow(scene);
    set_state(scene, theory, s, 1e-4 * theory.slip_rate / std::abs(s));
    const double tau = 2. * numbers::PI / std::abs(s.imag()) / steps_a_turn;
    // Slope of the logarithm of the amplitude by least squares.
    const unsigned int n = steps_a_turn * 3 / 2;
    Complex before = amplitude(scene, theory.wave_number), log = 0., sum = 0.;
    double  squares = 0.;
    for (unsigned int i = 0; i <= n; ++i)
      {
        if (i > 0)
          {
            StepResult<2> step = scene.step->take(scene.state, tau);
            EXPECT_TRUE(step.converged) << step.failure;
            scene.state       = std::move(step.state);
            const Complex now = amplitude(scene, theory.wave_number);
            log += std::log(now / before);
            before = now;
          }
        const double t = (i - 0.5 * n) * tau;
        sum += t * log;
        squares += t * t;
      }
    return sum / squares;
  }
} // namespace



namespace
{
  /** Expects that waves have the exponent of contrib/tools/sliding_layers.py,
   * within a hundredth after extrapolation to fine meshes and steps. */
  void
  expect_exponent(const SteadySliding &theory, const Complex expected)
  {
    // Two programs, one theory.
    const Complex F     = theory.characteristic_function(expected),
                  slope = theory.characteristic_function(1.001 * expected) - F;
    EXPECT_LT(std::abs(F / slope), 1e-3);

    Complex found[2];
    for (const unsigned int i : {0, 1})
      {
        SteppingScene scene = make_scene(theory, 2 + i);
        found[i] = simulated_exponent(scene, theory, expected, 60u << i);
      }
    // Errors are of second order.
    const Complex limit = found[1] + (found[1] - found[0]) / 3.;
    std::cout << "Exponents " << found[0] << ", " << found[1] << " 1/s, limit "
              << limit << ", expected " << expected << "\n";
    EXPECT_NEAR(limit.real() / expected.real(), 1., 0.01);
    EXPECT_NEAR(limit.imag() / expected.imag(), 1., 1e-3);
  }
} // namespace



TEST(FollowingNormalStress, LetsWavesGrow)
{
  // contrib/tools/sliding_layers.py --waves 1
  expect_exponent(sliding_layers(0.6, 0.01), Complex(23.39016, -646.8638));
}



TEST(FollowingNormalStress, LetsWavesDecayIfFrictionGrowsFastWithSlipRate)
{
  // contrib/tools/sliding_layers.py --waves 1 mu=0.2 a=0.1
  expect_exponent(sliding_layers(0.2, 0.1), Complex(-1.02375, 449.6241));
}



TEST(FollowingNormalStress, IsTheSameForAllSolvers)
{
  const SteadySliding theory = sliding_layers(0.6, 0.01);
  const Complex       s(23.39016, -646.8638);
  const auto          found = [&](const std::string &more) {
    SteppingScene scene = make_scene(theory, 1, {more});
    return simulated_exponent(scene, theory, s, 60);
  };
  const Complex expected = found("Time/Rate solver=TNNMG");
  for (const std::string more :
       {"Time/Rate solver=condensed Newton", "Time/Rate-state method=nested"})
    EXPECT_LT(std::abs(found(more) - expected), 1e-4) << more;
}
