// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/multigrid/strong_lines.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <iostream>

#include "layered_slider.h"
#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Cells ten times as tall as wide, and seven times above the fault, where
   * processes divide the rows. */
  struct TallSlider : LayeredSlider
  {
    explicit TallSlider(const MPI_Comm communicator)
      : LayeredSlider({{100, 2}}, {{70, 2}}, 2, communicator, 1)
    {}

    /** The number of nodes of the longest line on this process. */
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
  solve(TallSlider                                                &slider,
        const double                                               tau,
        const std::function<double(const double, const unsigned)> &alpha)
  {
    TNNMGParameters parameters;
    parameters.tolerance       = 1e-12;
    const NodalVector rhs      = slider.set_step(tau, 2.5e4);
    const Friction<2> friction = slider.friction(Kind::truncated, alpha);
    Solution          solution{slider.start(), {}};
    TNNMGSolver<2>    solver(slider.problem.hierarchy(), parameters);
    solution.summary = solver.solve(*friction.functional, rhs, solution.w);
    return solution;
  }
} // namespace



TEST(ParallelLines, EndAtTheirProcess)
{
  TallSlider shared(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  EXPECT_EQ(alone.longest_line(), 401u);
  // On each process there is a share of the long rows.
  EXPECT_GE(shared.longest_line(), 400u / n_processes() / 2);
  const std::size_t longest =
    Utilities::MPI::max(shared.longest_line(), MPI_COMM_WORLD);
  if (n_processes() > 1)
    {
      EXPECT_LT(longest, 401u);
    }
  else
    {
      EXPECT_EQ(longest, 401u);
    }
}



TEST(ParallelLines, HaveTheSolutionOfOneProcess)
{
  TallSlider shared(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  for (const double tau : {1e-1, 1e-3})
    for (const auto &alpha :
         {+[](const double, const unsigned) { return 2.; },
          +[](const double x, const unsigned) { return x < 0. ? -9. : 3.; },
          +[](const double, const unsigned k) {
            return 8. * std::sin(12.9898 * (k + 1.));
          }})
      {
        const Solution ours = solve(shared, tau, alpha),
                       one  = solve(alone, tau, alpha);
        ASSERT_TRUE(ours.summary.converged);
        ASSERT_TRUE(one.summary.converged);
        EXPECT_LE(ours.summary.iterations.size(),
                  one.summary.iterations.size() + 3);
        EXPECT_LT(difference(ours.w,
                             shared.problem.hierarchy().finest().nodes,
                             one.w,
                             numbers_on_one(shared.meshes.finest(),
                                            alone.meshes.finest())),
                  1e-8);
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          std::cout << ours.summary.iterations.size() << " iterations, "
                    << one.summary.iterations.size() << " on one process\n";
      }
}
