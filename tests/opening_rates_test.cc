// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "opening_iterations.h"

using namespace StickSlip;
using namespace StickSlip::Tests;
using Reference::Real;

namespace
{
  /** Two bodies, the cells of the upper one as many or more. */
  std::vector<BodyGeometry<2>>
  two_layers(const unsigned int upper_cells, const unsigned int passes)
  {
    return {make_body<2>(1., {{10, 2}}, passes),
            make_body<2>(1., {{upper_cells, 2}}, passes)};
  }



  /** The functional never increases, and the iterates keep to the bounds. */
  template <int dim>
  void
  expect_decrease(OpeningLayers<dim>                  &layers,
                  const Friction<dim>                 &friction,
                  const std::vector<Reference::Bound> &bounds,
                  const NodalVector                   &b,
                  NodalVector                          w)
  {
    const TNNMGParameters parameters;
    TNNMGSolver<dim>      solver(layers.problem.hierarchy(), parameters);
    solver.find_correction_decrease();
    const auto J = [&]() {
      return Reference::functional(
        layers.problem.hierarchy().operators().matrix(), b, friction.terms, w);
    };
    project(*friction.functional, friction.functional->nodes(), w);
    solver.start(b, w);
    Reference::Value old = J();
    for (unsigned int iteration = 0; iteration < 15; ++iteration)
      {
        const IterationSummary summary =
          solver.iterate(*friction.functional, b, w);
        const Reference::Value now      = J();
        const Real             decrease = old.value - now.value;
        EXPECT_GE(decrease, -1e-15L * now.size) << summary;
        EXPECT_LE(std::abs(summary.smoother_decrease +
                           summary.correction_decrease - decrease),
                  1e-13L * (old.size + now.size) + 1e-9L * std::abs(decrease));
        old = now;
        for (const Reference::Bound &bound : bounds)
          EXPECT_GE(bound.sign * w.local_element(bound.node * dim + dim - 1),
                    bound.value);
      }
  }
} // namespace



TEST(OpeningRates, IterationsAreAtMostTwiceThoseOfBilateralContact)
{
  for (const unsigned int upper_cells : {10, 14})
    for (const double tau : {1e-1, 1e-3, 1e-5})
      {
        std::vector<std::vector<unsigned int>> counts;
        for (const unsigned int passes : {1, 3})
          counts.push_back(
            expect_few_iterations<2>(std::to_string(upper_cells) + " cells, " +
                                       std::to_string(passes),
                                     two_layers(upper_cells, passes),
                                     tau));
        expect_level(counts);
      }
  for (const double tau : {1e-1, 1e-3})
    {
      expect_few_iterations<2>(
        "four faults",
        std::vector<BodyGeometry<2>>(5, make_body<2>(1., {{10, 2}}, 2)),
        tau);
      expect_few_iterations<3>("three dimensions",
                               {make_body<3>(1., {{5, 5, 2}}, 1),
                                make_body<3>(1., {{7, 7, 2}}, 1)},
                               tau);
    }
}



TEST(OpeningRates, FunctionalDecreasesInEveryIteration)
{
  OpeningLayers<2> layers(two_layers(14, 2), true);
  OpeningLayers<3> blocks({make_body<3>(1., {{3, 3, 1}}, 1),
                           make_body<3>(1., {{4, 4, 1}}, 1)},
                          true);
  for (const double tau : {1e-1, 1e-4})
    for (const Start start : all_starts)
      {
        const auto expect_decrease_in = [&](auto &scene) {
          constexpr int dim =
            std::remove_reference_t<decltype(scene)>::dimension;
          Friction<dim>     friction = scene.friction(rough_alpha<dim>);
          const auto        bounds   = scene.let_open(friction, some_gaps<dim>);
          const NodalVector b = scene.set_step(tau, alternating_traction<dim>);
          NodalVector       scaled = scene.start();
          for (unsigned int i = 0; i < scaled.locally_owned_size(); ++i)
            scaled.local_element(i) = 1e-3 * std::sin(7. * i);
          expect_decrease(
            scene, friction, bounds, b, make_start(scene, start, scaled));
        };
        expect_decrease_in(layers);
        expect_decrease_in(blocks);
      }
}



TEST(OpeningRates, FindTheMinimiserOfAnIndependentMethod)
{
  for (const unsigned int upper_cells : {4, 6})
    for (const double tau : {1e-1, 1e-3})
      {
        OpeningLayers<2>   layers({make_body<2>(1., {{4, 1}}, 2),
                                   make_body<2>(1., {{upper_cells, 1}}, 2)},
                                true);
        const NodalVector  b = layers.set_step(tau, alternating_traction<2>);
        Friction<2>        friction  = layers.friction(rough_alpha<2>);
        const auto         bounds    = layers.let_open(friction, some_gaps<2>);
        LevelHierarchy<2> &hierarchy = layers.problem.hierarchy();
        const Reference::DenseProblem<2> dense(hierarchy.operators().matrix(),
                                               hierarchy.finest().fixed,
                                               b,
                                               layers.start(),
                                               friction.terms,
                                               bounds);
        const std::vector<Real>          exact = dense.minimise();
        TNNMGParameters                  parameters;
        parameters.tolerance = 1e-10;
        TNNMGSolver<2> solver(hierarchy, parameters);
        NodalVector    solution;
        for (const Start start : all_starts)
          {
            NodalVector w = make_start(layers, start, solution);
            EXPECT_TRUE(solver.solve(*friction.functional, b, w).converged);
            std::vector<Real> difference = dense.free_components(w);
            const Real        size       = dense.energy_norm(exact);
            for (unsigned int i = 0; i < exact.size(); ++i)
              difference[i] -= exact[i];
            EXPECT_LE(dense.energy_norm(difference), 1e-8L * size);
            EXPECT_LE(dense.distance_from_minimiser(w), 1e-8L * size);
            if (start == Start::zero)
              solution = w;
          }
        const unsigned int n = layers.n_open(friction, solution);
        EXPECT_GT(n, 3u);
        EXPECT_LT(n, bounds.size());
      }
}



TEST(OpeningRates, FindTheMinimiserInThreeDimensions)
{
  OpeningLayers<3>   layers({make_body<3>(1., {{2, 2, 1}}, 1),
                             make_body<3>(1., {{3, 3, 1}}, 1)},
                          true);
  LevelHierarchy<3> &hierarchy = layers.problem.hierarchy();
  for (const double tau : {1e-1, 1e-3})
    {
      const NodalVector b = layers.set_step(tau, alternating_traction<3>);
      Friction<3>       friction = layers.friction(rough_alpha<3>);
      const auto        bounds   = layers.let_open(friction, some_gaps<3>);
      const Reference::DenseProblem<3> dense(hierarchy.operators().matrix(),
                                             hierarchy.finest().fixed,
                                             b,
                                             layers.start(),
                                             friction.terms,
                                             bounds);
      TNNMGParameters                  parameters;
      parameters.tolerance = 1e-10;
      NodalVector w        = layers.start();
      EXPECT_TRUE(TNNMGSolver<3>(hierarchy, parameters)
                    .solve(*friction.functional, b, w)
                    .converged);
      EXPECT_LE(dense.distance_from_minimiser(w),
                1e-8L * dense.energy_norm(dense.free_components(w)));
      EXPECT_GT(layers.n_open(friction, w), 3u);
      EXPECT_LT(layers.n_open(friction, w), bounds.size());
    }
}
