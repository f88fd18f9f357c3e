// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>

#include <tuple>

#include "free_vibration.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr auto mass      = SpatialProblem<2>::mass;
  constexpr auto stiffness = SpatialProblem<2>::stiffness;



  std::vector<Material>
  undamped(const unsigned int n)
  {
    Material material;
    material.shear_viscosity = 0.;
    material.bulk_viscosity  = 0.;
    return std::vector<Material>(n, material);
  }



  SpatialScene<2>
  free_body(const Material &material, const double gravity = 0.)
  {
    return SpatialScene<2>(stack<2>({make_body<2>(1., {{10, 2}}, 0)}),
                           {},
                           {material},
                           gravity);
  }



  SystemState<2>
  at_rest(const SpatialProblem<2> &problem)
  {
    SystemState<2> state;
    state.displacement = problem.make_vector();
    state.velocity     = problem.make_vector();
    state.acceleration = problem.make_vector();
    return state;
  }



  /** A step without friction, the faults stuck if there are any. */
  SystemState<2>
  step(SpatialProblem<2> &problem, const SystemState<2> &from, const double tau)
  {
    SystemState<2> to = from;
    to.time           = from.time + tau;
    NodalVector w     = problem.make_vector();
    problem.to_jumps(w, from.velocity);
    solve_linear(problem,
                 Newmark<2>().operator_coefficients(tau),
                 stuck_mask(problem.hierarchy()),
                 Newmark<2>().right_hand_side(problem, from, tau),
                 w);
    problem.to_nodal(to.velocity, w);
    Newmark<2>().complete(to, from, tau);
    return to;
  }



  double
  energy(const SpatialProblem<2> &problem, const SystemState<2> &state)
  {
    NodalVector w = problem.make_vector(), Aw = w;
    problem.to_jumps(w, state.velocity);
    problem.term(mass).vmult(Aw, w);
    double result = 0.5 * (w * Aw);
    problem.to_jumps(w, state.displacement);
    problem.term(stiffness).vmult(Aw, w);
    return result + 0.5 * (w * Aw);
  }



  /** Random combinations of long waves. */
  Tensor<1, 2>
  smooth_velocity(const Point<2> &x, const std::vector<double> &amplitudes)
  {
    Tensor<1, 2> value;
    for (unsigned int k = 0; k < amplitudes.size(); ++k)
      value[k % 2] +=
        1e-3 * amplitudes[k] *
        std::cos((1. + k / 2) * x[0] + (k % 3) * x[1] + 5. * amplitudes[k]);
    return value;
  }



  /** Step sizes that change by a factor of up to eight from step to step. */
  double
  step_size(const unsigned int k, const bool changing)
  {
    return changing ? 0.004 * std::pow(0.5, (k / 3) % 4) : 0.002;
  }



  void
  expect_energy_kept(SpatialScene<2> &scene, const bool changing)
  {
    std::mt19937                           random(11);
    std::uniform_real_distribution<double> number(-1., 1.);
    std::vector<double>                    amplitudes(8);
    for (double &amplitude : amplitudes)
      amplitude = number(random);

    SystemState<2> state = at_rest(scene.problem);
    state.velocity       = interpolate(scene.meshes.finest(),
                                 [&](const unsigned int, const Point<2> &x) {
                                   return smooth_velocity(x, amplitudes);
                                 });
    // Stuck faults: no jump to begin with.
    NodalVector w = scene.problem.make_vector();
    scene.problem.to_jumps(w, state.velocity);
    stuck_mask(scene.problem.hierarchy()).apply(w);
    scene.problem.to_nodal(state.velocity, w);

    const double start   = energy(scene.problem, state);
    double       largest = 0., least_kinetic = start;
    for (unsigned int k = 0; k < 1000; ++k)
      {
        state   = step(scene.problem, state, step_size(k, changing));
        largest = std::max(largest,
                           std::abs(energy(scene.problem, state) / start - 1.));
        SystemState<2> moving = state;
        moving.displacement   = 0.;
        least_kinetic = std::min(least_kinetic, energy(scene.problem, moving));
      }
    EXPECT_GT(start, 0.);
    EXPECT_LT(largest, 1e-10);
    // The energy went to and fro.
    EXPECT_LT(least_kinetic, 0.9 * start);
  }
} // namespace



TEST(Newmark, KeepsTheEnergyOfAFreeBody)
{
  SpatialScene<2> scene = free_body(undamped(1)[0]);
  expect_energy_kept(scene, /*changing=*/false);
}



TEST(Newmark, KeepsTheEnergyWithChangingStepSizes)
{
  SpatialScene<2> scene = free_body(undamped(1)[0]);
  expect_energy_kept(scene, /*changing=*/true);
}



TEST(Newmark, KeepsTheEnergyOfBodiesThatStickTogether)
{
  SpatialScene<2> scene(stack<2>({make_body<2>(1., {{10, 2}}, 1),
                                  make_body<2>(0.5, {{7, 1}}, 1)}),
                        {},
                        undamped(2),
                        0.);
  expect_energy_kept(scene, /*changing=*/true);
}



namespace
{
  /** The first vibration of a free body: the lowest eigenvector of K u =
   * omega^2 M u that is no rigid motion. */
  struct Vibration
  {
    NodalVector shape;
    double      omega;

    explicit Vibration(const SpatialProblem<2> &problem)
    {
      std::tie(shape, omega) = free_vibration(problem, 3);
    }

    /** The coefficient of the vibration in a vector; nothing else may be in
     * it. */
    double
    amplitude(const NodalVector &u) const
    {
      const double coefficient = (u * shape) / (shape * shape);
      NodalVector  rest        = u;
      rest.add(-coefficient, shape);
      EXPECT_LT(rest.linfty_norm(), 1e-8);
      return coefficient;
    }

    SystemState<2>
    start(const SpatialProblem<2> &problem, const double velocity) const
    {
      SystemState<2> state = at_rest(problem);
      state.displacement   = shape;
      state.velocity.add(velocity, shape);
      return state;
    }
  };



  double
  error_after_two_periods(SpatialProblem<2> &problem,
                          const Vibration   &vibration,
                          const unsigned int n_steps)
  {
    const double   tau   = 2. * 2. * numbers::PI / vibration.omega / n_steps;
    SystemState<2> state = vibration.start(problem, 0.);
    state.acceleration.add(-vibration.omega * vibration.omega, vibration.shape);
    double error = 0.;
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        state = step(problem, state, tau);
        error = std::max(error,
                         std::abs(vibration.amplitude(state.displacement) -
                                  std::cos(vibration.omega * state.time)));
      }
    return error;
  }
} // namespace



TEST(Newmark, IsOfSecondOrderForAVibration)
{
  SpatialScene<2> scene = free_body(undamped(1)[0]);
  const Vibration vibration(scene.problem);
  double coarse = error_after_two_periods(scene.problem, vibration, 64);
  EXPECT_GT(coarse, 1e-4);
  for (const unsigned int n_steps : {128u, 256u, 512u})
    {
      const double fine =
        error_after_two_periods(scene.problem, vibration, n_steps);
      EXPECT_NEAR(std::log2(coarse / fine), 2., 0.05) << n_steps;
      coarse = fine;
    }
}



// The method turns a vibration by the angle 2 atan(omega tau / 2) a step and
// leaves its amplitude alone.
TEST(Newmark, TurnsAVibrationByItsExactDiscreteAngle)
{
  SpatialScene<2> scene = free_body(undamped(1)[0]);
  const Vibration vibration(scene.problem);
  const double    omega = vibration.omega, tau = 1.3 / omega;
  SystemState<2>  state = vibration.start(scene.problem, 0.);
  state.acceleration.add(-omega * omega, vibration.shape);
  for (unsigned int k = 1; k <= 100; ++k)
    {
      state              = step(scene.problem, state, tau);
      const double angle = k * 2. * std::atan(omega * tau / 2.);
      EXPECT_NEAR(vibration.amplitude(state.displacement),
                  std::cos(angle),
                  1e-10);
      EXPECT_NEAR(vibration.amplitude(state.velocity) / omega,
                  -std::sin(angle),
                  1e-10);
    }
}



// With the viscosities in the ratio of the elastic moduli, C = c K, each
// vibration decays by itself.
TEST(Newmark, DampsAVibrationAsItShould)
{
  Material     material;
  const double c           = 2e-3;
  material.shear_viscosity = c * material.shear_modulus();
  material.bulk_viscosity =
    c * (material.lame_lambda() + 2. / 3. * material.shear_modulus());
  SpatialScene<2> scene = free_body(material);
  const Vibration vibration(scene.problem);
  const double    omega = vibration.omega, decay = c * omega * omega / 2.;
  const double    damped = std::sqrt(omega * omega - decay * decay);
  ASSERT_GT(decay / omega, 0.02);

  const auto error = [&](const unsigned int n_steps) {
    const double   tau   = 2. * 2. * numbers::PI / omega / n_steps;
    SystemState<2> state = vibration.start(scene.problem, 0.);
    state.acceleration.add(-omega * omega, vibration.shape);
    for (unsigned int k = 0; k < n_steps; ++k)
      state = step(scene.problem, state, tau);
    return vibration.amplitude(state.displacement) -
           std::exp(-decay * state.time) *
             (std::cos(damped * state.time) +
              decay / damped * std::sin(damped * state.time));
  };
  const double coarse = error(256), fine = error(512);
  EXPECT_LT(std::abs(coarse), 1e-2);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.05);
}



TEST(Newmark, FreeFallIsExact)
{
  const double    g        = 9.81;
  SpatialScene<2> scene    = free_body(undamped(1)[0], g);
  SystemState<2>  state    = at_rest(scene.problem);
  const auto      vertical = [&](const double value) {
    return interpolate(scene.meshes.finest(),
                       [&](const unsigned int, const Point<2> &) {
                         return Tensor<1, 2>({0., value});
                       });
  };
  state.acceleration = vertical(-g);
  for (unsigned int k = 0; k < 20; ++k)
    state = step(scene.problem, state, step_size(k, true));
  state.displacement -= vertical(-0.5 * g * state.time * state.time);
  state.velocity -= vertical(-g * state.time);
  state.acceleration -= vertical(-g);
  EXPECT_LT(state.displacement.linfty_norm(), 1e-12);
  EXPECT_LT(state.velocity.linfty_norm(), 1e-12);
  EXPECT_LT(state.acceleration.linfty_norm(), 1e-8);
}
