// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simplex_bodies.h"
#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  enum class Cells
  {
    bricks,
    simplices
  };

  /** Meshes of three bodies, the one that goes through first. */
  struct Meshes
  {
    Cells                       cells;
    std::array<unsigned int, 3> n_cells;
    unsigned int                uniform_refinements = 0;
    /** Towards the faults, with hanging nodes. */
    unsigned int refinement_passes = 0;
  };

  /** The axis along which two bodies are side by side: x or, in three
   * dimensions, y. */
  template <int dim>
  constexpr unsigned int across = dim - 2;



  /** Two bodies side by side on a third one; the fault between the two ends at
   * 0.5 m at the one below them. */
  template <int dim>
  FaultTopology
  junction_topology()
  {
    return FaultTopology(
      {"under", "left", "right"},
      {{"main",
        {{{{0, BodyMesh<dim>::upper_side}},
          {{1, BodyMesh<dim>::lower_side}, {2, BodyMesh<dim>::lower_side}}}}},
       {"branch", {{{{1, 2 * across<dim> + 1}}, {{2, 2 * across<dim>}}}}}});
  }



  template <int dim>
  std::vector<CoarseBody<dim>>
  junction_bodies(const Meshes &meshes)
  {
    const std::array<std::array<double, 3>, 3> places = {
      {{{-2.5, 2.5, 0.}}, {{-2.5, 0.5, 1.}}, {{0.5, 2.5, 1.}}}};
    std::vector<CoarseBody<dim>> bodies;
    for (unsigned int b = 0; b < 3; ++b)
      {
        std::array<unsigned int, dim> n_cells;
        n_cells.fill(meshes.n_cells[b]);
        BodyGeometry<dim> body =
          make_body<dim>(1., n_cells, meshes.refinement_passes);
        body.uniform_refinements        = meshes.uniform_refinements;
        body.lateral_lower[across<dim>] = places[b][0];
        body.lateral_upper[across<dim>] = places[b][1];
        body.base                       = places[b][2];
        bodies.push_back(meshes.cells == Cells::bricks ? coarse_brick(body) :
                                                         simplex_brick(body));
      }
    return bodies;
  }



  /** All outer sides are held. */
  template <int dim>
  std::vector<BoundaryCondition<dim>>
  held_sides()
  {
    std::array<BoundaryType, dim> held;
    held.fill(BoundaryType::velocity);
    const FaultTopology                 topology = junction_topology<dim>();
    std::vector<BoundaryCondition<dim>> conditions;
    for (unsigned int b = 0; b < 3; ++b)
      for (unsigned int side = 0; side < 2 * dim; ++side)
        if (!topology.is_at_fault(b, side))
          conditions.push_back(
            make_side<dim>(topology.body_names()[b], side, held));
    return conditions;
  }



  /** The static solution with stuck faults whose outer sides are displaced as
   * @p exact says, in nodal values. */
  template <int dim, typename Function>
  struct Solution
  {
    SpatialScene<dim> scene;
    NodalVector       exact, u;

    Solution(const Meshes &meshes, const Function &displacement)
      : scene(junction_bodies<dim>(meshes),
              junction_topology<dim>(),
              held_sides<dim>(),
              std::vector<Material>(3),
              Tensor<1, dim>())
      , exact(interpolate(scene.meshes.finest(),
                          [&](const unsigned int, const Point<dim> &x) {
                            return displacement(x);
                          }))
      , u(exact)
    {
      const NodeMask dirichlet =
        scene.boundary.dirichlet_mask(scene.meshes.n_levels() - 1);
      for (unsigned int i = 0; i < dirichlet.n_nodes(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          if (dirichlet.is_active(i, c))
            u.local_element(i * dim + c) = 0.;
      NodalVector w = scene.problem.make_vector();
      scene.problem.to_jumps(w, u);
      for (const unsigned int p : scene.problem.jump_basis().contact_nodes())
        for (unsigned int c = 0; c < dim; ++c)
          w.local_element(p * dim + c) = 0.;
      solve_linear(scene.problem,
                   {0., 0., 1.},
                   stuck_mask(scene.problem.hierarchy()),
                   scene.problem.load(0.),
                   w);
      scene.problem.to_nodal(u, w);
    }

    double
    error() const
    {
      NodalVector difference = u;
      difference -= exact;
      return difference.linfty_norm() / exact.linfty_norm();
    }
  };



  template <int dim>
  double
  patch_test_error(const Meshes &meshes)
  {
    const auto linear = [](const Point<dim> &x) {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          value[c] += std::cos(1. + 2. * c + 3. * d) * x[d];
      return value;
    };
    return Solution<dim, decltype(linear)>(meshes, linear).error();
  }



  /** Distances of the two bodies above from each other, and from the one below,
   * at the junction. */
  double
  opening(const unsigned int n_refinements)
  {
    // Bent without forces on horizontal planes: displacements of second order.
    const double nu   = Material().poissons_ratio;
    const auto   bent = [&](const Point<2> &x) {
      const double y = x[1] - 1.;
      return Tensor<1, 2>(
        {x[0] * y, -(x[0] * x[0] + nu / (1. - nu) * y * y) / 2.});
    };
    const Solution<2, decltype(bent)> solution(
      {Cells::bricks, {{7, 4, 3}}, n_refinements}, bent);
    const MeshLevel<2>       &level = solution.scene.meshes.finest();
    std::vector<Tensor<1, 2>> ends;
    // Nodes of the lower side that are next to the junction, to both sides.
    std::array<std::pair<double, Tensor<1, 2>>, 2> next = {
      {{-1., Tensor<1, 2>()}, {9., Tensor<1, 2>()}}};
    for_each_node(level,
                  [&](const unsigned int body,
                      const unsigned int,
                      const unsigned int node,
                      const Point<2>    &x,
                      const bool) {
                    if (std::abs(x[1] - 1.) > 1e-12)
                      return;
                    const Tensor<1, 2> value(
                      {solution.u.local_element(2 * node),
                       solution.u.local_element(2 * node + 1)});
                    if (body > 0 && std::abs(x[0] - 0.5) < 1e-12)
                      ends.push_back(value);
                    if (body == 0 && x[0] <= 0.5 && x[0] > next[0].first)
                      next[0] = {x[0], value};
                    if (body == 0 && x[0] > 0.5 && x[0] < next[1].first)
                      next[1] = {x[0], value};
                  });
    EXPECT_EQ(ends.size(), 2u);
    const double part = (0.5 - next[0].first) / (next[1].first - next[0].first);
    const Tensor<1, 2> below =
      (1. - part) * next[0].second + part * next[1].second;
    return std::max({(ends[0] - ends[1]).norm(),
                     (ends[0] - below).norm(),
                     (ends[1] - below).norm()});
  }
} // namespace



// Meshes that do not match, the finer side above and below, with hanging nodes.
TEST(Junction, PatchTestOfWeldedBodies)
{
  for (const std::array<unsigned int, 3> n_cells :
       {std::array<unsigned int, 3>{{7, 4, 3}},
        std::array<unsigned int, 3>{{3, 5, 8}}})
    for (const Cells cells : {Cells::bricks, Cells::simplices})
      for (const unsigned int passes : {0, 2})
        EXPECT_LT(patch_test_error<2>({cells, n_cells, 0, passes}), 1e-12)
          << n_cells[0] << " cells, " << passes << " passes";
}



TEST(Junction, PatchTestOfWeldedHexahedraAndTetrahedra)
{
  EXPECT_LT(patch_test_error<3>({Cells::bricks, {{4, 3, 2}}}), 1e-12);
  EXPECT_LT(patch_test_error<3>({Cells::bricks, {{3, 2, 2}}, 0, 1}), 1e-12);
  EXPECT_LT(patch_test_error<3>({Cells::simplices, {{3, 2, 2}}, 1}), 1e-12);
}



// Nothing holds the three bodies together where they meet but what surrounds
// the point.
TEST(Junction, OpensBySecondOrderInTheCellSize)
{
  std::vector<double> openings;
  std::cout << "opening at the junction, m:";
  for (const unsigned int n_refinements : {1, 2, 3})
    {
      openings.push_back(opening(n_refinements));
      std::cout << ' ' << openings.back();
    }
  std::cout << '\n';
  // The displacement is up to 3 m; the ratios vary with how meshes meet.
  EXPECT_LT(openings[0], 0.03);
  EXPECT_GT(openings[0] / openings[1], 3.);
  EXPECT_GT(openings[1] / openings[2], 3.);
  EXPECT_GT(openings[0] / openings[2], 3.8 * 3.8);
}
