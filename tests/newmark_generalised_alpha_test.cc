// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/generalised_alpha.h>
#include <stickslip/time/newmark.h>

#include <tuple>

#include "free_vibration.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A vibration of a free body of two cells, without viscosity. */
  struct Vibration
  {
    SpatialScene<2> scene;
    NodalVector     shape;
    double          omega;

    /** @p number counts from the lowest one; the rigid motions come first. */
    explicit Vibration(const unsigned int number)
      : scene(stack<2>({make_body<2>(1., {{2, 1}}, 0)}), {}, {elastic()}, 0.)
    {
      std::tie(shape, omega) = free_vibration(scene.problem, number);
    }

    static Material
    elastic()
    {
      Material material;
      material.shear_viscosity = 0.;
      material.bulk_viscosity  = 0.;
      return material;
    }

    /** From rest at the greatest displacement; the displacements after each
     * step, over the first one. */
    template <typename Scheme>
    std::vector<double>
    displacements(const Scheme      &scheme,
                  const double       tau,
                  const unsigned int n_steps)
    {
      SpatialProblem<2> &problem = scene.problem;
      SystemState<2>     state;
      state.displacement = shape;
      state.velocity     = problem.make_vector();
      state.acceleration = problem.make_vector();
      state.acceleration.add(-omega * omega, shape);
      std::vector<double> result;
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          SystemState<2> to = state;
          to.time           = state.time + tau;
          NodalVector w     = problem.make_vector();
          problem.to_jumps(w, state.velocity);
          solve_linear(problem,
                       scheme.operator_coefficients(tau),
                       stuck_mask(problem.hierarchy()),
                       scheme.right_hand_side(problem, state, tau),
                       w,
                       1e-12);
          problem.to_nodal(to.velocity, w);
          scheme.complete(to, state, tau);
          state = to;
          result.push_back((state.displacement * shape) / (shape * shape));
        }
      return result;
    }

    /** The largest error over two periods. */
    double
    error(const double rho, const unsigned int n_steps)
    {
      const double tau   = 4. * numbers::PI / omega / n_steps;
      const auto   u     = displacements(GeneralisedAlpha(rho), tau, n_steps);
      double       error = 0.;
      for (unsigned int k = 0; k < n_steps; ++k)
        error =
          std::max(error, std::abs(u[k] - std::cos(omega * (k + 1) * tau)));
      return error;
    }
  };



  struct NewmarksMethod
  {
    std::vector<double>
    operator_coefficients(const double tau) const
    {
      return Newmark::operator_coefficients(tau);
    }

    NodalVector
    right_hand_side(SpatialProblem<2>    &problem,
                    const SystemState<2> &from,
                    const double          tau) const
    {
      return Newmark::right_hand_side(problem, from, tau);
    }

    void
    complete(SystemState<2>       &to,
             const SystemState<2> &from,
             const double          tau) const
    {
      Newmark::complete(to, from, tau);
    }
  };

  constexpr unsigned int lowest = 3, highest = 11;
} // namespace



TEST(GeneralisedAlpha, WithoutDampingIsNewmarksMethod)
{
  Vibration    vibration(lowest);
  const double tau     = 0.7 / vibration.omega;
  const auto   newmark = vibration.displacements(NewmarksMethod(), tau, 30);
  const auto   u       = vibration.displacements(GeneralisedAlpha(1.), tau, 30);
  for (unsigned int k = 0; k < u.size(); ++k)
    EXPECT_NEAR(u[k], newmark[k], 1e-9);
}



TEST(GeneralisedAlpha, IsOfSecondOrder)
{
  Vibration vibration(lowest);
  for (const double rho : {0., 0.5, 0.8, 1.})
    {
      const double coarse = vibration.error(rho, 128),
                   fine   = vibration.error(rho, 256);
      EXPECT_LT(fine, 2e-2) << rho;
      EXPECT_NEAR(std::log2(coarse / fine), 2., 0.1) << rho;
    }
}



TEST(GeneralisedAlpha, DampsWhatIsTooFastForTheStep)
{
  // All roots tend to -rho; three in one place leave a factor n^2.
  Vibration              vibration(highest);
  const double           tau = 1e3 / vibration.omega;
  constexpr unsigned int n   = 30;
  for (const double rho : {0., 0.5, 0.8})
    {
      const double left =
        std::abs(vibration.displacements(GeneralisedAlpha(rho), tau, n).back());
      EXPECT_LT(left, 3. * n * n * std::pow(rho, n) + 1e-6) << rho;
      if (rho > 0.)
        {
          EXPECT_GT(left, 0.1 * std::pow(rho, n)) << rho;
        }
    }
  const auto u = vibration.displacements(GeneralisedAlpha(1.), tau, n);
  EXPECT_GT(std::abs(u.back()), 0.98);
}
