// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/multigrid/strong_lines.h>

#include <iostream>

#include "linear_iterations.h"
#include "opening_layers.h"
#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Cells ten times as tall as wide, and seven times above the fault, where
   * processes divide the rows. */
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

    std::size_t
    longest_line()
    {
      LevelHierarchy<2> &hierarchy = problem.hierarchy();
      std::size_t        longest   = 0;
      for (const NodeLine &line :
           find_strong_lines(hierarchy.operators().matrix().sparsity(),
                             hierarchy.operators().terms(),
                             hierarchy.finest().fixed,
                             hierarchy.finest().nonsmooth_nodes))
        longest = std::max(longest, line.size());
      return longest;
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



TEST(ParallelLines, EndAtTheirProcess)
{
  TallLayers shared(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  EXPECT_EQ(alone.longest_line(), 401u);
  // On each process there is a share of the long rows.
  EXPECT_GE(shared.longest_line(), 400u / n_processes() / 2);
  EXPECT_LE(shared.longest_line(), 401u);
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



TEST(ParallelLines, SaveStepsWhereTheyAreCutToo)
{
  // Node by node, on one process as on four, it is 62 to 64 steps.
  TallLayers         layers(MPI_COMM_WORLD);
  LevelHierarchy<2> &hierarchy = layers.problem.hierarchy();
  layers.problem.combine(Newmark<2>().operator_coefficients(1e-1));
  for (const bool is_stuck : {false, true})
    {
      NodeMask active = hierarchy.finest().fixed;
      if (is_stuck)
        for (const unsigned int p : hierarchy.finest().nonsmooth_nodes)
          active.mask(p, 0);
      hierarchy.linearise(std::vector<Tensor<2, 2>>(
                            hierarchy.finest().nonsmooth_nodes.size()),
                          active);
      std::mt19937 engine(3 + Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
      std::normal_distribution<double> normal;
      NodalVector                      x = layers.problem.make_vector();
      for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
        x.local_element(i) = normal(engine);
      active.apply(x);
      const unsigned int n = cg_iterations(hierarchy, x);
      EXPECT_LE(n, n_processes() == 1 ? 14u : 40u);
      if (is_first())
        std::cout << n << " steps\n";
    }
}
