// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "sine_bodies.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  struct Solution
  {
    unsigned int iterations;
    double       work;
  };

  /** The static solution under shear, sliding without friction. */
  template <int dim>
  Solution<dim>
  solve(const SineBodies<dim> &bodies,
        const unsigned int     n_coarser,
        const MPI_Comm         communicator)
  {
    std::array<BoundaryType, dim> held;
    held.fill(BoundaryType::fixed);
    const auto &names = bodies.meshes[0].bodies[0].side_names;
    const auto  bottom =
      std::find_if(names.begin(), names.end(), [](const auto &side) {
        return side.second == "bottom";
      });
    const auto &upper_names = bodies.meshes[0].bodies[1].side_names;
    const auto  top =
      std::find_if(upper_names.begin(),
                   upper_names.end(),
                   [](const auto &side) { return side.second == "top"; });
    SpatialScene<dim>  scene(bodies.coarse_bodies(n_coarser),
                            bodies.meshes[0].topology,
                            {make_side<dim>("lower", bottom->first, held),
                              make_side<dim>("upper", top->first, held)},
                            std::vector<Material>(2),
                            Tensor<1, dim>(9.81 * Point<dim>::unit_vector(0)),
                            communicator);
    NodalVector        w    = scene.problem.make_vector();
    const NodalVector  load = scene.problem.load(0.);
    const unsigned int n =
      solve_linear(scene.problem,
                   {0., 0., 1.},
                   scene.problem.hierarchy().finest().fixed,
                   load,
                   w,
                   1e-10);
    return {n, load * w};
  }



  template <int dim>
  void
  expect_equal_solutions(const SineBodies<dim> &bodies)
  {
    const Solution<dim> ours   = solve(bodies, 2, MPI_COMM_WORLD),
                        one    = solve(bodies, 2, MPI_COMM_SELF),
                        direct = solve(bodies, 0, MPI_COMM_WORLD);
    EXPECT_NEAR(ours.work, one.work, 1e-9 * one.work);
    EXPECT_LE(ours.iterations, direct.iterations + 2);
    std::cout << dim << " dimensions: " << ours.iterations
              << ", on one process " << one.iterations
              << ", with a factorisation " << direct.iterations
              << " iterations\n";
  }
} // namespace



TEST(ParallelCoarser, SolutionsAreThoseOfOneProcess)
{
  expect_equal_solutions(
    SineBodies<2>(0.06, {36, 17, 8}, Cells::quadrilaterals, 1));
  expect_equal_solutions(SineBodies<2>(0.06, {36, 17, 8}, Cells::triangles, 1));
  expect_equal_solutions(
    SineBodies<3>(0.06, {9, 5, 3}, Cells::quadrilaterals, 1));
}
