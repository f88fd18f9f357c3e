// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "parallel_comparison.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr auto free_side = BoundaryType::free;
  constexpr auto fixed     = BoundaryType::fixed;
  constexpr auto velocity  = BoundaryType::velocity;
  constexpr auto traction  = BoundaryType::traction;

  constexpr unsigned int left = 0, right = 1;

  template <int dim>
  constexpr unsigned int lower = BodyMesh<dim>::lower_side;
  template <int dim>
  constexpr unsigned int upper = BodyMesh<dim>::upper_side;

  /** A condition in the axes of space, and the same in those of its side. */
  template <int dim>
  struct Pair
  {
    BoundaryCondition<dim> in_space, along_side;

    Pair(const BoundaryCondition<dim> &in_space,
         const BoundaryCondition<dim> &along_side)
      : in_space(in_space)
      , along_side(along_side)
    {
      this->along_side.axes = BoundaryAxes::side;
    }
  };



  /** Sides that roll, are pushed, sheared and held; the last two disagree at
   * the corner, where the last one counts. */
  std::vector<Pair<2>>
  conditions_2d()
  {
    return {
      {make_side<2>("0", lower<2>, {{free_side, fixed}}),
       make_side<2>("0", lower<2>, {{free_side, fixed}})},
      // Tangential axis y, normal -x.
      {make_side<2>("0", left, {{velocity, free_side}}, {{"1e-3 * (1 + y)"}}),
       make_side<2>(
         "0", left, {{free_side, velocity}}, {{"0", "-1e-3 * (1 + y)"}})},
      {make_side<2>("1", left, {{free_side, traction}}, {{"0", "2e5"}}),
       make_side<2>("1", left, {{traction, free_side}}, {{"2e5"}})},
      // Tangential axis -y, normal x.
      {make_side<2>("2", right, {{velocity, fixed}}, {{"2e-3 * y"}}),
       make_side<2>("2", right, {{fixed, velocity}}, {{"0", "2e-3 * y"}})},
      {make_side<2>(
         "2", upper<2>, {{velocity, traction}}, {{"1e-3", "-1e6 * (1 + x)"}}),
       make_side<2>(
         "2", upper<2>, {{velocity, traction}}, {{"1e-3", "-1e6 * (1 + x)"}})}};
  }



  std::vector<Pair<3>>
  conditions_3d()
  {
    return {
      // Tangential axes x and -y.
      {make_side<3>("0",
                    lower<3>,
                    {{free_side, velocity, fixed}},
                    {{"0", "1e-3 * x", "0"}}),
       make_side<3>("0",
                    lower<3>,
                    {{free_side, velocity, fixed}},
                    {{"0", "-1e-3 * x", "0"}})},
      // Tangential axes y and -z, normal -x.
      {make_side<3>("0",
                    left,
                    {{velocity, free_side, traction}},
                    {{"1e-3 * y", "0", "3e5"}}),
       make_side<3>("0",
                    left,
                    {{free_side, traction, velocity}},
                    {{"0", "-3e5", "-1e-3 * y"}})},
      // Tangential axes y and z, normal x.
      {make_side<3>(
         "1", right, {{fixed, velocity, free_side}}, {{"0", "1e-3", "0"}}),
       make_side<3>(
         "1", right, {{velocity, free_side, fixed}}, {{"1e-3", "0", "0"}})}};
  }



  /** Nodal velocities and load of a quasi-static scene with stuck faults. */
  template <int dim>
  std::pair<NodalVector, NodalVector>
  solve(SpatialScene<dim> &scene)
  {
    NodalVector u = scene.problem.make_nodal_vector(), f = u,
                w = scene.problem.make_vector();
    scene.boundary.set_velocities(1., u);
    scene.boundary.add_tractions(1., f);
    scene.problem.to_jumps(w, u);
    scene.problem.set_known_jumps(1., w);
    for (const unsigned int p :
         scene.problem.hierarchy().finest().nonsmooth_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        w.local_element(p * dim + c) = 0.;
    scene.problem.hierarchy().set_cycle_precision(
      CyclePrecision::double_precision);
    solve_linear(scene.problem,
                 {0., 0., 1.},
                 stuck_mask(scene.problem.hierarchy()),
                 scene.problem.load(1.),
                 w,
                 1e-14);
    scene.problem.to_nodal(u, w);
    return {u, f};
  }



  template <int dim>
  void
  compare(const std::vector<BodyGeometry<dim>> &bodies,
          const std::vector<Pair<dim>>         &conditions)
  {
    std::vector<BoundaryCondition<dim>> in_space, along_sides;
    for (const Pair<dim> &pair : conditions)
      {
        in_space.push_back(pair.in_space);
        along_sides.push_back(pair.along_side);
      }
    const std::vector<Material> materials(bodies.size());
    SpatialScene<dim>           alone(
      bodies, in_space, materials, 9.81, MPI_COMM_SELF, 1);
    SpatialScene<dim> shared(
      bodies, along_sides, materials, 9.81, MPI_COMM_WORLD, 1);
    const unsigned int n_levels = shared.meshes.n_levels();
    for (unsigned int l = 0; l < n_levels; ++l)
      {
        EXPECT_TRUE(alone.boundary.frames(l).empty());
        EXPECT_FALSE(shared.boundary.frames(l).empty());
      }

    const auto [u, f]                   = solve(shared);
    const auto [expected_u, expected_f] = solve(alone);
    const NodePartition &nodes          = shared.meshes.finest().nodes;
    const auto           numbers = numbers_on_one(shared.meshes.finest());
    EXPECT_LT(difference(f, nodes, expected_f, numbers), 1e-13);
    EXPECT_LT(difference(u, nodes, expected_u, numbers), 1e-12);
    EXPECT_GT(expected_u.linfty_norm(), 1e-3);
  }
} // namespace



TEST(ParallelSideAxes, ConditionsAlongSidesEqualThoseInSpace)
{
  compare(nonmatching_bodies(), conditions_2d());
  compare(nonmatching_blocks(), conditions_3d());
}
