// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/nested_start.h>
#include <stickslip/tnnmg/sampled_functional.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  double
  slipping(const double, const unsigned int)
  {
    return -9.;
  }

  double
  half_slipping(const double x, const unsigned int)
  {
    return x < 0 ? -9. : 9.;
  }

  double
  nucleating(const double x, const unsigned int)
  {
    return std::abs(x) < 0.8 ? -11.5 : 13.8;
  }



  /** A step of size @p tau with a state of the fault. */
  struct Step
  {
    LayeredSlider slider = LayeredSlider({{10, 2}}, {{14, 2}}, 7);
    NodalVector   rhs;
    Friction<2>   friction;

    Step(const double                                                   tau,
         const std::function<double(const double, const unsigned int)> &alpha)
      : rhs(slider.set_step(tau, 2.8e4))
      , friction(slider.friction(Kind::truncated, alpha))
    {}

    SolveSummary
    solve(NodalVector &w)
    {
      TNNMGParameters parameters;
      parameters.tolerance = 1e-9;
      TNNMGSolver<2> solver(slider.problem.hierarchy(), parameters);
      return solver.solve(*friction.functional, rhs, w);
    }

    /** A start that is zero in all respects but one: that it is not. */
    NodalVector
    nearly_zero()
    {
      NodalVector w = slider.start();
      w.local_element(
        2 * slider.problem.hierarchy().finest().nonsmooth_nodes.front()) =
        1e-200;
      return w;
    }

    /** The start that the coarse level gives. */
    NodalVector
    nested()
    {
      LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
      NodalVector        w = slider.start(), residual = w;
      hierarchy.operators().matrix().residual(residual, rhs, w);
      hierarchy.take_over_operator();
      const bool is_done = add_coarse_minimiser(
        hierarchy, *friction.functional, TNNMGParameters(), residual, w);
      NodalVector change = w;
      change -= slider.start();
      EXPECT_EQ(is_done, change.linfty_norm() > 0.);
      return w;
    }

    /** J(w) - J(v). */
    double
    energy_over(const NodalVector &w, const NodalVector &v) const
    {
      NodalVector d = w, sum = w, A_sum = w;
      d -= v;
      sum += v;
      slider.problem.operators().matrix().vmult(A_sum, sum);
      return 0.5 * (d * A_sum) - d * rhs +
             increase(*friction.functional, friction.functional->nodes(), w, v);
    }
  };
} // namespace



TEST(NestedStart, SavesIterationsOfLargeStepsFromZero)
{
  unsigned int n_nested = 0, n_plain = 0;
  for (const double tau : {0.01, 0.1, 1.})
    for (const auto alpha : {slipping, half_slipping, nucleating})
      {
        Step               step(tau, alpha);
        NodalVector        w = step.slider.start(), v = step.nearly_zero();
        const SolveSummary nested = step.solve(w), plain = step.solve(v);
        ASSERT_TRUE(nested.converged);
        ASSERT_TRUE(plain.converged);
        EXPECT_LE(nested.iterations.size(), plain.iterations.size() + 1);
        n_nested += nested.iterations.size();
        n_plain += plain.iterations.size();
        v -= w;
        EXPECT_LT(v.l2_norm(), 1e-7 * w.l2_norm());
      }
  std::cout << n_nested << " iterations, without it " << n_plain << std::endl;
  EXPECT_LT(n_nested, 0.9 * n_plain);
}



TEST(NestedStart, IsNearTheSolution)
{
  Step              step(1., slipping);
  const NodalVector zero = step.slider.start(), start = step.nested();
  NodalVector       w = zero;
  ASSERT_TRUE(step.solve(w).converged);
  // All that is to be gained but for a hundredth.
  EXPECT_LT(step.energy_over(start, w), 0.01 * step.energy_over(zero, w));
  EXPECT_GT(step.energy_over(start, w), 0.);
  // Fixed components are as they were.
  const LevelDescription<2> &finest = step.slider.problem.hierarchy().finest();
  for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
    for (const unsigned int c : {0, 1})
      if (!finest.fixed.is_active(i, c))
        {
          EXPECT_EQ(start.local_element(2 * i + c),
                    zero.local_element(2 * i + c));
        }
}



TEST(NestedStart, LeavesSmallStepsAlone)
{
  // Waves pass a small part of a coarse cell.
  Step        step(1e-5, slipping);
  NodalVector start = step.nested();
  start -= step.slider.start();
  EXPECT_EQ(start.linfty_norm(), 0.);
}



TEST(NestedStart, DependsOnNothingBefore)
{
  Step              step(0.1, half_slipping);
  const NodalVector first = step.nested();
  NodalVector       w     = step.slider.start();
  ASSERT_TRUE(step.solve(w).converged);
  NodalVector second = step.nested();
  second -= first;
  EXPECT_EQ(second.linfty_norm(), 0.);
}



TEST(SampledFunctional, MultipliesTerms)
{
  Step                            step(0.1, slipping);
  const NonsmoothFunctional<2>   &all     = *step.friction.functional;
  const unsigned int              n       = all.nodes().size();
  const std::vector<unsigned int> terms   = {n - 1, 3};
  const std::vector<double>       factors = {8., 0.25};
  const SampledFunctional<2>      some(all, {5, 7}, terms, factors);
  EXPECT_EQ(some.nodes(), std::vector<unsigned int>({5, 7}));
  const Tensor<1, 2> v({2e-4, 0.}), d({-3e-6, 0.}), force({1e3, 0.}), zero;
  for (const unsigned int k : {0, 1})
    {
      const unsigned int t = terms[k];
      const double       f = factors[k];
      EXPECT_DOUBLE_EQ(some.value(k, v), f * all.value(t, v));
      EXPECT_DOUBLE_EQ(some.directional_derivative(k, v, d),
                       f * all.directional_derivative(t, v, d));
      EXPECT_DOUBLE_EQ(some.gradient(k, v)[0], f * all.gradient(t, v)[0]);
      EXPECT_DOUBLE_EQ(some.hessian(k, v)[0][0], f * all.hessian(t, v)[0][0]);
      EXPECT_DOUBLE_EQ(some.secant_hessian(k, v, force)[0][0],
                       f * all.secant_hessian(t, v, force / f)[0][0]);
      EXPECT_EQ(some.is_smooth(k, v), all.is_smooth(t, v));
      EXPECT_EQ(some.acts_on(k, 1), all.acts_on(t, 1));

      // The gradient of what is minimised is zero at the minimiser.
      Tensor<2, 2> A;
      A[0][0] = A[1][1]    = 1e7;
      const Tensor<1, 2> r = some.gradient(k, v) + A * v;
      const Tensor<1, 2> w = some.minimise(k, A, r, {{true, false}}, zero);
      EXPECT_NEAR(w[0], v[0], 1e-10 * v[0]);
    }
}
