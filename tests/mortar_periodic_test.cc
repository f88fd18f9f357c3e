// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "mortar_surfaces.h"

using namespace StickSlip;

namespace
{
  /** Breakpoints of several periods in a row. */
  std::vector<double>
  repeat(const std::vector<double> &period, const int first, const int last)
  {
    const double        length = period.back() - period.front();
    std::vector<double> result;
    for (int copy = first; copy <= last; ++copy)
      for (unsigned int i = 0; i + 1 < period.size(); ++i)
        result.push_back(period[i] + copy * length);
    result.push_back(period.back() + last * length);
    return result;
  }



  std::vector<double>
  moved(std::vector<double> x, const double by)
  {
    for (double &value : x)
      value += by;
    return x;
  }



  /** One period of a line, without its last node. */
  Side<2>
  periodic_line(const std::vector<double> &breakpoints)
  {
    Side<2>            side = line(breakpoints);
    const unsigned int n    = breakpoints.size() - 1;
    side.surface.period[0]  = breakpoints.back() - breakpoints.front();
    side.surface.nodes.pop_back();
    side.surface.points.pop_back();
    side.positions.pop_back();
    for (auto &face : side.surface.faces)
      {
        side.surface.wraps.push_back({{{{0}}, {{face[1] == n ? 1 : 0}}}});
        face[1] %= n;
      }
    return side;
  }



  /** One period of a grid along both axes. */
  Side<3>
  periodic_grid(const std::vector<double> &x, const std::vector<double> &y)
  {
    const unsigned int nx = x.size() - 1, ny = y.size() - 1;
    Side<3>            side;
    side.surface.period[0] = x.back() - x.front();
    side.surface.period[1] = y.back() - y.front();
    side.surface.normal[2] = 1.;
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        {
          side.positions.push_back(Point<3>(x[i], y[j], 0.));
          side.surface.points.push_back(Point<3>(x[i], y[j], 0.));
          side.surface.nodes.push_back(side.surface.nodes.size());
          side.surface.faces.emplace_back();
          side.surface.wraps.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            {
              const unsigned int a = i + v % 2, b = j + v / 2;
              side.surface.faces.back()[v] = (b % ny) * nx + a % nx;
              side.surface.wraps.back()[v] = {
                {static_cast<int>(a / nx), static_cast<int>(b / ny)}};
            }
        }
    return side;
  }



  /** A row with the images of a node taken together. */
  std::map<unsigned int, double>
  folded(const SparseRow &row, const std::function<unsigned(unsigned)> &fold)
  {
    std::map<unsigned int, double> result;
    for (const auto &[column, value] : row)
      result[fold(column)] += value;
    return result;
  }



  void
  expect_row(const SparseRow                      &row,
             const std::map<unsigned int, double> &expected)
  {
    std::map<unsigned int, double> found(row.begin(), row.end());
    for (const auto &[column, value] : expected)
      EXPECT_NEAR(found[column], value, 1e-11) << column;
    for (const auto &[column, value] : found)
      EXPECT_TRUE(expected.count(column) == 1 || std::abs(value) < 1e-11);
  }



  template <int dim>
  void
  expect_everything_in_contact(const MortarCoupling<dim> &coupling,
                               const double               area)
  {
    EXPECT_NEAR(coupling.covered_area, area, 1e-12 * area);
    EXPECT_NEAR(coupling.lost_area, 0., 1e-12 * area);
    double sum = 0;
    for (unsigned int p = 0; p < coupling.active.size(); ++p)
      {
        EXPECT_TRUE(coupling.active[p]);
        EXPECT_NEAR(coupling.averaging_factor[p], 1., 1e-12);
        EXPECT_TRUE(coupling.inactive_slave_rows[p].empty());
        double row = 0;
        for (const auto &entry : coupling.master_rows[p])
          row += entry.second;
        EXPECT_NEAR(row, 1., 1e-12);
        sum += coupling.weight[p];
      }
    EXPECT_NEAR(sum, area, 1e-12 * area);
  }
} // namespace



TEST(PeriodicFault, IsTheMiddleOfAnUnrolledOne)
{
  std::mt19937 random(3);
  const auto   x = random_breakpoints(7, 0., 2., random);
  const auto   y = random_breakpoints(5, 0., 2., random);
  for (const double slid : {0., 0.3, -0.4, 1.999, 2., 7.1, -123.4})
    {
      const MortarCoupling<2> coupling =
        couple(periodic_line(moved(x, slid)), periodic_line(y));
      expect_everything_in_contact(coupling, 2.);

      const double            rest = slid - 2. * std::floor(slid / 2.);
      const MortarCoupling<2> unrolled =
        couple(line(repeat(moved(x, rest), -1, 1)), line(repeat(y, -2, 3)));
      for (unsigned int p = 0; p < 7; ++p)
        {
          EXPECT_NEAR(coupling.weight[p], unrolled.weight[7 + p], 1e-11);
          expect_row(coupling.master_rows[p],
                     folded(unrolled.master_rows[7 + p],
                            [](const unsigned int q) { return q % 5; }));
        }
    }
}



TEST(PeriodicFault, IsTheMiddleOfAnUnrolledOneInThreeDimensions)
{
  std::mt19937 random(4);
  const auto   x = random_breakpoints(4, 0., 2., random),
             y   = random_breakpoints(3, -1., 0., random);
  const auto a   = random_breakpoints(3, 0., 2., random),
             b   = random_breakpoints(4, -1., 0., random);
  for (const Point<2> &slid :
       {Point<2>(), Point<2>(0.7, 0.2), Point<2>(-9.3, 14.6)})
    {
      const MortarCoupling<3> coupling =
        couple(periodic_grid(moved(x, slid[0]), moved(y, slid[1])),
               periodic_grid(a, b));
      expect_everything_in_contact(coupling, 2.);

      const double rest_x = slid[0] - 2. * std::floor(slid[0] / 2.),
                   rest_y = slid[1] - std::floor(slid[1]);
      const MortarCoupling<3> unrolled =
        couple(grid(repeat(moved(x, rest_x), -1, 1),
                    repeat(moved(y, rest_y), -1, 1)),
               grid(repeat(a, -2, 3), repeat(b, -2, 3)));
      const unsigned int slave_columns = 3 * 4 + 1, master_columns = 6 * 3 + 1;
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int i = 0; i < 4; ++i)
          {
            const unsigned int p = j * 4 + i,
                               q = (3 + j) * slave_columns + 4 + i;
            EXPECT_NEAR(coupling.weight[p], unrolled.weight[q], 1e-11);
            expect_row(coupling.master_rows[p],
                       folded(unrolled.master_rows[q],
                              [&](const unsigned int m) {
                                return (m / master_columns % 4) * 3 +
                                       m % master_columns % 3;
                              }));
          }
    }
}



TEST(PeriodicFault, OneFaceThatMeetsItself)
{
  // Both ends of the only face are the same node.
  const std::vector<double> ends = {0., 0.5};
  for (const double slid : {0., 0.2, -0.5, 3.3})
    {
      const MortarCoupling<2> coupling =
        couple(periodic_line(moved(ends, slid)), periodic_line(ends));
      expect_everything_in_contact(coupling, 0.5);
      ASSERT_EQ(coupling.master_rows.size(), 1u);
      EXPECT_EQ(coupling.master_rows[0].size(), 1u);
    }
}



TEST(PeriodicFault, MatchingMeshesMatchAfterAFullPeriod)
{
  std::mt19937 random(5);
  const auto   x = random_breakpoints(6, -1., 1., random);
  for (const int periods : {-2, -1, 0, 1, 5})
    {
      const MortarCoupling<2> coupling =
        couple(periodic_line(moved(x, 2. * periods)), periodic_line(x));
      for (unsigned int p = 0; p < 6; ++p)
        expect_row(coupling.master_rows[p], {{p, 1.}});
    }
}
