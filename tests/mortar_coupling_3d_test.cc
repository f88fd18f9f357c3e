// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mortar/dual_mortar.h>

#include "mortar_surfaces.h"

using namespace StickSlip;

namespace
{
  std::vector<double>
  shifted(std::vector<double> x, const double by)
  {
    for (double &value : x)
      value += by;
    return x;
  }



  /** Integrals of the bilinear nodal functions of a grid over a rectangle. */
  std::vector<double>
  grid_integrals(const std::vector<double>   &x,
                 const std::vector<double>   &y,
                 const std::array<double, 4> &box)
  {
    const auto          in_x = hat_integrals(x, box[0], box[1]);
    const auto          in_y = hat_integrals(y, box[2], box[3]);
    std::vector<double> result;
    for (const double b : in_y)
      for (const double a : in_x)
        result.push_back(a * b);
    return result;
  }
} // namespace



TEST(DualMortar3D, MatchingGridsAreTheIdentity)
{
  std::mt19937 random(1);
  const auto   side     = grid(random_breakpoints(9, -2., 2., random),
                         random_breakpoints(6, -1., 1., random),
                         0.4);
  const auto   coupling = couple(side, side);
  EXPECT_NEAR(coupling.covered_area, 8., 1e-13);
  for (unsigned int p = 0; p < side.positions.size(); ++p)
    {
      ASSERT_TRUE(coupling.active[p]);
      EXPECT_NEAR(entry(coupling.master_rows[p], p), 1., 1e-14);
      for (const auto &[q, value] : coupling.master_rows[p])
        EXPECT_NEAR(value, p == q ? 1. : 0., 1e-14);
    }
}



TEST(DualMortar3D, SlidNonmatchingGrids)
{
  std::mt19937 random(2);
  for (const unsigned int n : {2, 7, 23})
    for (const double slide_x :
         {0., 1e-13, 1e-9, 1e-4, 0.03, 0.17, 0.5, 0.9, -0.3, -1.})
      for (const double slide_y : {0., 1e-10, 0.02, -0.4})
        {
          const auto xs = random_breakpoints(9, -2., 2., random);
          const auto ys = random_breakpoints(5, -1., 1., random);
          const auto xm =
            shifted(random_breakpoints(n, -2., 2., random), slide_x);
          const auto ym =
            shifted(random_breakpoints(n, -1., 1., random), slide_y);
          const std::array<double, 4> box = {{std::max(xs.front(), xm.front()),
                                              std::min(xs.back(), xm.back()),
                                              std::max(ys.front(), ym.front()),
                                              std::min(ys.back(), ym.back())}};

          const auto   slave = grid(xs, ys), master = grid(xm, ym);
          const auto   coupling = couple(slave, master);
          const double area     = (box[1] - box[0]) * (box[3] - box[2]);
          expect_consistent(coupling, slave, master, area, 2e-13);

          const auto covered = grid_integrals(xs, ys, box);
          const auto full    = grid_integrals(xs, ys, {{-9., 9., -9., 9.}});
          for (unsigned int p = 0; p < covered.size(); ++p)
            {
              EXPECT_EQ(coupling.active[p], covered[p] >= 0.25 * full[p]);
              if (coupling.active[p])
                {
                  EXPECT_NEAR(coupling.weight[p] * coupling.averaging_factor[p],
                              covered[p],
                              1e-14);
                }
            }
          if (coupling.lost_area == 0.)
            expect_constant_traction(coupling,
                                     covered,
                                     grid_integrals(xm, ym, box));
        }
}



TEST(DualMortar3D, RectanglesAreTensorProducts)
{
  // While all of the width is covered, the dual functions of a grid of
  // rectangles are products of those on two lines, inactive nodes included.
  std::mt19937 random(5);
  for (const double slide : {0., 1e-7, 0.05, 0.1, 0.2, 0.3, 0.45, -0.6})
    {
      const auto xs = random_breakpoints(9, -2., 2., random);
      const auto ys = random_breakpoints(4, -1., 1., random);
      const auto xm = shifted(random_breakpoints(6, -2., 2., random), slide);
      const auto ym = random_breakpoints(7, -1., 1., random);

      const auto along  = couple(line(xs), line(xm));
      const auto across = couple(line(ys), line(ym));
      const auto both   = couple(grid(xs, ys), grid(xm, ym));
      for (unsigned int j = 0; j < ys.size(); ++j)
        for (unsigned int i = 0; i < xs.size(); ++i)
          {
            const unsigned int p = j * xs.size() + i;
            ASSERT_EQ(both.active[p], along.active[i]);
            if (!both.active[p])
              continue;
            EXPECT_NEAR(both.weight[p],
                        along.weight[i] * across.weight[j],
                        1e-14);
            EXPECT_NEAR(both.averaging_factor[p],
                        along.averaging_factor[i],
                        1e-13);
            for (unsigned int l = 0; l < ym.size(); ++l)
              for (unsigned int k = 0; k < xm.size(); ++k)
                EXPECT_NEAR(entry(both.master_rows[p], l * xm.size() + k),
                            entry(along.master_rows[i], k) *
                              entry(across.master_rows[j], l),
                            1e-13);
            for (unsigned int l = 0; l < ys.size(); ++l)
              for (unsigned int k = 0; k < xs.size(); ++k)
                EXPECT_NEAR(entry(both.inactive_slave_rows[p],
                                  l * xs.size() + k),
                            j == l ? entry(along.inactive_slave_rows[i], k) :
                                     0.,
                            1e-13);
          }
    }
}



TEST(DualMortar3D, RotatedGrids)
{
  std::mt19937 random(3);
  for (const double angle : {0.1, 0.785, 1.2})
    {
      const auto outer = grid(random_breakpoints(17, -3., 3., random),
                              random_breakpoints(11, -3., 3., random));
      const auto inner = shuffle(grid(random_breakpoints(8, -1., 1., random),
                                      random_breakpoints(8, -1., 1., random),
                                      angle),
                                 random);

      const auto all_covered = couple(inner, outer);
      expect_consistent(all_covered, inner, outer, 4.);
      EXPECT_EQ(all_covered.lost_area, 0.);
      for (unsigned int p = 0; p < inner.positions.size(); ++p)
        {
          EXPECT_TRUE(all_covered.active[p]);
          EXPECT_NEAR(all_covered.averaging_factor[p], 1., 1e-14);
        }

      // The other way round most of the slave is uncovered and the boundary of
      // the contact cuts faces at all angles.
      const auto partly = couple(outer, inner);
      expect_consistent(partly, outer, inner, 4., 1e-12);
      EXPECT_LT(partly.lost_area, 0.4);
    }
}



TEST(DualMortar3D, DistortedFaces)
{
  std::mt19937                           random(4);
  std::uniform_real_distribution<double> wiggle(-0.06, 0.06);
  const auto                             distort = [&](Side<3> side) {
    for (Point<3> &x : side.positions)
      if (std::abs(std::abs(x[0]) - 1.) > 1e-12 &&
          std::abs(std::abs(x[1]) - 1.) > 1e-12)
        x += Point<3>(wiggle(random), wiggle(random), 0.);
    return side;
  };
  const auto slave = distort(
    grid(uniform_breakpoints(8, -1., 1.), uniform_breakpoints(8, -1., 1.)));
  const auto master = distort(
    grid(uniform_breakpoints(5, -1., 1.), uniform_breakpoints(6, -1., 1.)));
  const auto coupling = couple(slave, master);
  expect_consistent(coupling, slave, master, 4.);
  EXPECT_EQ(coupling.lost_area, 0.);
}



TEST(DualMortar3D, ExcludedEdge)
{
  const auto        x      = uniform_breakpoints(6, 0., 3.);
  const auto        y      = uniform_breakpoints(4, 0., 1.);
  const auto        slave  = grid(x, y);
  const auto        xm     = uniform_breakpoints(4, 0., 3.);
  const auto        ym     = uniform_breakpoints(3, 0., 1.);
  const auto        master = grid(xm, ym);
  std::vector<bool> excluded(slave.positions.size());
  for (unsigned int p = 0; p < excluded.size(); ++p)
    excluded[p] = slave.positions[p][0] == 0.;

  const auto coupling = couple(slave, master, excluded);
  expect_consistent(coupling, slave, master, 3.);
  EXPECT_EQ(coupling.lost_area, 0.);
  const std::array<double, 4> all = {{0., 3., 0., 1.}};
  expect_constant_traction(coupling,
                           grid_integrals(x, y, all),
                           grid_integrals(xm, ym, all));
  // Each node next to the edge has taken over the share of its own
  // neighbour on the edge.
  EXPECT_NEAR(coupling.weight[2 * 7 + 1], 1.5 * 0.5 * 0.25, 1e-14);
  EXPECT_NEAR(coupling.averaging_factor[2 * 7 + 1], 2. / 3., 1e-14);
}



TEST(DualMortar3D, NoContact)
{
  const auto x = uniform_breakpoints(4, 0., 1.);
  for (const double shift : {1., 5., -1.})
    {
      const auto coupling = couple(grid(x, x), grid(shifted(x, shift), x));
      EXPECT_EQ(coupling.covered_area, 0.);
      EXPECT_EQ(coupling.lost_area, 0.);
    }
}
