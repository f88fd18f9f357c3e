// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/condensed/condensed_solver.h>

#include "opening_iterations.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The iterations of the condensed problem from all starts and from 1e10
   * times too fast; all ends are the result of TNNMG. */
  template <int dim>
  std::vector<unsigned int>
  condensed_iterations(OpeningLayers<dim>  &layers,
                       const Friction<dim> &friction,
                       const double         tau)
  {
    const NodalVector    b = layers.set_step(tau, alternating_traction<dim>);
    LevelHierarchy<dim> &hierarchy = layers.problem.hierarchy();
    TNNMGParameters      parameters;
    parameters.tolerance  = 1e-10;
    NodalVector reference = layers.start();
    EXPECT_TRUE(TNNMGSolver<dim>(hierarchy, parameters)
                  .solve(*friction.functional, b, reference)
                  .converged);

    parameters.tolerance = 1e-8;
    CondensedSolver<dim>      condensed(hierarchy.operators(), parameters);
    std::vector<unsigned int> counts;
    std::vector<NodalVector>  starts;
    for (const Start start : all_starts)
      starts.push_back(make_start(layers, start, reference));
    NodalVector faster = reference;
    faster *= 1e4;
    starts.push_back(make_start(layers, Start::too_fast, faster));
    for (NodalVector &w : starts)
      {
        const SolveSummary summary =
          condensed.solve(*friction.functional, b, w);
        EXPECT_TRUE(summary.converged) << summary;
        counts.push_back(summary.iterations.size());
        NodalVector difference = w;
        difference -= reference;
        EXPECT_LE(difference.linfty_norm(), 1e-7 * reference.linfty_norm());
        EXPECT_EQ(layers.n_open(friction, w),
                  layers.n_open(friction, reference));
      }
    return counts;
  }



  template <int dim>
  void
  expect_few_condensed_iterations(const std::vector<BodyGeometry<dim>> &bodies)
  {
    OpeningLayers<dim> opening(bodies, true), bilateral(bodies, false);
    for (const double tau : {1e-1, 1e-3})
      {
        Friction<dim> friction = opening.friction(rough_alpha<dim>);
        opening.let_open(friction, some_gaps<dim>);
        const auto with = condensed_iterations(opening, friction, tau);
        const auto without =
          condensed_iterations(bilateral,
                               bilateral.friction(rough_alpha<dim>),
                               tau);
        std::cout << dim << " dimensions, tau = " << tau << ':';
        for (unsigned int i = 0; i < with.size(); ++i)
          {
            std::cout << ' ' << with[i] << " (" << without[i] << ')';
            EXPECT_LE(with[i], 2 * without[i]);
          }
        std::cout << std::endl;
      }
  }
} // namespace



TEST(OpeningCondensed, TakesAsManyIterationsAndFindsTheSame)
{
  expect_few_condensed_iterations<2>(
    {make_body<2>(1., {{10, 2}}, 2), make_body<2>(1., {{14, 2}}, 2)});
  expect_few_condensed_iterations<2>(
    std::vector<BodyGeometry<2>>(4, make_body<2>(1., {{10, 2}}, 1)));
  expect_few_condensed_iterations<3>(
    {make_body<3>(1., {{5, 5, 2}}, 1), make_body<3>(1., {{7, 7, 2}}, 0)});
}
