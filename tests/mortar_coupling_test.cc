// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

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



  /** Slave and master breakpoints, both increasing. */
  struct Pair
  {
    std::vector<double> slave;
    std::vector<double> master;

    double
    lower() const
    {
      return std::max(slave.front(), master.front());
    }

    double
    upper() const
    {
      return std::min(slave.back(), master.back());
    }

    double
    length() const
    {
      return std::max(0., upper() - lower());
    }
  };



  double
  hat(const std::vector<double> &x, const unsigned int i, const double at)
  {
    if (i > 0 && at >= x[i - 1] && at <= x[i])
      return (at - x[i - 1]) / (x[i] - x[i - 1]);
    if (i + 1 < x.size() && at >= x[i] && at <= x[i + 1])
      return (x[i + 1] - at) / (x[i + 1] - x[i]);
    return 0.;
  }



  /** The dual functions of one slave face at a point, from closed formulas. */
  std::array<double, 2>
  dual_functions(const double               x0,
                 const double               x1,
                 const double               a,
                 const double               b,
                 const std::array<bool, 2> &active,
                 const double               x)
  {
    if (active[0] != active[1])
      return {{active[0] ? 1. : 0., active[1] ? 1. : 0.}};
    // int (1 + s (x - m)) (l - (x - m)) over the covered part vanishes for
    // s = l / variance; the functions are scaled by their integrals against
    // their own shape function.
    const double middle = (a + b) / 2., variance = (b - a) * (b - a) / 12.;
    const double left = x1 - middle, right = middle - x0;
    const double psi_0 =
      (1. - (x - middle) * right / variance) * left / (left + right);
    const double psi_1 =
      (1. + (x - middle) * left / variance) * right / (left + right);
    return {{psi_0, psi_1}};
  }



  /** Compare all entries with integrals over finely cut pieces. */
  void
  expect_reference(const MortarCoupling<2> &coupling, const Pair &pair)
  {
    const std::vector<double> &x = pair.slave, &y = pair.master;
    const double               inf = std::numeric_limits<double>::infinity();
    const auto covered = hat_integrals(x, pair.lower(), pair.upper());
    const auto full    = hat_integrals(x, -inf, inf);
    for (unsigned int p = 0; p < x.size(); ++p)
      ASSERT_EQ(coupling.active[p], covered[p] >= 0.25 * full[p]) << p;

    std::vector<std::vector<double>> M(x.size()), E(x.size());
    for (unsigned int p = 0; p < x.size(); ++p)
      {
        M[p].resize(y.size());
        E[p].resize(x.size());
      }
    const QGauss<1> quadrature(3);
    for (unsigned int f = 0; f + 1 < x.size(); ++f)
      {
        const std::array<bool, 2> active = {
          {coupling.active[f], coupling.active[f + 1]}};
        const double a = std::max(x[f], pair.lower());
        const double b = std::min(x[f + 1], pair.upper());
        if (a >= b || (!active[0] && !active[1]))
          continue;
        std::vector<double> cuts = {a, b};
        for (const double cut : y)
          if (cut > a && cut < b)
            cuts.push_back(cut);
        std::sort(cuts.begin(), cuts.end());
        for (unsigned int c = 0; c + 1 < cuts.size(); ++c)
          for (unsigned int g = 0; g < quadrature.size(); ++g)
            {
              const double h   = cuts[c + 1] - cuts[c];
              const double at  = cuts[c] + quadrature.point(g)[0] * h;
              const double JxW = quadrature.weight(g) * h;
              const auto psi = dual_functions(x[f], x[f + 1], a, b, active, at);
              for (unsigned int i = 0; i < 2; ++i)
                {
                  for (unsigned int q = 0; q < y.size(); ++q)
                    M[f + i][q] += psi[i] * hat(y, q, at) * JxW;
                  for (unsigned int j = 0; j < 2; ++j)
                    E[f + i][f + j] += psi[i] * hat(x, f + j, at) * JxW;
                }
            }
      }

    for (unsigned int p = 0; p < x.size(); ++p)
      if (coupling.active[p])
        {
          double weight = 0.;
          for (const double value : E[p])
            weight += value;
          EXPECT_NEAR(E[p][p], covered[p], 1e-13);
          EXPECT_NEAR(coupling.weight[p], weight, 1e-13);
          EXPECT_NEAR(coupling.averaging_factor[p], E[p][p] / weight, 1e-13);
          for (unsigned int q = 0; q < y.size(); ++q)
            EXPECT_NEAR(entry(coupling.master_rows[p], q),
                        M[p][q] / E[p][p],
                        1e-12)
              << p << ' ' << q;
          for (unsigned int k = 0; k < x.size(); ++k)
            EXPECT_NEAR(entry(coupling.inactive_slave_rows[p], k),
                        coupling.active[k] ? 0. : -E[p][k] / E[p][p],
                        1e-13);
        }
  }



  /** All properties at once; returns the largest sum of |N_pq| of a row. */
  double
  check(const Pair &pair)
  {
    const Side<2> slave = line(pair.slave), master = line(pair.master);
    const MortarCoupling<2> coupling = couple(slave, master);
    expect_consistent(coupling, slave, master, pair.length());
    expect_reference(coupling, pair);
    if (coupling.lost_area == 0.)
      expect_constant_traction(
        coupling,
        hat_integrals(pair.slave, pair.lower(), pair.upper()),
        hat_integrals(pair.master, pair.lower(), pair.upper()));

    double largest = 0.;
    for (unsigned int p = 0; p < coupling.master_rows.size(); ++p)
      {
        double sum = 0.;
        for (const auto &entry : coupling.master_rows[p])
          sum += std::abs(entry.second);
        largest = std::max(largest, sum);
      }
    return largest;
  }
} // namespace



TEST(DualMortar, MatchingMeshesAreTheIdentity)
{
  std::mt19937 random(1);
  for (const auto &x : {uniform_breakpoints(160, -2.5, 2.5),
                        random_breakpoints(37, -2.5, 2.5, random)})
    {
      const Side<2>           side     = line(x);
      const MortarCoupling<2> coupling = couple(side, shuffle(side, random));
      EXPECT_NEAR(coupling.covered_area, 5., 1e-13);

      const MortarCoupling<2> same = couple(side, side);
      for (unsigned int p = 0; p < x.size(); ++p)
        {
          ASSERT_TRUE(same.active[p]);
          ASSERT_EQ(same.master_rows[p].size(), 1u);
          EXPECT_EQ(same.master_rows[p][0].first, p);
          EXPECT_NEAR(same.master_rows[p][0].second, 1., 1e-14);
          EXPECT_TRUE(same.inactive_slave_rows[p].empty());
          EXPECT_NEAR(same.averaging_factor[p], 1., 1e-14);
        }
    }
}



TEST(DualMortar, RandomNonmatchingMeshes)
{
  std::mt19937 random(2);
  for (const unsigned int n_slave : {1, 3, 10, 48, 160})
    for (const unsigned int n_master : {1, 3, 10, 48, 160})
      for (unsigned int repetition = 0; repetition < 5; ++repetition)
        {
          const double largest =
            check({random_breakpoints(n_slave, -2.5, 2.5, random),
                   random_breakpoints(n_master, -2.5, 2.5, random)});
          EXPECT_LT(largest, 5. / 3. + 1e-12);
        }
}



TEST(DualMortar, SlidApart)
{
  // From slivers to half the fault, to both sides, either side finer.
  std::mt19937 random(3);
  for (const unsigned int n_master : {2, 10, 13, 80, 160})
    {
      const auto slave_points = random_breakpoints(16, -2.5, 2.5, random);
      const auto master_points =
        random_breakpoints(n_master, -2.5, 2.5, random);
      std::vector<double> slides;
      for (double s = 1e-14; s < 2e-3; s *= std::sqrt(10.))
        slides.push_back(s);
      for (double s = 0.01; s < 2.5; s += 0.0137)
        slides.push_back(s);
      for (const double s : slides)
        for (const double sign : {-1., 1.})
          EXPECT_LT(check({slave_points, shifted(master_points, sign * s)}),
                    4.6);
    }
}



TEST(DualMortar, SlidingMatchingMeshes)
{
  const auto x = uniform_breakpoints(20, -2.5, 2.5);
  EXPECT_EQ(check({x, x}), 1.);
  // Never by exactly half a face, where rounding decides who is active.
  for (unsigned int i = 0; i < 400; ++i)
    EXPECT_LT(check({x, shifted(x, (i + 0.3) * 0.25 / 100.)}), 4.6);
}



TEST(DualMortar, NumberingDoesNotMatter)
{
  std::mt19937 random(4);
  const auto   slave        = line(random_breakpoints(21, -2.5, 2.5, random));
  const auto   master       = line(random_breakpoints(8, -2.2, 2.8, random));
  const auto   mixed_slave  = shuffle(slave, random);
  const auto   mixed_master = shuffle(master, random);
  const auto   coupling     = couple(slave, master);
  const auto   mixed        = couple(mixed_slave, mixed_master);
  expect_consistent(mixed, mixed_slave, mixed_master, 4.7);

  const auto find = [](const Side<2> &side, const Point<2> &x) {
    return std::find(side.positions.begin(), side.positions.end(), x) -
           side.positions.begin();
  };
  for (unsigned int p = 0; p < slave.positions.size(); ++p)
    {
      const unsigned int r = find(mixed_slave, slave.positions[p]);
      EXPECT_EQ(coupling.active[p], mixed.active[r]);
      EXPECT_NEAR(coupling.weight[p], mixed.weight[r], 1e-14);
      EXPECT_EQ(coupling.master_rows[p].size(), mixed.master_rows[r].size());
      for (const auto &[q, value] : coupling.master_rows[p])
        EXPECT_NEAR(entry(mixed.master_rows[r],
                          find(mixed_master, master.positions[q])),
                    value,
                    1e-14);
    }
}



TEST(DualMortar, ExcludedNodesHandTheirShareToTheirNeighbours)
{
  const auto x = uniform_breakpoints(8, 0., 2.);
  const auto y = uniform_breakpoints(5, 0., 2.);

  std::vector<bool> excluded(9, false);
  excluded[0] = excluded[8]     = true;
  const Side<2>           slave = line(x), master = line(y);
  const MortarCoupling<2> coupling = couple(slave, master, excluded);
  expect_consistent(coupling, slave, master, 2.);
  expect_constant_traction(coupling,
                           hat_integrals(x, 0., 2.),
                           hat_integrals(y, 0., 2.));
  EXPECT_EQ(coupling.lost_area, 0.);
  for (unsigned int p = 0; p < 9; ++p)
    {
      EXPECT_EQ(coupling.active[p], !excluded[p]);
      if (p == 1 || p == 7)
        {
          EXPECT_NEAR(coupling.weight[p], 0.375, 1e-15);
          EXPECT_NEAR(coupling.averaging_factor[p], 2. / 3., 1e-15);
          EXPECT_NEAR(row_sum(coupling.inactive_slave_rows[p]), -0.5, 1e-15);
        }
      else if (!excluded[p])
        {
          EXPECT_NEAR(coupling.weight[p], 0.25, 1e-15);
          EXPECT_TRUE(coupling.inactive_slave_rows[p].empty());
        }
    }

  // Two neighbours: the face between them has nobody to carry its load.
  excluded[1]                   = true;
  const MortarCoupling<2> lossy = couple(slave, master, excluded);
  expect_consistent(lossy, slave, master, 2.);
  EXPECT_NEAR(lossy.lost_area, 0.25, 1e-15);
  EXPECT_NEAR(lossy.covered_area, 1.75, 1e-15);

  const MortarCoupling<2> none =
    couple(slave, master, std::vector<bool>(9, true));
  expect_consistent(none, slave, master, 2.);
  EXPECT_EQ(none.covered_area, 0.);
}



TEST(DualMortar, NoContact)
{
  const auto x = uniform_breakpoints(8, 0., 2.);
  for (const double shift : {2., 2.5, -2., -100.})
    {
      const MortarCoupling<2> coupling =
        couple(line(x), line(shifted(x, shift)));
      EXPECT_EQ(coupling.covered_area, 0.);
      EXPECT_EQ(coupling.lost_area, 0.);
      EXPECT_EQ(
        std::count(coupling.active.begin(), coupling.active.end(), true), 0);
    }

  // A last touch that no node carries is lost, and bounded as promised.
  const MortarCoupling<2> touch = couple(line(x), line(shifted(x, 1.98)));
  EXPECT_EQ(touch.covered_area, 0.);
  EXPECT_NEAR(touch.lost_area, 0.02, 1e-15);
  EXPECT_LT(touch.lost_area, 0.25 * 0.25);
}
