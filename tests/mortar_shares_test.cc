// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mortar/side_gaps.h>

#include <cmath>
#include <vector>

#include "mortar_curves.h"

using namespace StickSlip;

/*
 * The coupling of some slave nodes, as one process of several finds it.
 */

namespace
{
  std::vector<PackedRows<unsigned int>::Entry>
  entries(const SparseRow &row)
  {
    return {row.begin(), row.end()};
  }



  /** Parts of any size, put together, are the coupling bit by bit. */
  template <int dim>
  void
  expect_parts_of_whole(const Side<dim>         &slave,
                        const Side<dim>         &master,
                        const std::vector<bool> &excluded = {})
  {
    const auto         whole   = couple(slave, master, excluded);
    const unsigned int n_nodes = slave.positions.size();
    for (const unsigned int n_parts : {1, 2, 3, 7})
      {
        double covered_area = 0., lost_area = 0.;
        for (unsigned int i = 0; i < n_parts; ++i)
          {
            const SlaveRange range = {n_nodes * i / n_parts,
                                      n_nodes * (i + 1) / n_parts};
            const auto       part  = build_mortar_coupling(slave.surface,
                                                    slave.positions,
                                                    reversed(master.surface),
                                                    master.positions,
                                                    excluded,
                                                    range);
            covered_area += part.covered_area;
            lost_area += part.lost_area;
            ASSERT_EQ(part.rotation_rows.size(), whole.rotation_rows.size());
            for (unsigned int p = range.begin; p < range.end; ++p)
              {
                EXPECT_EQ(part.active[p], whole.active[p]);
                EXPECT_EQ(part.weight[p], whole.weight[p]);
                EXPECT_EQ(part.averaging_factor[p], whole.averaging_factor[p]);
                EXPECT_EQ(entries(part.master_rows[p]),
                          entries(whole.master_rows[p]));
                EXPECT_EQ(entries(part.inactive_slave_rows[p]),
                          entries(whole.inactive_slave_rows[p]));
                if (!whole.rotation_rows.empty())
                  {
                    EXPECT_EQ(part.rotation_rows[p], whole.rotation_rows[p]);
                  }
              }
          }
        EXPECT_NEAR(covered_area, whole.covered_area, 1e-13);
        EXPECT_NEAR(lost_area, whole.lost_area, 1e-13);
      }
  }



  /** Parts of the gaps are those of the whole bit by bit, and nothing else. */
  template <int dim>
  void
  expect_parts_of_gaps(const Side<dim> &slave, const Side<dim> &master)
  {
    const auto gaps = [&](const SlaveRange &range) {
      return side_gaps(slave.surface,
                       slave.positions,
                       reversed(master.surface),
                       master.positions,
                       range);
    };
    const std::vector<double> whole   = gaps({});
    const unsigned int        n_nodes = whole.size();
    for (const unsigned int n_parts : {2, 3, 7})
      for (unsigned int i = 0; i < n_parts; ++i)
        {
          const SlaveRange          range = {n_nodes * i / n_parts,
                                             n_nodes * (i + 1) / n_parts};
          const std::vector<double> part  = gaps(range);
          for (unsigned int p = 0; p < n_nodes; ++p)
            if (range.contains(p) && !std::isnan(whole[p]))
              EXPECT_EQ(part[p], whole[p]);
            else
              EXPECT_TRUE(std::isnan(part[p]));
        }
  }
} // namespace



TEST(MortarShares, ArePartsOfTheWhole)
{
  std::mt19937 random(3);
  // Nodes off contact at the end, and some that take no part.
  const Side<2> long_line =
                  shuffle(line(random_breakpoints(20, 0., 2., random)), random),
                short_line = line(random_breakpoints(17, 0., 1.7, random));
  expect_parts_of_whole(long_line, short_line);
  std::vector<bool> excluded(long_line.positions.size(), false);
  excluded[3] = excluded[11] = true;
  expect_parts_of_whole(long_line, short_line, excluded);

  expect_parts_of_whole(shuffle(grid(random_breakpoints(6, 0., 2., random),
                                     random_breakpoints(5, 0., 1., random)),
                                random),
                        grid(random_breakpoints(5, 0., 1.6, random),
                             random_breakpoints(6, 0., 1., random)));

  const auto    bend  = [](const double x) { return Point<2>(x, 0.1 * x * x); };
  const Side<2> slave = curve(uniform_breakpoints(15, 0., 1.), bend),
                master = curve(uniform_breakpoints(11, 0., 0.9), bend);
  expect_parts_of_whole(slave, master);
  expect_parts_of_gaps(slave, master);
}
