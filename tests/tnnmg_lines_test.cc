// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>
#include <stickslip/algebra/masked_entries.h>
#include <stickslip/multigrid/line_factors.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <iostream>

#include "layered_slider.h"
#include "linear_iterations.h"
#include "random_vectors.h"
#include "stuck_faults.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies of 1 m with cells so many times as tall as wide. */
  std::array<unsigned int, 2>
  tall_cells(const unsigned int aspect)
  {
    return {{10 * aspect, 2}};
  }



  /** Frictionless, each tangential jump truncated with this probability. */
  NodeMask
  truncate(LevelHierarchy<2> &hierarchy, const double probability)
  {
    std::mt19937   engine(5);
    const NodeMask active =
      random_truncation(hierarchy.finest(), probability, engine);
    linearise_without_friction(hierarchy, active);
    return active;
  }



  std::vector<NodeLine>
  lines_of(LevelHierarchy<2> &hierarchy)
  {
    return find_strong_lines(hierarchy.operators().matrix().sparsity(),
                             hierarchy.operators().terms(),
                             hierarchy.finest().fixed,
                             hierarchy.finest().nonsmooth_nodes);
  }



  /** A chain of n nodes whose blocks are random in a band; a ring if the first
   * and the last couple, too. */
  BlockMatrix<2>
  random_chain(const unsigned int n, const unsigned int width, const bool ring)
  {
    std::mt19937                           engine(3);
    std::normal_distribution<double>       normal(0., 0.05);
    std::vector<std::vector<unsigned int>> rows(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i > width ? i - width : 0; j < i; ++j)
        {
          rows[i].push_back(j);
          rows[j].push_back(i);
        }
    if (ring)
      {
        rows[0].push_back(n - 1);
        rows[n - 1].push_back(0);
      }
    BlockMatrix<2>       A(std::make_shared<const BlockSparsity>(rows));
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          const unsigned int j = sparsity.column[k];
          if (j > i)
            continue;
          double *ij = A.block(k), *ji = A.block(sparsity.position(j, i));
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d <= (i == j ? c : 1); ++d)
              {
                const bool diagonal = c == d;
                // Positive definite by its diagonal.
                ij[2 * c + d] = normal(engine) / width +
                                (diagonal ? (i == j ? 4. : -1.7 / width) : 0.);
                ji[2 * d + c] = ij[2 * c + d];
              }
        }
    return A;
  }
} // namespace



TEST(TNNMGLines, AreTheRowsOfTallCellsAndNowhereElse)
{
  LayeredSlider square(tall_cells(1), tall_cells(1), 4);
  square.set_step(1e-2, 2.5e4);
  EXPECT_TRUE(lines_of(square.problem.hierarchy()).empty());

  LayeredSlider tall(tall_cells(20), tall_cells(20), 1);
  tall.set_step(1e-2, 2.5e4);
  std::map<unsigned int, Point<2>> position;
  tall.for_each_node(
    [&](const unsigned int node, const Point<2> &x) { position[node] = x; });
  std::map<double, unsigned int> rows;
  for (const NodeLine &line : lines_of(tall.problem.hierarchy()))
    {
      for (const unsigned int i : line)
        EXPECT_EQ(position[i][1], position[line.front()][1]);
      rows[position[line.front()][1]] =
        std::max<unsigned int>(rows[position[line.front()][1]], line.size());
    }
  // Two rows of the fault, the finer ones next to it, and those farther away;
  // the lower side is held.
  EXPECT_GE(rows.size(), 6u);
  for (const auto &row : rows)
    EXPECT_GE(row.second, 195u) << row.first;
}



TEST(TNNMGLines, AreSolvedExactlyInTheComponentsThatTakePart)
{
  constexpr unsigned int n = 40;
  for (const unsigned int width : {1, 2, 3})
    for (const bool some_masked : {false, true})
      {
        const BlockMatrix<2> A = random_chain(n, width, false);
        NodeMask             active(n, 2);
        if (some_masked)
          for (const unsigned int i : {0, 7, 8, 21})
            {
              active.mask(i, i % 2);
              if (i == 8)
                active.mask_node(i);
            }
        // From the last to the first, so that places are no numbers of nodes.
        NodeLine line(n);
        for (unsigned int i = 0; i < n; ++i)
          line[i] = n - 1 - i;
        LineFactors<2, double> factors(A.sparsity(), {line});
        for (unsigned int i = 0; i < n; ++i)
          {
            factors.set_row(i, A);
            factors.set_diagonal(i, A.diagonal_block(i), active);
          }
        factors.factorise();

        FullMatrix<double> dense(2 * n, 2 * n);
        Vector<double>     b(2 * n), x(2 * n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int k = A.sparsity().row_start[i];
               k < A.sparsity().row_start[i + 1];
               ++k)
            for (unsigned int c = 0; c < 2; ++c)
              for (unsigned int d = 0; d < 2; ++d)
                dense(2 * i + c, 2 * A.sparsity().column[k] + d) =
                  masked_entry(A, active, i, k, c, d);
        std::vector<double> values(2 * n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            {
              const double value          = std::sin(1. + 3. * i + c);
              b[2 * i + c]                = active.is_active(i, c) ? value : 0.;
              values[2 * (n - 1 - i) + c] = value;
            }
        dense.gauss_jordan();
        dense.vmult(x, b);
        factors.solve(0, values.data());
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            EXPECT_NEAR(values[2 * (n - 1 - i) + c],
                        x[2 * i + c],
                        1e-10 * x.linfty_norm());
      }
}



TEST(TNNMGLines, OpenRings)
{
  const BlockMatrix<2>        ring  = random_chain(40, 1, true);
  const std::vector<NodeLine> lines = find_strong_lines(
    ring.sparsity(), std::vector<BlockMatrix<2>>{ring}, NodeMask(40, 2), {});
  unsigned int n = 0;
  for (const NodeLine &line : lines)
    {
      n += line.size();
      // The first and the last node couple; so they are neighbours or in two.
      const auto first = std::find(line.begin(), line.end(), 0u),
                 last  = std::find(line.begin(), line.end(), 39u);
      if (first != line.end() && last != line.end())
        {
          EXPECT_EQ(std::abs(first - last), 1);
        }
    }
  EXPECT_GE(n, 20u);
}



TEST(TNNMGLines, MakeSymmetricCycles)
{
  LayeredSlider slider(tall_cells(20), {{140, 2}}, 2);
  slider.set_step(1e-2, 2.5e4);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  for (const unsigned int sweeps : {1, 2})
    {
      hierarchy.set_smoothing_sweeps(sweeps);
      expect_symmetric_cycle(hierarchy, truncate(hierarchy, 0.5), 1e-12);
    }
}



TEST(TNNMGLines, AreFactorisedAnewWhereSomethingChanges)
{
  const auto make = []() {
    auto slider =
      std::make_unique<LayeredSlider>(tall_cells(10),
                                      std::array<unsigned int, 2>{{70, 2}},
                                      2);
    slider->problem.hierarchy().set_cycle_precision(
      CyclePrecision::double_precision);
    return slider;
  };
  const auto         lasting   = make();
  LevelHierarchy<2> &hierarchy = lasting->problem.hierarchy();
  for (const double probability : {0.5, 0., 1., 0.9, 0.2})
    for (const double tau : {1e-2, 1e-4})
      {
        const auto fresh = make();
        for (LayeredSlider *slider : {lasting.get(), fresh.get()})
          slider->problem.combine(Newmark<2>().operator_coefficients(tau));
        const NodeMask    active = truncate(hierarchy, probability);
        const NodalVector b      = random_vector(hierarchy.finest(), active, 3);
        NodalVector       x = b, y = b;
        hierarchy.v_cycle(x, b);
        truncate(fresh->problem.hierarchy(), probability);
        fresh->problem.hierarchy().v_cycle(y, b);
        const double size = y.linfty_norm();
        x -= y;
        EXPECT_LE(x.linfty_norm(), 1e-10 * size) << probability << ' ' << tau;
      }
}



TEST(TNNMGLines, PassHangingNodes)
{
  // Rows next to the fault have fine cells in their left halves only, and so
  // end at hanging nodes above and below.
  std::vector<BodyGeometry<2>> bodies = {make_body<2>(1., tall_cells(10), 2),
                                         make_body<2>(1., {{70, 2}}, 2)};
  for (BodyGeometry<2> &body : bodies)
    {
      body.refine_where.set("0.01 - x");
      body.refinement_rows = 2;
    }
  SpatialScene<2>      scene(stack<2>(bodies),
                        {make_side<2>("0",
                                      BodyMesh<2>::lower_side,
                                      {{BoundaryType::fixed,
                                             BoundaryType::fixed}})},
                        {Material(), Material()},
                        0.);
  LevelHierarchy<2>   &hierarchy = scene.problem.hierarchy();
  const NodeMask      &fixed     = hierarchy.finest().fixed;
  const BlockSparsity &sparsity  = hierarchy.operators().matrix().sparsity();
  std::vector<bool>    is_hanging(sparsity.n_rows(), false);
  unsigned int         n_hanging = 0;
  const MeshLevel<2>  &level     = scene.meshes.finest();
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int i = 0; i < level.bodies[b]->node_positions().size(); ++i)
      if (level.bodies[b]->bound_nodes().is_constrained(i))
        {
          is_hanging[level.node(b, i)] = true;
          ++n_hanging;
        }
  EXPECT_GE(n_hanging, 100u);
  std::size_t longest = 0;
  for (const NodeLine &line :
       find_strong_lines(sparsity,
                         hierarchy.operators().terms(),
                         fixed,
                         hierarchy.finest().nonsmooth_nodes))
    {
      longest = std::max(longest, line.size());
      for (const unsigned int i : line)
        EXPECT_FALSE(is_hanging[i]);
    }
  // Finer ones and coarser ones along the fault.
  EXPECT_GE(longest, 180u);

  for (const double tau : {1e-1, 1e-3})
    {
      scene.problem.combine(Newmark<2>().operator_coefficients(tau));
      for (const double probability : {0., 0.5, 1.})
        {
          const NodeMask active = truncate(hierarchy, probability);
          EXPECT_LE(cg_iterations(hierarchy,
                                  random_vector(hierarchy.finest(), active, 7)),
                    14u)
            << tau << ' ' << probability;
        }
    }
}



TEST(TNNMGLines, KeepTheNumberOfStepsForAllAspects)
{
  // Fine cells as the faults of a run see them: of the size of the square ones
  // in one direction.
  std::vector<unsigned int> square;
  for (const unsigned int aspect : {1, 3, 5, 10, 20, 50})
    {
      LayeredSlider slider(tall_cells(aspect), tall_cells(aspect), 2);
      std::vector<unsigned int> steps;
      for (const double tau : {1e-1, 1e-3})
        {
          slider.set_step(tau, 2.5e4);
          LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
          for (const double probability : {0., 0.5, 1.})
            {
              const NodeMask active = truncate(hierarchy, probability);
              steps.push_back(
                cg_iterations(hierarchy,
                              random_vector(hierarchy.finest(), active, 7)));
            }
        }
      std::cout << "aspect " << aspect << ':';
      for (const unsigned int n : steps)
        std::cout << ' ' << n;
      std::cout << std::endl;
      if (aspect == 1)
        square = steps;
      for (unsigned int k = 0; k < steps.size(); ++k)
        EXPECT_LE(steps[k], 2 * square[k]) << aspect << ", " << k;
    }
}
