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

  // Stuck, slipping, half and half, and from one node to the next by several
  // orders of magnitude.
  const std::vector<Alpha> states = {
    [](const double, const unsigned int) { return 12.; },
    [](const double, const unsigned int) { return -9.; },
    [](const double x, const unsigned int) { return x < 0 ? -9. : 9.; },
    [](const double, const unsigned int k) {
      return 8. * std::sin(12.9898 * (k + 1.));
    }};



  /** Numbers of iterations in all states and with step sizes of the loading,
   * the nucleation and the slip. */
  std::vector<unsigned int>
  iterations(const MPI_Comm communicator)
  {
    LayeredSlider slider({{10, 2}}, {{14, 2}}, 9, communicator);
    EXPECT_GT(slider.problem.make_vector().size(), 95000u);
    EXPECT_LT(slider.problem.make_vector().size(), 120000u);
    std::vector<unsigned int> result;
    for (const double tau : {1e-1, 1e-3, 1e-5})
      {
        const NodalVector rhs = slider.set_step(tau, 2.5e4);
        for (const Alpha &alpha : states)
          {
            const Friction<2> friction =
              slider.friction(Kind::truncated, alpha);
            const TNNMGParameters parameters;
            TNNMGSolver<2>     solver(slider.problem.hierarchy(), parameters);
            NodalVector        w = slider.start();
            const SolveSummary summary =
              solver.solve(*friction.functional, rhs, w);
            EXPECT_TRUE(summary.converged);
            EXPECT_LE(summary.n_cycles(), 30u);
            result.push_back(summary.iterations.size());
          }
      }
    return result;
  }
} // namespace



TEST(ScalingIterations, HardlyDependOnTheNumberOfProcesses)
{
  const std::vector<unsigned int> ours = iterations(MPI_COMM_WORLD);
  std::vector<unsigned int>       alone;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    alone = iterations(MPI_COMM_SELF);
  alone = Utilities::MPI::broadcast(MPI_COMM_WORLD, alone, 0);
  ASSERT_EQ(ours.size(), alone.size());
  for (unsigned int k = 0; k < ours.size(); ++k)
    {
      EXPECT_LE(ours[k], alone[k] + 2) << "problem " << k;
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "problem " << k << ": " << ours[k] << " iterations on "
                  << n_processes() << " processes, " << alone[k] << " on one\n";
    }
}
