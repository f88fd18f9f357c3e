// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "serial_matrices.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr types::boundary_id top = 3, bottom = 2;

  BodyGeometry<2>
  block(const double       lower,
        const double       upper,
        const double       base,
        const unsigned int n_cells)
  {
    BodyGeometry<2> body  = make_body<2>(1., {{n_cells, 1}}, 2);
    body.lateral_lower[0] = lower;
    body.lateral_upper[0] = upper;
    body.base             = base;
    return body;
  }



  /** One body that lies on two others side by side, the one body first. */
  MeshHierarchy<2>
  two_under_one(const unsigned int n_over)
  {
    return MeshHierarchy<2>(
      {block(-2.5, 2.5, 1., n_over),
       block(-2.5, 0., 0., 3),
       block(0., 2.5, 0., 2)},
      FaultTopology({"over", "left", "right"},
                    {{"main", {{{{1, top}, {2, top}}, {{0, bottom}}}}}}),
      MPI_COMM_WORLD);
  }
} // namespace



TEST(SideOfTwoBodies, IsCoupledAsAWhole)
{
  // The two bodies are master, and slave.
  for (const unsigned int n_over : {11, 3})
    {
      const MeshHierarchy<2>        meshes = two_under_one(n_over);
      const std::vector<FaultSides> sides  = {
         choose_fault_sides(meshes.finest(), meshes.topology(), 0)};
      EXPECT_EQ(sides[0].slave_is_second(), n_over == 11);
      for (unsigned int l = 0; l < meshes.n_levels(); ++l)
        {
          const MeshLevel<2> &level = meshes.level(l);
          const JumpBasis<2>  basis =
            undeformed_basis(level, sides, NodeMask(level.n_nodes(), 2));
          const auto &coupling = basis.faults()[0].coupling;
          EXPECT_NEAR(coupling.covered_area, 5., 1e-12);
          EXPECT_EQ(basis.contact_nodes().size(),
                    level.surface(0, sides[0].slave).nodes.size());

          // Positions are continuous across the fault.
          std::vector<double> x(level.n_nodes());
          for_each_node(level,
                        [&](const unsigned int,
                            const unsigned int,
                            const unsigned int node,
                            const Point<2>    &point,
                            const bool) { x[node] = point[0]; });
          for (const auto p : basis.contact_nodes())
            {
              double jump = 0;
              for (const auto &[node, value] : basis.to_jumps(p))
                jump += value * x[node];
              EXPECT_NEAR(jump, 0., 1e-12);
            }
        }
    }
}



TEST(SideOfTwoBodies, DisplacementsAreInjectedAtTheSamePlaces)
{
  const MeshHierarchy<2>        meshes = two_under_one(11);
  const std::vector<FaultSides> sides  = {
     choose_fault_sides(meshes.finest(), meshes.topology(), 0)};
  // A different displacement of each body tells the nodes at x = 0 apart.
  const auto u       = interpolate(meshes.finest(),
                             [](const unsigned int body, const Point<2> &x) {
                               return Tensor<1, 2>({x[0] + 10. * body, x[1]});
                             });
  auto displacements = gather_fault_displacements(meshes.finest(), sides, u);
  for (unsigned int l = meshes.n_levels() - 1; l-- > 0;)
    {
      displacements            = inject(meshes, l, sides, displacements);
      const auto expect_values = [&](const unsigned int               side,
                                     const std::vector<Tensor<1, 2>> &values) {
        const FaultSurface<2> &surface = meshes.level(l).surface(0, side);
        ASSERT_EQ(values.size(), surface.points.size());
        for (unsigned int k = 0; k < values.size(); ++k)
          {
            const bool over =
              meshes.topology().faults()[0].sides[side][0].body == 0;
            const double shift = values[k][0] - surface.points[k][0];
            if (over)
              EXPECT_EQ(shift, 0.);
            else
              EXPECT_NEAR(
                shift,
                k < meshes.level(l).bodies[1]->surface(top).nodes.size() ? 10. :
                                                                           20.,
                1e-12);
            EXPECT_EQ(values[k][1], surface.points[k][1]);
          }
      };
      expect_values(sides[0].slave, displacements[0].slave);
      expect_values(sides[0].master, displacements[0].master);
    }
}
