// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"
#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Alpha = std::function<double(const double, const unsigned int)>;

  struct Solution
  {
    NodalVector  w;
    SolveSummary summary;
  };

  Solution
  solve(LayeredSlider &slider,
        const Kind     kind,
        const Alpha   &alpha,
        const double   tau)
  {
    TNNMGParameters parameters;
    parameters.tolerance       = 1e-12;
    const NodalVector rhs      = slider.set_step(tau, 2.5e4);
    const Friction<2> friction = slider.friction(kind, alpha);
    Solution          solution{slider.start(), {}};
    TNNMGSolver<2>    solver(slider.problem.hierarchy(), parameters);
    solver.find_correction_decrease();
    solution.summary = solver.solve(*friction.functional, rhs, solution.w);
    return solution;
  }



  void
  expect_equal_solutions(const Kind kind, const Alpha &alpha, const double tau)
  {
    for (const unsigned int min_nodes_per_process : {1, 500})
      {
        LayeredSlider shared(
          {{10, 2}}, {{14, 2}}, 4, MPI_COMM_WORLD, min_nodes_per_process),
          alone({{10, 2}}, {{14, 2}}, 4, MPI_COMM_SELF);
        const Solution ours = solve(shared, kind, alpha, tau),
                       one  = solve(alone, kind, alpha, tau);
        ASSERT_TRUE(ours.summary.converged);
        ASSERT_TRUE(one.summary.converged);
        EXPECT_LE(ours.summary.iterations.size(),
                  one.summary.iterations.size() + 2);
        EXPECT_LT(difference(ours.w,
                             shared.problem.hierarchy().finest().nodes,
                             one.w,
                             numbers_on_one(shared.meshes.finest())),
                  1e-8);
        for (const IterationSummary &iteration : ours.summary.iterations)
          {
            // Up to rounding, which is all there is in the last ones.
            EXPECT_GT(iteration.smoother_decrease,
                      -1e-12 * iteration.iterate_norm * iteration.iterate_norm);
            EXPECT_GT(iteration.correction_decrease,
                      -1e-12 * iteration.iterate_norm * iteration.iterate_norm);
          }
      }
  }



  // From one node to the next the state changes by several orders of
  // magnitude.
  double
  rough(const double, const unsigned int k)
  {
    return 8. * std::sin(12.9898 * (k + 1.));
  }
} // namespace



TEST(ParallelSolve, EqualsThatOfOneProcess)
{
  for (const Kind kind : {Kind::truncated, Kind::arcsinh})
    for (const double tau : {1e-3, 1e-1})
      {
        expect_equal_solutions(
          kind, [](const double, const unsigned int) { return 2.; }, tau);
        expect_equal_solutions(
          kind,
          [](const double x, const unsigned int) { return x < 0 ? -9. : 3.; },
          tau);
        expect_equal_solutions(kind, rough, tau);
      }
}



namespace
{
  /**
   * Nodes that all depend on each other as strongly as on themselves, one in
   * turn for each process: A = 1 1^T + I / 10 in the first components, and the
   * identity in the second ones. Where each process minimises for itself, they
   * all take the same step and go too far together.
   */
  struct Crowd
  {
    static constexpr unsigned int per_process = 3;
    OperatorSum<2>                operators;
    LevelHierarchy<2>             hierarchy;

    Crowd()
      : operators(descriptions().back(), {matrix(descriptions().back().nodes)})
      , hierarchy(operators, descriptions())
    {
      operators.combine({1.});
    }

    static BlockMatrix<2>
    matrix(const NodePartition &nodes)
    {
      BlockMatrix<2> A(sparsity(nodes));
      for (unsigned int i = 0; i < nodes.n_owned(); ++i)
        for (unsigned int j = 0; j < nodes.n_local(); ++j)
          {
            double *block = A.block(A.sparsity().position(i, j));
            block[0]      = (i == j ? 1.1 : 1.);
            block[3]      = (i == j ? 1. : 0.);
          }
      return A;
    }

    static std::shared_ptr<const BlockSparsity>
    sparsity(const NodePartition &nodes)
    {
      std::vector<std::vector<unsigned int>> rows(nodes.n_owned());
      for (auto &row : rows)
        for (unsigned int j = 0; j < nodes.n_local(); ++j)
          row.push_back(j);
      return std::make_shared<const BlockSparsity>(rows);
    }

    static std::vector<LevelDescription<2>>
    descriptions()
    {
      const unsigned int n  = per_process * n_processes();
      const unsigned int me = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      IndexSet           owned(n), ghosts = complete_index_set(n);
      owned.add_range(me * per_process, (me + 1) * per_process);
      ghosts.subtract_set(owned);

      std::vector<LevelDescription<2>> levels(2);
      levels[1].nodes = NodePartition(owned, ghosts, 2, MPI_COMM_WORLD);
      // The coarse function is a single node's.
      std::vector<GlobalRow> rows(n);
      rows[levels[1].nodes.is_local(0) ? levels[1].nodes.local_index(0) : 0] = {
        {0, 1.}};
      IndexSet coarse(1);
      if (me == 0)
        coarse.add_index(0);
      levels[1].to_coarser = std::make_shared<GalerkinProduct<2>>(
        levels[1].nodes, *sparsity(levels[1].nodes), rows, coarse);
      levels[0].nodes = levels[1].to_coarser->coarse_nodes();
      for (auto &level : levels)
        {
          level.fixed = NodeMask(level.nodes.n_local(), 2);
          for (unsigned int i = 0; i < level.nodes.n_owned(); ++i)
            level.nonsmooth_nodes.push_back(i);
        }
      return levels;
    }
  };
} // namespace



TEST(ParallelSolve, SmootherDecreasesTheEnergyWhereAllNodesCouple)
{
  Crowd              crowd;
  const unsigned int n     = Crowd::per_process * n_processes();
  const auto         loads = std::vector<double>(Crowd::per_process, 0.1);
  const CoulombFunctional<2> functional(
    crowd.hierarchy.finest().nonsmooth_nodes, loads);
  NodalVector b = crowd.hierarchy.finest().nodes.make_vector(), w = b;
  for (unsigned int i = 0; i < Crowd::per_process; ++i)
    b.local_element(2 * i) = 1.;

  TNNMGParameters parameters;
  parameters.tolerance = 1e-12;
  TNNMGSolver<2> solver(crowd.hierarchy, parameters);
  solver.find_correction_decrease();
  solver.start(b, w);
  unsigned int iteration = 0;
  for (; iteration < 5000; ++iteration)
    {
      const IterationSummary summary = solver.iterate(functional, b, w);
      EXPECT_GE(summary.smoother_decrease, -1e-14);
      EXPECT_GE(summary.correction_decrease, -1e-14);
      if (solver.has_converged(summary))
        break;
    }
  EXPECT_LT(iteration, 5000u);
  // All values are the same, v with (n + 0.1) v + 0.1 = 1.
  for (unsigned int i = 0; i < Crowd::per_process; ++i)
    EXPECT_NEAR(w.local_element(2 * i), 0.9 / (n + 0.1), 1e-9);
}
