// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/multigrid/strong_lines.h>

#include <iostream>

#include "linear_iterations.h"
#include "opening_layers.h"
#include "parallel_comparison.h"
#include "random_vectors.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Cells ten times as tall as wide, and seven times above the fault, of which
   * processes have whole rows. */
  struct TallLayers : OpeningLayers<2>
  {
    explicit TallLayers(const MPI_Comm communicator)
      : OpeningLayers<2>({make_body<2>(1., {{100, 2}}, 2),
                          make_body<2>(1., {{70, 2}}, 2)},
                         /*opens=*/false,
                         /*opens_in_part=*/false,
                         communicator,
                         1)
    {}

    std::vector<NodeLine>
    lines()
    {
      LevelHierarchy<2> &hierarchy = problem.hierarchy();
      return find_strong_lines(hierarchy.operators().matrix().sparsity(),
                               hierarchy.operators().terms(),
                               hierarchy.finest().fixed,
                               hierarchy.finest().nonsmooth_nodes);
    }

    unsigned int
    longest_line()
    {
      std::size_t longest = 0;
      for (const NodeLine &line : lines())
        longest = std::max(longest, line.size());
      return longest;
    }

    unsigned int
    nodes_in_lines()
    {
      std::size_t n = 0;
      for (const NodeLine &line : lines())
        n += line.size();
      return n;
    }
  };



  struct Solution
  {
    NodalVector  w;
    SolveSummary summary;
  };

  Solution
  solve(TallLayers                                    &layers,
        const double                                   tau,
        const std::function<double(const Point<2> &)> &alpha)
  {
    TNNMGParameters parameters;
    parameters.tolerance = 1e-12;
    const NodalVector rhs =
      layers.set_step(tau, [](const Point<2> &x, const unsigned int) {
        return std::make_pair(0.6 + 0.3 * std::sin(3. * x[0]), 0.);
      });
    const Friction<2> friction = layers.friction(
      [&](const Point<2> &x, const unsigned int) { return alpha(x); });
    Solution       solution{layers.start(), {}};
    TNNMGSolver<2> solver(layers.problem.hierarchy(), parameters);
    solution.summary = solver.solve(*friction.functional, rhs, solution.w);
    return solution;
  }



  bool
  is_first()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }
} // namespace



TEST(ParallelLines, AreWhole)
{
  TallLayers shared(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  EXPECT_EQ(alone.longest_line(), 401u);
  EXPECT_EQ(Utilities::MPI::max(shared.longest_line(), MPI_COMM_WORLD), 401u);
  EXPECT_EQ(Utilities::MPI::sum(shared.nodes_in_lines(), MPI_COMM_WORLD),
            alone.nodes_in_lines());
}



TEST(ParallelLines, HaveTheSolutionOfOneProcess)
{
  TallLayers shared(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  for (const double tau : {1e-1, 1e-3})
    for (const auto &alpha :
         {+[](const Point<2> &) { return 2.; },
          +[](const Point<2> &x) { return x[0] < 0. ? -9. : 3.; },
          +[](const Point<2> &x) { return 8. * std::sin(40. * x[0]); }})
      {
        const Solution ours = solve(shared, tau, alpha),
                       one  = solve(alone, tau, alpha);
        ASSERT_TRUE(ours.summary.converged);
        ASSERT_TRUE(one.summary.converged);
        EXPECT_LE(one.summary.iterations.size(), 14u);
        // Rows that are cut take up to 67.
        EXPECT_LE(ours.summary.iterations.size(),
                  1.3 * one.summary.iterations.size());
        EXPECT_LT(difference(ours.w,
                             shared.problem.hierarchy().finest().nodes,
                             one.w,
                             numbers_on_one(shared.meshes.finest())),
                  1e-8);
        if (is_first())
          std::cout << ours.summary.iterations.size() << " iterations, "
                    << one.summary.iterations.size() << " on one process\n";
      }
}



TEST(ParallelLines, TakeTheStepsOfOneProcess)
{
  // Node by node it is 62 to 64 steps, and 20 to 27 with lines that are cut.
  TallLayers         layers(MPI_COMM_WORLD);
  LevelHierarchy<2> &hierarchy = layers.problem.hierarchy();
  layers.problem.combine(Newmark<2>().operator_coefficients(1e-1));
  for (const bool is_stuck : {false, true})
    {
      std::mt19937   engine;
      const NodeMask active =
        random_truncation(hierarchy.finest(), is_stuck ? 1. : 0., engine);
      linearise_without_friction(hierarchy, active);
      const unsigned int n = cg_iterations(
        hierarchy,
        random_vector(hierarchy.finest(),
                      active,
                      Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)));
      EXPECT_LE(n, 14u);
      if (is_first())
        std::cout << n << " steps\n";
    }
}
