// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "sine_bodies.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  using Scene = SpatialScene<dim>;



  /** The bodies on two sides of a fault, held below and dragged above. */
  template <int dim>
  std::unique_ptr<Scene<dim>>
  make_scene(const SineBodies<dim> &bodies, const unsigned int n_coarser)
  {
    std::array<BoundaryType, dim> held;
    held.fill(BoundaryType::fixed);
    const auto side = [&](const unsigned int body, const std::string &name) {
      for (const auto &candidate : bodies.meshes[0].bodies[body].side_names)
        if (candidate.second == name)
          return candidate.first;
      return numbers::invalid_boundary_id;
    };
    std::array<BoundaryType, dim> dragged = held;
    std::array<std::string, dim>  values;
    dragged[0] = BoundaryType::velocity;
    values[0]  = "1";
    return std::make_unique<Scene<dim>>(
      bodies.coarse_bodies(n_coarser),
      bodies.meshes[0].topology,
      std::vector<BoundaryCondition<dim>>{
        make_side<dim>("lower", side(0, "bottom"), held),
        make_side<dim>("upper", side(1, "top"), dragged, values)},
      std::vector<Material>(2),
      Tensor<1, dim>(-9.81 * Point<dim>::unit_vector(0)));
  }



  /** Iterations of CG for the static problem; the fault slides at x > 0 and is
   * stuck elsewhere. */
  template <int dim>
  unsigned int
  iterations(Scene<dim> &scene)
  {
    LevelHierarchy<dim> &hierarchy = scene.problem.hierarchy();
    NodeMask             active    = hierarchy.finest().fixed;
    for (const auto &contact : scene.problem.jump_basis().faults())
      for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
        if (contact.slave.points[k][0] < 0. && contact.coupling.active[k])
          active.mask_node(
            hierarchy.finest().nodes.local_index(contact.slave.nodes[k]));
    NodalVector w = scene.problem.make_vector();
    return solve_linear(
      scene.problem, {0., 0., 1.}, active, scene.problem.load(0.), w, 1e-8);
  }



  /** The coarser meshes take the place of the factorisation of the unrefined
   * one, at no more iterations. */
  template <int dim>
  void
  expect_iterations(const SineBodies<dim> &bodies,
                    const unsigned int     most_iterations)
  {
    const auto         direct = make_scene(bodies, 0);
    const unsigned int before = iterations(*direct);
    EXPECT_LE(before, most_iterations);
    for (unsigned int n = 1; n < bodies.meshes.size(); ++n)
      {
        const auto         scene = make_scene(bodies, n);
        const unsigned int after = iterations(*scene);
        EXPECT_EQ(scene->meshes.n_levels(), direct->meshes.n_levels() + n);
        EXPECT_LE(after, before + 1) << n;
        std::cout << dim << " dimensions, " << n << " coarser meshes, "
                  << direct->meshes.level(0).n_nodes() << " and "
                  << scene->meshes.level(0).n_nodes() << " nodes on the "
                  << "coarsest level, " << scene->meshes.finest().n_nodes()
                  << " on the finest: " << before << " and " << after
                  << " iterations\n";
      }
  }
} // namespace



TEST(CoarserLevels, InterpolateLinearFunctions)
{
  // Without amplitude the coarse bodies cover the fine ones.
  const SineBodies<2> bodies(0., {16, 11, 5}, Cells::triangles, 1);
  const auto          scene = make_scene(bodies, 2);
  const auto function       = [](const unsigned int body, const Point<2> &x) {
    return Tensor<1, 2>({1. - body + 0.3 * x[0] - 2. * x[1], x[0] + body});
  };
  for (unsigned int l = 1; l < scene->meshes.n_levels(); ++l)
    {
      const MeshLevel<2> &fine = scene->meshes.level(l);
      const NodalVector   coarse_values =
        interpolate(scene->meshes.level(l - 1), function);
      const NodalVector fine_values = interpolate(fine, function);
      for (unsigned int i = 0; i < fine.n_nodes(); ++i)
        if (const GlobalRow row = scene->meshes.prolongation(l).row(i);
            !row.empty())
          for (unsigned int c = 0; c < 2; ++c)
            {
              double value = 0.;
              for (const auto &entry : row)
                value += entry.second *
                         coarse_values.local_element(entry.first * 2 + c);
              EXPECT_NEAR(value, fine_values.local_element(i * 2 + c), 1e-12);
            }
    }
}



// Nodes at a fault have values of its side alone, which add up to one: a jump
// of one goes to jumps of one.
TEST(CoarserLevels, KeepTheSidesOfCurvedFaultsApart)
{
  const SineBodies<2> bodies(0.1, {24, 12, 6}, Cells::quadrilaterals, 0);
  const auto          scene = make_scene(bodies, 2);
  for (unsigned int l = 1; l < scene->meshes.n_levels(); ++l)
    for (const unsigned int side : {0, 1})
      {
        const auto coarse = scene->meshes.level(l - 1).surface(0, side).nodes;
        for (const auto node : scene->meshes.level(l).surface(0, side).nodes)
          {
            double sum = 0.;
            for (const auto &entry : scene->meshes.prolongation(l).row(node))
              {
                EXPECT_NE(std::find(coarse.begin(), coarse.end(), entry.first),
                          coarse.end());
                EXPECT_GT(entry.second, 0.);
                sum += entry.second;
              }
            EXPECT_NEAR(sum, 1., 1e-12);
          }
      }
}



TEST(CoarserLevels, IterationsAreThoseOfAFactorisation)
{
  expect_iterations(
    SineBodies<2>(0.06, {48, 25, 13, 7}, Cells::quadrilaterals, 2), 15);
  expect_iterations(SineBodies<2>(0.06, {48, 25, 13}, Cells::triangles, 1), 18);
  expect_iterations(SineBodies<3>(0.06, {12, 7, 4}, Cells::quadrilaterals, 1),
                    16);
  // Tetrahedra.
  expect_iterations(SineBodies<3>(0.06, {9, 6, 4}, Cells::triangles, 1), 18);
}



TEST(CoarserLevels, MustBeOfTheSameBodies)
{
  const SineBodies<2> bodies(0.06, {16, 8}, Cells::quadrilaterals, 0);
  const auto message = [&](const std::function<void(CutMesh<2> &)> &change) {
    CutMesh<2> coarser = bodies.meshes[1];
    change(coarser);
    return message_of([&]() { match_to_finer(bodies.meshes[0], coarser); });
  };
  EXPECT_EQ(message([](CutMesh<2> &) {}), "no error");
  expect_one_sentence_with(message([](CutMesh<2> &mesh) {
                             mesh.bodies[1].side_names.begin()->second = "end";
                           }),
                           {"'upper'", "no side 'left'"});
  expect_one_sentence_with(message([](CutMesh<2> &mesh) {
                             mesh.bodies[1].side_names[17] = "end";
                           }),
                           {"'upper'", "'end'", "not in the finer mesh"});
  expect_one_sentence_with(message([&](CutMesh<2> &mesh) {
                             mesh = bodies.meshes[0];
                           }),
                           {"'lower'", "not fewer"});
  expect_one_sentence_with(message([](CutMesh<2> &mesh) {
                             for (Point<2> &vertex : mesh.bodies[0].vertices)
                               vertex[0] *= 0.5;
                           }),
                           {"'lower'", "the finer mesh alone is at"});
  expect_one_sentence_with(message([](CutMesh<2> &mesh) {
                             for (Point<2> &vertex : mesh.bodies[0].vertices)
                               vertex[1] *= 2.;
                           }),
                           {"'lower'", "the coarser mesh alone is at"});
}



// Indicators follow the names, in whatever order groups are in the files.
TEST(CoarserLevels, NumberSidesAlike)
{
  const SineBodies<2> bodies(0.06, {16, 8}, Cells::quadrilaterals, 0);
  CutMesh<2>          shuffled = bodies.meshes[1];
  for (BodyCells<2> &body : shuffled.bodies)
    {
      std::map<types::boundary_id, std::string> names;
      for (const auto &side : body.side_names)
        names[10 - side.first] = side.second;
      body.side_names = names;
      for (auto &line : body.boundary.boundary_lines)
        line.boundary_id = 10 - line.boundary_id;
    }
  match_to_finer(bodies.meshes[0], shuffled);
  for (const unsigned int b : {0, 1})
    {
      EXPECT_EQ(shuffled.bodies[b].side_names,
                bodies.meshes[0].bodies[b].side_names);
      for (const auto &side : shuffled.bodies[b].side_names)
        EXPECT_EQ(shuffled.bodies[b].vertices_on(side.first).size(),
                  bodies.meshes[1].bodies[b].vertices_on(side.first).size());
    }
}
