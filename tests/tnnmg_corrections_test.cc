// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr Kind all_kinds[] = {Kind::coulomb, Kind::truncated, Kind::arcsinh};

  constexpr LinearCorrectionType direct_corrections[] =
    {LinearCorrectionType::umfpack, LinearCorrectionType::mumps};

  /** A state of the fault, and the shear traction relative to the normal
   * stress with which it is loaded. */
  struct Loading
  {
    std::string                                         name;
    double                                              traction;
    std::function<double(const double, const unsigned)> alpha;
  };

  const Loading loadings[] = {
    {"stuck", 0.3, [](const double, const unsigned) { return 0.; }},
    {"slipping", 0.9, [](const double, const unsigned) { return 0.; }},
    {"half and half",
     0.65,
     [](const double x, const unsigned) { return x < 0. ? 4. : -4.; }},
    {"wild", 0.65, [](const double, const unsigned k) {
       return (k % 2 == 0 ? 0.5 : -0.5) * std::log(1e8);
     }}};



  double
  energy_norm(const BlockMatrix<2> &A, const NodalVector &w)
  {
    NodalVector A_w = w;
    A.vmult(A_w, w);
    return std::sqrt(w * A_w);
  }



  /** The energy norm of the difference over that of @p exact. */
  double
  distance(const LevelHierarchy<2> &hierarchy,
           const NodalVector       &w,
           const NodalVector       &exact)
  {
    NodalVector difference = w;
    difference -= exact;
    return energy_norm(hierarchy.operators().matrix(), difference) /
           energy_norm(hierarchy.operators().matrix(), exact);
  }



  void
  scale(NodalVector &w, const NodeMask &fixed, const double factor)
  {
    for (unsigned int i = 0; i < fixed.n_nodes(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
        if (fixed.is_active(i, c))
          w.local_element(2 * i + c) *= factor;
  }



  TNNMGParameters
  tight()
  {
    TNNMGParameters parameters;
    parameters.tolerance = 1e-11;
    return parameters;
  }



  class NoCorrection : public LinearCorrection<2>
  {
  public:
    bool
    linearise(const std::vector<Tensor<2, 2>> &, const NodeMask &) override
    {
      return false;
    }

    unsigned int
    solve(NodalVector &x,
          NodalVector &A_x,
          NodalVector &,
          const double,
          const bool) override
    {
      x   = 0.;
      A_x = 0.;
      return 0;
    }
  };



  /** Calls action(friction, b, exact, iterations from zero, start) for all
   * cases, where @p exact is what TNNMG finds and start is zero, or exact
   * 1e10 times too fast. */
  template <typename Action>
  void
  for_all_cases(LayeredSlider &slider, const Action &action)
  {
    LevelHierarchy<2>    &hierarchy  = slider.problem.hierarchy();
    const TNNMGParameters parameters = tight();
    for (const double tau : {1e-5, 1e-3, 1e-1})
      for (const Loading &loading : loadings)
        {
          const NodalVector b =
            slider.set_step(tau, loading.traction * slider.normal_stress);
          for (const Kind kind : all_kinds)
            {
              SCOPED_TRACE(testing::Message() << loading.name << ", tau " << tau
                                              << ", kind " << kind);
              const Friction<2> friction = slider.friction(kind, loading.alpha);
              TNNMGSolver<2>    solver(hierarchy, parameters);
              NodalVector       exact = slider.start(), start = exact;
              const unsigned int from_zero =
                solver.solve(*friction.functional, b, exact).iterations.size();
              action(*friction.functional, b, exact, from_zero, start);

              start = exact;
              scale(start, hierarchy.finest().fixed, 1e10);
              NodalVector        w = start;
              const unsigned int too_fast =
                solver.solve(*friction.functional, b, w).iterations.size();
              action(*friction.functional, b, exact, too_fast, start);
            }
        }
  }
} // namespace



TEST(Corrections, LeadToTheSameSolution)
{
  LayeredSlider      slider({{4, 2}}, {{6, 2}}, 2);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  for_all_cases(slider,
                [&](const NonsmoothFunctional<2> &functional,
                    const NodalVector            &b,
                    const NodalVector            &exact,
                    const unsigned int            n_iterations,
                    const NodalVector            &start) {
                  for (const LinearCorrectionType type : direct_corrections)
                    {
                      SCOPED_TRACE(testing::Message() << "type " << int(type));
                      TNNMGParameters parameters   = tight();
                      parameters.linear_correction = type;
                      TNNMGSolver<2>     solver(hierarchy, parameters);
                      NodalVector        w = start;
                      const SolveSummary summary =
                        solver.solve(functional, b, w);
                      EXPECT_TRUE(summary.converged) << summary;
                      EXPECT_LE(summary.iterations.size(), n_iterations + 1)
                        << summary;
                      EXPECT_LE(distance(hierarchy, w, exact), 1e-9) << summary;
                    }
                });
}



TEST(Corrections, CondensedSolverFindsTheSameSolution)
{
  // Of TNNMG, and between the two solutions: for the table of hard cases.
  unsigned int most_iterations  = 0;
  double       largest_distance = 0;
  for (const unsigned int cells : {4, 6})
    {
      LayeredSlider         slider({{4, 2}}, {{cells, 2}}, 2);
      LevelHierarchy<2>    &hierarchy  = slider.problem.hierarchy();
      const TNNMGParameters parameters = tight();
      CondensedSolver<2>    solver(hierarchy.operators(), parameters);
      solver.find_correction_decrease();
      for_all_cases(
        slider,
        [&](const NonsmoothFunctional<2> &functional,
            const NodalVector            &b,
            const NodalVector            &exact,
            const unsigned int            n_iterations,
            const NodalVector            &start) {
          NodalVector        w       = start;
          const SolveSummary summary = solver.solve(functional, b, w);
          EXPECT_TRUE(summary.converged) << summary;
          EXPECT_LE(summary.iterations.size(), n_iterations + 2) << summary;
          const double error = distance(hierarchy, w, exact);
          EXPECT_LE(error, 1e-9) << summary;
          most_iterations  = std::max(most_iterations, n_iterations);
          largest_distance = std::max(largest_distance, error);
          for (const IterationSummary &iteration : summary.iterations)
            EXPECT_GE(iteration.smoother_decrease +
                        iteration.correction_decrease,
                      -1e-9 * iteration.iterate_norm * iteration.iterate_norm);
        });
      // The slider itself sets another operator between the cases.
      EXPECT_EQ(solver.n_condensed(), 3u);
    }
  std::ostringstream distances;
  distances << largest_distance;
  RecordProperty("most iterations", static_cast<int>(most_iterations));
  RecordProperty("largest distance", distances.str());
}



TEST(Corrections, VectorsOfSlip)
{
  FrictionChain<3>    chain;
  std::vector<double> alpha;
  for (unsigned int k = 0; k < 9; ++k)
    alpha.push_back((k % 2 == 0 ? 0.5 : -0.5) * std::log(1e8));
  for (const Kind kind : all_kinds)
    {
      SCOPED_TRACE(testing::Message() << "kind " << kind);
      const Friction<3>     friction   = chain.friction(kind, alpha);
      const TNNMGParameters parameters = tight();
      NodalVector           exact = chain.start, w = chain.start;
      ASSERT_TRUE(TNNMGSolver<3>(chain.hierarchy, parameters)
                    .solve(*friction.functional, chain.b, exact)
                    .converged);
      const SolveSummary summary =
        CondensedSolver<3>(chain.hierarchy.operators(), parameters)
          .solve(*friction.functional, chain.b, w);
      EXPECT_TRUE(summary.converged) << summary;
      w -= exact;
      EXPECT_LE(w.linfty_norm(), 1e-9 * exact.linfty_norm());
      for (const LinearCorrectionType type :
           {LinearCorrectionType::umfpack, LinearCorrectionType::mumps})
        {
          TNNMGParameters direct   = tight();
          direct.linear_correction = type;
          w                        = chain.start;
          EXPECT_TRUE(TNNMGSolver<3>(chain.hierarchy, direct)
                        .solve(*friction.functional, chain.b, w)
                        .converged);
          w -= exact;
          EXPECT_LE(w.linfty_norm(), 1e-9 * exact.linfty_norm());
        }
    }
}



TEST(Corrections, WithoutOneGaussSeidelIsLeft)
{
  FrictionChain<2>  chain;
  const Friction<2> friction =
    chain.friction(Kind::truncated, std::vector<double>(9, 0.));
  TNNMGParameters parameters = tight();
  NodalVector     exact = chain.start, w = chain.start;
  ASSERT_TRUE(TNNMGSolver<2>(chain.hierarchy, parameters)
                .solve(*friction.functional, chain.b, exact)
                .converged);
  parameters.max_iterations  = 100000;
  const SolveSummary summary = TNNMGSolver<2>(chain.operators,
                                              parameters,
                                              std::make_unique<NoCorrection>())
                                 .solve(*friction.functional, chain.b, w);
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.n_cycles(), 0u);
  EXPECT_GT(summary.iterations.size(), 20u);
  w -= exact;
  EXPECT_LE(w.linfty_norm(), 1e-6 * exact.linfty_norm());
}



TEST(Corrections, NewtonWithoutSmoothing)
{
  // The plain method has no difficulty if all of the fault slips.
  LayeredSlider      slider({{4, 2}}, {{6, 2}}, 2);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  const NodalVector  b = slider.set_step(1e-3, 0.9 * slider.normal_stress);
  const Friction<2>  friction =
    slider.friction(Kind::arcsinh, loadings[1].alpha);
  TNNMGParameters parameters = tight();
  NodalVector     exact      = slider.start();
  ASSERT_TRUE(TNNMGSolver<2>(hierarchy, parameters)
                .solve(*friction.functional, b, exact)
                .converged);
  parameters.nonlinear_smoothing = false;
  parameters.linear_correction   = LinearCorrectionType::mumps;
  NodalVector w                  = exact;
  scale(w, hierarchy.finest().fixed, 1.1);
  SolveSummary summary =
    TNNMGSolver<2>(hierarchy, parameters).solve(*friction.functional, b, w);
  EXPECT_TRUE(summary.converged) << summary;
  EXPECT_LE(distance(hierarchy, w, exact), 1e-9) << summary;
  for (const IterationSummary &iteration : summary.iterations)
    EXPECT_EQ(iteration.smoother_decrease, 0.);

  w = exact;
  scale(w, hierarchy.finest().fixed, 1.1);
  summary = CondensedSolver<2>(hierarchy.operators(), parameters)
              .solve(*friction.functional, b, w);
  EXPECT_TRUE(summary.converged) << summary;
  EXPECT_LE(distance(hierarchy, w, exact), 1e-9) << summary;
}



TEST(Corrections, OperatorsAreNumbered)
{
  LayeredSlider      slider({{4, 2}}, {{4, 2}}, 1);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  hierarchy.operators().combine({1., 0., 1.});
  const unsigned long first = hierarchy.operators().version();
  hierarchy.operators().combine({2., 0., 1.});
  EXPECT_NE(hierarchy.operators().version(), first);
  hierarchy.operators().combine({1., 0., 1.});
  EXPECT_EQ(hierarchy.operators().version(), first);
}



TEST(Corrections, TooLargeADenseMatrixIsRefused)
{
  Unknowns           unknowns;
  const unsigned int n = CondensedSolver<2>::max_entries / 2 + 1;
  unknowns.nodes       = serial_nodes(n, 2);
  unknowns.fixed       = NodeMask(n, 2);
  for (unsigned int i = 0; i < n; ++i)
    unknowns.nonsmooth_nodes.push_back(i);
  const auto no_couplings = std::make_shared<const BlockSparsity>(
    std::vector<std::vector<unsigned int>>(n));
  const OperatorSum<2>  operators(unknowns, {BlockMatrix<2>(no_couplings)});
  const TNNMGParameters parameters;
  try
    {
      CondensedSolver<2> solver(operators, parameters);
      ADD_FAILURE() << "nothing was thrown";
    }
  catch (const AgreedFailure &error)
    {
      EXPECT_STREQ(
        error.what(),
        "A condensed problem has at most 20000 unknowns at nonsmooth "
        "nodes, since its matrix is dense, but here are 20002.");
    }
}



TEST(Corrections, SingularMatricesAreNotSolved)
{
  // A matrix of zeros.
  FrictionChain<2>  chain;
  const Friction<2> friction =
    chain.friction(Kind::truncated, std::vector<double>(9, 0.));
  chain.hierarchy.operators().combine({0.});
  for (const LinearCorrectionType type :
       {LinearCorrectionType::umfpack, LinearCorrectionType::mumps})
    {
      TNNMGParameters parameters   = tight();
      parameters.linear_correction = type;
      const auto correction =
        make_linear_correction(chain.hierarchy, parameters);
      const std::vector<Tensor<2, 2>> hessians(9);
      const NodeMask                 &active = chain.hierarchy.finest().fixed;
      EXPECT_THROW(correction->linearise(hessians, active), SingularMatrix);
      // The correction is of use again after that.
      chain.hierarchy.operators().combine({1.});
      correction->linearise(hessians, active);
      chain.hierarchy.operators().combine({0.});
    }
  const TNNMGParameters parameters;
  CondensedSolver<2>    condensed(chain.hierarchy.operators(), parameters);
  EXPECT_THROW(condensed.start(chain.b, chain.start), SingularMatrix);
  chain.hierarchy.operators().combine({1.});
  NodalVector w = chain.start;
  EXPECT_TRUE(condensed.solve(*friction.functional, chain.b, w).converged);
}
