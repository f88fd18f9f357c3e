// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "opening_iterations.h"
#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** By place, since numbers of terms depend on the process. */
  template <int dim>
  double
  alpha_of_place(const Point<dim> &x, const unsigned int)
  {
    return 8. * std::sin(40. * x[0] + 7. * x[1]);
  }

  template <int dim>
  double
  gap_of_place(const Point<dim> &x, const unsigned int)
  {
    return std::sin(23. * x[0] + 3. * x[1]) > 0.5 ? -1e-3 : 0.;
  }



  template <int dim>
  std::pair<NodalVector, SolveSummary>
  solve(OpeningLayers<dim> &layers, const double tau)
  {
    TNNMGParameters parameters;
    parameters.tolerance = 1e-12;
    const NodalVector b  = layers.set_step(tau, alternating_traction<dim>);
    Friction<dim>     friction = layers.friction(alpha_of_place<dim>);
    layers.let_open(friction, gap_of_place<dim>);
    NodalVector      w = layers.start();
    TNNMGSolver<dim> solver(layers.problem.hierarchy(), parameters);
    solver.find_correction_decrease();
    const SolveSummary summary = solver.solve(*friction.functional, b, w);
    const unsigned int n       = layers.n_open(friction, w);
    EXPECT_GT(n, 10u);
    EXPECT_LT(n,
              Utilities::MPI::sum(friction.terms.size(),
                                  w.get_mpi_communicator()));
    return {w, summary};
  }



  template <int dim>
  void
  expect_equal_solutions(const std::vector<BodyGeometry<dim>> &bodies)
  {
    std::string counts;
    for (const bool opens_in_part : {false, true})
      {
        OpeningLayers<dim> shared(
          bodies, true, opens_in_part, MPI_COMM_WORLD, /*min_nodes=*/1),
          alone(bodies, true, opens_in_part, MPI_COMM_SELF);
        for (const double tau : {1e-1, 1e-3})
          {
            const auto [ours, our_summary] = solve(shared, tau);
            const auto [one, one_summary]  = solve(alone, tau);
            ASSERT_TRUE(our_summary.converged) << our_summary;
            ASSERT_TRUE(one_summary.converged) << one_summary;
            // Sweeps do not cross from process to process, whose parts have
            // a few nodes here, other ones with each version of METIS.
            EXPECT_LE(our_summary.iterations.size(),
                      one_summary.iterations.size() * 2);
            counts += std::to_string(our_summary.iterations.size()) + " for " +
                      std::to_string(one_summary.iterations.size()) + ", ";
            EXPECT_LT(difference(ours,
                                 shared.problem.hierarchy().finest().nodes,
                                 one,
                                 numbers_on_one(shared.meshes.finest())),
                      1e-8);
            for (const IterationSummary &iteration : our_summary.iterations)
              {
                const double size =
                  iteration.iterate_norm * iteration.iterate_norm;
                EXPECT_GE(iteration.smoother_decrease, -1e-12 * size);
                EXPECT_GE(iteration.correction_decrease, -1e-12 * size);
              }
          }
      }
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << counts << "iterations\n";
  }
} // namespace



TEST(ParallelOpening, EqualsThatOfOneProcess)
{
  expect_equal_solutions<2>(
    {make_body<2>(1., {{10, 2}}, 2), make_body<2>(1., {{14, 2}}, 2)});
  expect_equal_solutions<3>(
    {make_body<3>(1., {{3, 3, 1}}, 1), make_body<3>(1., {{4, 4, 1}}, 1)});
}
