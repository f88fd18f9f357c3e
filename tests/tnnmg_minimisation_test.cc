// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <limits>

#include "layered_slider.h"
#include "nan_in_debug_mode.h"

using namespace StickSlip;
using namespace StickSlip::Tests;
using Reference::Real;

namespace
{
  constexpr Kind all_kinds[] = {Kind::coulomb, Kind::truncated, Kind::arcsinh};

  /** Far beyond the change of the functional by rounding of the iterate; the
   * decreases in the tests are up to sixteen orders larger. */
  constexpr Real rounding = 1e-15L;

  /** States that change by eight decades of theta from node to node. */
  double
  rough_state(const double, const unsigned int k)
  {
    return (k % 2 == 0 ? 0.5 : -0.5) * std::log(1e8);
  }

  std::vector<double>
  rough_states()
  {
    std::vector<double> alpha;
    for (unsigned int k = 0; k < 9; ++k)
      alpha.push_back(rough_state(0., k));
    return alpha;
  }



  /** Set the components that take part to random numbers. */
  template <int dim>
  void
  randomise(NodalVector &w, const NodeMask &fixed, const double size)
  {
    std::mt19937                     engine(3);
    std::normal_distribution<double> normal;
    for (unsigned int i = 0; i < fixed.n_nodes(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        if (fixed.is_active(i, c))
          w.local_element(i * dim + c) = size * normal(engine);
  }

  template <int dim>
  void
  scale(NodalVector &w, const NodeMask &fixed, const double factor)
  {
    for (unsigned int i = 0; i < fixed.n_nodes(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        if (fixed.is_active(i, c))
          w.local_element(i * dim + c) *= factor;
  }



  /** The functional never increases, sweep by sweep and iteration by
   * iteration, and the summaries tell the truth about it. */
  template <int dim>
  void
  expect_decrease(LevelHierarchy<dim> &hierarchy,
                  const Friction<dim> &friction,
                  const NodalVector   &b,
                  const NodalVector   &start)
  {
    const auto J = [&](const NodalVector &w) {
      return Reference::functional(hierarchy.operators().matrix(),
                                   b,
                                   friction.terms,
                                   w);
    };

    const NonlinearGaussSeidel<dim> smoother(hierarchy.operators());
    const BlockMatrix<dim>         &A = hierarchy.operators().matrix();
    NodalVector                     w = start, r = b, exact = b;
    A.residual(r, b, w);
    Reference::Value old = J(w);
    for (unsigned int sweep = 0; sweep < 20; ++sweep)
      {
        smoother.sweep(*friction.functional,
                       /*is_everywhere=*/sweep % 2 == 0,
                       w,
                       r);
        A.residual(exact, b, w);
        exact -= r;
        EXPECT_LE(exact.linfty_norm(),
                  1e-13 * (b.linfty_norm() + r.linfty_norm()));
        const Reference::Value now = J(w);
        EXPECT_LE(now.value, old.value + rounding * now.size);
        old = now;
      }

    TNNMGParameters  parameters;
    TNNMGSolver<dim> solver(hierarchy, parameters);
    solver.find_correction_decrease();
    w   = start;
    old = J(w);
    solver.start(b, w);
    double total = 0;
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        NodalVector smoothed = w;
        A.residual(r, b, w);
        const IterationSummary summary =
          solver.iterate(*friction.functional, b, w);
        const Reference::Value now = J(w);

        smoother.sweep(*friction.functional,
                       summary.sweeps_everywhere,
                       smoothed,
                       r);
        const Reference::Value between = J(smoothed);
        SCOPED_TRACE(testing::Message() << iteration << ": " << summary);
        EXPECT_LE(now.value, between.value + rounding * between.size);
        EXPECT_LE(between.value, old.value + rounding * between.size);

        const auto expect_near =
          [](const double decrease, const Real exact, const Real size) {
            EXPECT_LE(std::abs(decrease - exact),
                      1e-13L * size + 1e-9L * std::abs(exact));
          };
        expect_near(summary.smoother_decrease,
                    old.value - between.value,
                    old.size);
        expect_near(summary.correction_decrease,
                    between.value - now.value,
                    between.size);
        total += summary.smoother_decrease + summary.correction_decrease;
        old = now;
      }
    EXPECT_GT(total, 0.);
  }



  /** From all starting values to the minimiser @p exact, if it is given, and
   * by the bound from the subgradient where that is one. */
  template <int dim>
  void
  expect_minimiser(LevelHierarchy<dim>     &hierarchy,
                   const Friction<dim>     &friction,
                   const NodalVector       &b,
                   const NodalVector       &zero,
                   const std::vector<Real> *exact)
  {
    const NodeMask                    &fixed = hierarchy.finest().fixed;
    const Reference::DenseProblem<dim> dense(
      hierarchy.operators().matrix(), fixed, b, zero, friction.terms);
    TNNMGParameters parameters;
    parameters.tolerance = 1e-10;
    TNNMGSolver<dim> solver(hierarchy, parameters);

    NodalVector w = zero;
    for (unsigned int start = 0; start < 4; ++start)
      {
        SCOPED_TRACE(testing::Message() << "starting value " << start);
        if (start == 1)
          w = zero, randomise<dim>(w, fixed, 1e-3);
        if (start == 2)
          // The present solution, 1e10 times too fast.
          scale<dim>(w, fixed, 1e10);
        if (start == 3)
          w = zero, randomise<dim>(w, fixed, 1e6);
        const SolveSummary summary = solver.solve(*friction.functional, b, w);
        EXPECT_TRUE(summary.converged) << summary;
        // Twice what was found for the harder ones.
        EXPECT_LE(summary.iterations.size(), 40u) << summary;

        const std::vector<Real> v    = dense.free_components(w);
        const Real              size = dense.energy_norm(v);
        if (friction.terms[0].kind != Kind::coulomb)
          {
            EXPECT_LE(dense.distance_from_minimiser(w), 1e-8L * size);
          }
        if (exact != nullptr)
          {
            std::vector<Real> difference = v;
            Real              fastest    = 0;
            for (unsigned int i = 0; i < v.size(); ++i)
              difference[i] -= (*exact)[i];
            for (const unsigned int t : dense.tangential)
              fastest = std::max(fastest, std::abs((*exact)[t]));
            EXPECT_LE(dense.energy_norm(difference), 1e-8L * size);
            for (const unsigned int t : dense.tangential)
              EXPECT_LE(std::abs(difference[t]), 1e-8L * fastest);
          }
        for (unsigned int i = 0; i < fixed.n_nodes(); ++i)
          for (unsigned int c = 0; c < dim; ++c)
            if (!fixed.is_active(i, c))
              {
                EXPECT_EQ(w.local_element(i * dim + c),
                          zero.local_element(i * dim + c));
              }
      }
  }

  void
  expect_dense_minimiser(LevelHierarchy<2> &hierarchy,
                         const Friction<2> &friction,
                         const NodalVector &b,
                         const NodalVector &zero)
  {
    const std::vector<Real> exact =
      Reference::DenseProblem<2>(hierarchy.operators().matrix(),
                                 hierarchy.finest().fixed,
                                 b,
                                 zero,
                                 friction.terms)
        .minimise();
    expect_minimiser(hierarchy, friction, b, zero, &exact);
  }
} // namespace



TEST(TNNMG, FunctionalDecreasesOnAChain)
{
  FrictionChain<2> chain;
  FrictionChain<3> chain_3d;
  for (const Kind kind : all_kinds)
    for (const double size : {0., 1e-6, 1e-2, 1e6})
      {
        SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << size);
        NodalVector w = chain.start;
        randomise<2>(w, chain.hierarchy.finest().fixed, size);
        expect_decrease(chain.hierarchy,
                        chain.friction(kind, rough_states()),
                        chain.b,
                        w);
        w = chain_3d.start;
        randomise<3>(w, chain_3d.hierarchy.finest().fixed, size);
        expect_decrease(chain_3d.hierarchy,
                        chain_3d.friction(kind, rough_states()),
                        chain_3d.b,
                        w);
      }
}



TEST(TNNMG, FunctionalDecreasesOnASlider)
{
  LayeredSlider     slider({{4, 2}}, {{6, 2}}, 2);
  const NodalVector b = slider.set_step(1e-2, 0.65 * slider.normal_stress);
  for (const Kind kind : all_kinds)
    for (const double size : {0., 1e-6, 1e-2, 1e6})
      {
        SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << size);
        NodalVector w = slider.start();
        randomise<2>(w, slider.problem.hierarchy().finest().fixed, size);
        expect_decrease(slider.problem.hierarchy(),
                        slider.friction(kind, rough_state),
                        b,
                        w);
      }
}



TEST(TNNMG, FindsTheMinimiserOnAChain)
{
  FrictionChain<2> chain;
  for (const Kind kind : all_kinds)
    {
      SCOPED_TRACE(testing::Message() << "kind " << kind);
      expect_dense_minimiser(chain.hierarchy,
                             chain.friction(kind, rough_states()),
                             chain.b,
                             chain.start);
      expect_dense_minimiser(chain.hierarchy,
                             chain.friction(kind, std::vector<double>(9, 0.)),
                             chain.b,
                             chain.start);
    }
}



TEST(TNNMG, FindsTheMinimiserWithVectorsOfSlip)
{
  FrictionChain<3> chain;
  for (const Kind kind : {Kind::truncated, Kind::arcsinh})
    {
      SCOPED_TRACE(testing::Message() << "kind " << kind);
      expect_minimiser(chain.hierarchy,
                       chain.friction(kind, rough_states()),
                       chain.b,
                       chain.start,
                       nullptr);
    }
}



TEST(TNNMG, FindsTheMinimiserOnASlider)
{
  // Meshes that match at the fault, and others that do not.
  for (const unsigned int cells : {4, 6})
    for (const double traction : {0.3, 0.65, 0.9})
      {
        LayeredSlider     slider({{4, 2}}, {{cells, 2}}, 2);
        const NodalVector b =
          slider.set_step(1e-2, traction * slider.normal_stress);
        for (const Kind kind : all_kinds)
          {
            SCOPED_TRACE(testing::Message() << cells << " cells, " << traction
                                            << ", kind " << kind);
            expect_dense_minimiser(slider.problem.hierarchy(),
                                   slider.friction(kind, rough_state),
                                   b,
                                   slider.start());
          }
      }
}



TEST(TNNMG, NumbersThatAreNoneDoNotConverge)
{
  SKIP_WHERE_NAN_IS_FATAL();
  LayeredSlider      slider({{4, 2}}, {{6, 2}}, 2);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  const NodalVector  b   = slider.set_step(1e-2, 0.65 * slider.normal_stress);
  const double       nan = std::numeric_limits<double>::quiet_NaN();
  TNNMGParameters    parameters;

  // Once at a jump, and once at any component that is free before that.
  const unsigned int jump  = 2 * hierarchy.finest().nonsmooth_nodes[5];
  unsigned int       other = jump - 2;
  while (!hierarchy.finest().fixed.is_active(other / 2, 0) ||
         std::binary_search(hierarchy.finest().nonsmooth_nodes.begin(),
                            hierarchy.finest().nonsmooth_nodes.end(),
                            other / 2))
    other -= 2;
  for (const Kind kind : all_kinds)
    for (const unsigned int entry : {jump, other})
      {
        TNNMGSolver<2>    solver(hierarchy, parameters);
        const Friction<2> friction = slider.friction(kind, rough_state);
        NodalVector       bad = b, w = slider.start();
        bad.local_element(entry) = nan;
        SolveSummary summary     = solver.solve(*friction.functional, bad, w);
        EXPECT_FALSE(summary.converged) << summary;
        EXPECT_LE(summary.iterations.size(), 2u);

        // Nothing of it is left in the next solve.
        w       = slider.start();
        summary = solver.solve(*friction.functional, b, w);
        EXPECT_TRUE(summary.converged) << summary;
        EXPECT_TRUE(std::isfinite(w.l2_norm()));

        w.local_element(entry) = nan;
        summary                = solver.solve(*friction.functional, b, w);
        EXPECT_TRUE(!summary.converged || std::isfinite(w.l2_norm()));
      }
}



TEST(TNNMG, TooFewIterationsDoNotConverge)
{
  FrictionChain<2>   chain;
  const Friction<2>  friction = chain.friction(Kind::truncated, rough_states());
  TNNMGParameters    parameters;
  TNNMGSolver<2>     solver(chain.hierarchy, parameters);
  NodalVector        w    = chain.start;
  const SolveSummary full = solver.solve(*friction.functional, chain.b, w);
  ASSERT_TRUE(full.converged);
  ASSERT_GT(full.iterations.size(), 1u);

  parameters.max_iterations = full.iterations.size() - 1;
  w                         = chain.start;
  const SolveSummary capped = solver.solve(*friction.functional, chain.b, w);
  EXPECT_FALSE(capped.converged);
  EXPECT_EQ(capped.iterations.size(), parameters.max_iterations);
}
