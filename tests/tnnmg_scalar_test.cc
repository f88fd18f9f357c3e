// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <cmath>

#include "serial_matrices.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The functional sum_k load |v_k| of one component at each of its nodes. */
  class AbsoluteValues : public NonsmoothFunctional<1>
  {
  public:
    AbsoluteValues(const std::vector<unsigned int> &nodes, const double load)
      : node_indices(nodes)
      , load(load)
    {}

    const std::vector<unsigned int> &
    nodes() const override
    {
      return node_indices;
    }

    double
    value(const unsigned int, const Tensor<1, 1> &v) const override
    {
      return load * std::abs(v[0]);
    }

    double
    directional_derivative(const unsigned int,
                           const Tensor<1, 1> &v,
                           const Tensor<1, 1> &direction) const override
    {
      return v[0] == 0. ? load * std::abs(direction[0]) :
                          std::copysign(load, v[0]) * direction[0];
    }

    Tensor<1, 1>
    gradient(const unsigned int, const Tensor<1, 1> &v) const override
    {
      Tensor<1, 1> result;
      if (v[0] != 0.)
        result[0] = std::copysign(load, v[0]);
      return result;
    }

    Tensor<2, 1>
    hessian(const unsigned int, const Tensor<1, 1> &) const override
    {
      return Tensor<2, 1>();
    }

    bool
    is_smooth(const unsigned int, const Tensor<1, 1> &v) const override
    {
      return v[0] != 0.;
    }

    bool
    acts_on(const unsigned int, const unsigned int) const override
    {
      return true;
    }

    Tensor<1, 1>
    minimise(const unsigned int,
             const Tensor<2, 1>        &A,
             const Tensor<1, 1>        &r,
             const std::array<bool, 1> &active,
             const Tensor<1, 1>        &start) const override
    {
      Tensor<1, 1> v = start;
      if (active[0])
        v[0] =
          std::copysign(std::max(std::abs(r[0]) - load, 0.), r[0]) / A[0][0];
      return v;
    }

  private:
    const std::vector<unsigned int> node_indices;
    const double                    load;
  };



  /**
   * The equation -Laplace u + u = f in the unit square with five-point stencils
   * on grids of cells of size 1/n, 2/n, ..., 1/2, zero on the boundary. Terms
   * of the operator are u and -Laplace u, both times the area of a cell.
   */
  struct GridProblem
  {
    enum Nonsmooth
    {
      none,
      everywhere,
      middle_row
    };

    const unsigned int n;
    /** Of the functional, at a node. */
    const double      load;
    OperatorSum<1>    operators;
    LevelHierarchy<1> hierarchy;
    NodalVector       b;

    GridProblem(const unsigned int n, const Nonsmooth where)
      : n(n)
      , load(where == everywhere ? 10. / (n * n) : 9. / n)
      , operators(descriptions(n, where).back(), terms(n))
      , hierarchy(operators, descriptions(n, where))
      , b(hierarchy.finest().nodes.make_vector())
    {
      operators.combine({1., 1.});
      for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
        {
          const double x = double(i % (n + 1)) / n, y = double(i / (n + 1)) / n;
          b.local_element(i) = 40. / (n * n) * std::sin(2. * numbers::PI * x) *
                               std::sin(numbers::PI * y);
        }
    }

    static std::vector<TermMatrix<1>>
    terms(const unsigned int n)
    {
      const auto     sparsity = five_points(n);
      BlockMatrix<1> mass(sparsity), stiffness(sparsity);
      for (unsigned int i = 0; i < sparsity->n_rows(); ++i)
        {
          const unsigned int first = sparsity->row_start[i],
                             end   = sparsity->row_start[i + 1];
          for (unsigned int k = first; k < end; ++k)
            *stiffness.block(k) = -1.;
          *stiffness.block(sparsity->diagonal[i]) = 4.;
          *mass.block(sparsity->diagonal[i])      = 1. / (n * n);
        }
      return {mass, stiffness};
    }

    static std::shared_ptr<const BlockSparsity>
    five_points(const unsigned int n)
    {
      const unsigned int                     width = n + 1;
      std::vector<std::vector<unsigned int>> rows(width * width);
      for (unsigned int i = 0; i < rows.size(); ++i)
        {
          if (i % width > 0)
            rows[i].push_back(i - 1);
          if (i % width < n)
            rows[i].push_back(i + 1);
          if (i / width > 0)
            rows[i].push_back(i - width);
          if (i / width < n)
            rows[i].push_back(i + width);
        }
      return std::make_shared<const BlockSparsity>(std::move(rows));
    }

    /** Bilinear interpolation from the grid with half as many cells. */
    static std::vector<GlobalRow>
    interpolation(const unsigned int n)
    {
      return rows_of((n + 1) * (n + 1), [&](const unsigned int i) {
        const unsigned int x = i % (n + 1), y = i / (n + 1);
        GlobalRow          row;
        for (const unsigned int X : {x / 2, (x + 1) / 2})
          for (const unsigned int Y : {y / 2, (y + 1) / 2})
            row.emplace_back(Y * (n / 2 + 1) + X, 0.25);
        return row;
      });
    }

    static std::vector<LevelDescription<1>>
    descriptions(const unsigned int n, const Nonsmooth where)
    {
      std::vector<LevelDescription<1>> levels;
      for (unsigned int m = 2; m <= n; m *= 2)
        {
          const unsigned int  n_nodes = (m + 1) * (m + 1);
          LevelDescription<1> level;
          level.nodes = serial_nodes(n_nodes, 1);
          level.fixed = NodeMask(n_nodes, 1);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              const unsigned int x = i % (m + 1), y = i / (m + 1);
              if (x == 0 || x == m || y == 0 || y == m)
                level.fixed.mask_node(i);
              else if (where == everywhere ||
                       (where == middle_row && y == m / 2))
                level.nonsmooth_nodes.push_back(i);
            }
          levels.push_back(level);
        }
      std::shared_ptr<const BlockSparsity> sparsity = five_points(n);
      for (unsigned int l = levels.size() - 1, m = n; l > 0; --l, m /= 2)
        {
          levels[l].to_coarser =
            std::make_shared<GalerkinProduct<1>>(levels[l].nodes,
                                                 *sparsity,
                                                 interpolation(m),
                                                 levels[l - 1].nodes.owned());
          sparsity = levels[l].to_coarser->coarse_sparsity();
        }
      return levels;
    }

    AbsoluteValues
    functional() const
    {
      return AbsoluteValues(hierarchy.finest().nonsmooth_nodes, load);
    }

    /** The minimiser by sweeps of Gauss-Seidel over a plain grid. */
    std::vector<double>
    minimise() const
    {
      const std::vector<unsigned int> &nodes =
        hierarchy.finest().nonsmooth_nodes;
      std::vector<double> v(b.locally_owned_size());
      for (unsigned int sweep = 0; sweep < 4000; ++sweep)
        for (unsigned int i = 0; i < v.size(); ++i)
          if (hierarchy.finest().fixed.is_active(i, 0))
            {
              const double r = b.local_element(i) + v[i - 1] + v[i + 1] +
                               v[i - n - 1] + v[i + n + 1];
              const double g =
                std::binary_search(nodes.begin(), nodes.end(), i) ? load : 0.;
              v[i] = std::copysign(std::max(std::abs(r) - g, 0.), r) /
                     (4. + 1. / (n * n));
            }
      return v;
    }

    /** Compare with minimise(); at some nonsmooth nodes v = 0, at others
     * not. */
    void
    expect_minimiser(const NodalVector &v) const
    {
      const std::vector<double> exact = minimise();
      double                    size  = 0;
      for (const double value : exact)
        size = std::max(size, std::abs(value));
      for (unsigned int i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(v.local_element(i), exact[i], 1e-8 * size) << i;
      unsigned int n_zeros = 0;
      for (const unsigned int i : hierarchy.finest().nonsmooth_nodes)
        {
          EXPECT_EQ(v.local_element(i) == 0., exact[i] == 0.) << i;
          n_zeros += exact[i] == 0.;
        }
      EXPECT_GT(n_zeros, 2u);
      EXPECT_LT(n_zeros + 2, hierarchy.finest().nonsmooth_nodes.size());
    }
  };
} // namespace



TEST(OneComponent, CycleConvergesAlikeOnAllGrids)
{
  for (const unsigned int n : {8, 32, 128})
    {
      GridProblem        problem(n, GridProblem::none);
      LevelHierarchy<1> &hierarchy = problem.hierarchy;
      hierarchy.set_cycle_precision(CyclePrecision::double_precision);
      hierarchy.linearise({}, hierarchy.finest().fixed);
      NodalVector r = problem.b, x = r, correction = r;
      for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
        r.local_element(i) = (i * 7919 % 101) / 50. - 1.;
      hierarchy.finest().fixed.apply(r);
      // The error is x itself where the right hand side is zero.
      x                 = r;
      const double size = x.l2_norm();
      for (unsigned int cycle = 0; cycle < 8; ++cycle)
        {
          hierarchy.vmult_linearised(r, x);
          hierarchy.v_cycle(correction, r);
          x -= correction;
        }
      EXPECT_LT(x.l2_norm(), std::pow(0.2, 8) * size) << n;
    }
}



TEST(OneComponent, TNNMGFindsTheMinimiser)
{
  for (const auto where : {GridProblem::everywhere, GridProblem::middle_row})
    {
      GridProblem     problem(32, where);
      TNNMGParameters parameters;
      parameters.tolerance = 1e-10;
      NodalVector v(problem.b);
      v                          = 0.;
      const SolveSummary summary = TNNMGSolver<1>(problem.hierarchy, parameters)
                                     .solve(problem.functional(), problem.b, v);
      EXPECT_TRUE(summary.converged) << summary;
      EXPECT_LE(summary.iterations.size(), 20u) << summary;
      problem.expect_minimiser(v);
    }
}



TEST(OneComponent, CondensedSolverFindsTheMinimiser)
{
  GridProblem     problem(32, GridProblem::middle_row);
  TNNMGParameters parameters;
  parameters.tolerance = 1e-10;
  NodalVector v(problem.b);
  v = 0.;
  const SolveSummary summary =
    CondensedSolver<1>(problem.hierarchy.operators(), parameters)
      .solve(problem.functional(), problem.b, v);
  EXPECT_TRUE(summary.converged) << summary;
  problem.expect_minimiser(v);
}
