// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"

namespace
{
  unsigned int n_sums = 0;
}

// All sums of this program come by here; PETSc has a macro of this name.
#undef MPI_Allreduce
extern "C" int
MPI_Allreduce(const void  *send,
              void        *receive,
              int          count,
              MPI_Datatype type,
              MPI_Op       operation,
              MPI_Comm     communicator)
{
  ++n_sums;
  return PMPI_Allreduce(send, receive, count, type, operation, communicator);
}

using namespace StickSlip;
using namespace StickSlip::Tests;



// One of the smoother and the linearisation, one of the line search, and one of
// each step of conjugate gradients; others for further slopes of the line
// search, for the norms after a shorter step, and where the coarsest matrix
// changes.
TEST(ParallelMessages, TwoSumsInAnIterationAndOneInACycle)
{
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    GTEST_SKIP() << "There are no sums on one process.";
  LayeredSlider   slider({{10, 2}}, {{14, 2}}, 4, MPI_COMM_WORLD, 1);
  TNNMGParameters parameters;
  parameters.tolerance                = 1e-10;
  parameters.single_cycle_corrections = 0;
  parameters.cycles_per_correction    = 2;
  unsigned int n_iterations = 0, n_with_two = 0;
  for (const double tau : {1e-3, 1e-1})
    {
      const NodalVector b = slider.set_step(tau, 2.5e4);
      const Friction<2> friction =
        slider.friction(Kind::arcsinh, [](const double x, const unsigned int) {
          return x < 0 ? -9. : 3.;
        });
      NodalVector    w = slider.start();
      TNNMGSolver<2> solver(slider.problem.hierarchy(), parameters);
      solver.start(b, w);
      for (bool is_finished = false; !is_finished; ++n_iterations)
        {
          ASSERT_LT(n_iterations, 100u);
          const unsigned int     before = n_sums;
          const IterationSummary summary =
            solver.iterate(*friction.functional, b, w);
          const unsigned int n = n_sums - before -
                                 (summary.line_search_evaluations - 2) -
                                 (summary.step_length != 1.);
          is_finished = solver.has_converged(summary);
          EXPECT_LE(n, summary.cycles + 3);
          n_with_two += (n == summary.cycles + 2);
        }
    }
  EXPECT_GE(2 * n_with_two, n_iterations);
}
