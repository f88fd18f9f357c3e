// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "layered_slider.h"
#include "linear_iterations.h"
#include "nan_in_debug_mode.h"
#include "random_vectors.h"
#include "serial_matrices.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr std::array<unsigned int, 2> cells    = {{10, 2}};
  constexpr unsigned int                passes[] = {2, 3, 4, 5};

  /** Equal to the last bit. */
  bool
  is_equal(const NodalVector &x, const NodalVector &y)
  {
    return std::equal(x.begin(), x.end(), y.begin());
  }



  /** Friction whose state alpha is the position along the fault, m. */
  Friction<2>
  friction_along(const LayeredSlider &slider)
  {
    return slider.friction(Kind::truncated,
                           [](const double x, const unsigned) { return x; });
  }



  /** Each tangential jump is truncated with this probability. */
  NodeMask
  truncation(const LevelDescription<2> &finest, const double probability)
  {
    static std::mt19937 engine(5);
    return random_truncation(finest, probability, engine);
  }



  /** Without friction, where it is not truncated. */
  void
  truncate(LevelHierarchy<2> &hierarchy, const NodeMask &active)
  {
    linearise_without_friction(hierarchy, active);
  }



  /** The levels of a slider, described anew, with what is truncated on the
   * finest level handed down: a coarse jump is dropped if all fine jumps in its
   * reach are. */
  std::vector<LevelDescription<2>>
  describe_levels(LayeredSlider &slider, const NodeMask &active)
  {
    const unsigned int n_levels = slider.meshes.n_levels();
    const FaultSides   sides    = slider.problem.jump_basis().faults()[0].sides;
    std::vector<LevelDescription<2>> levels(n_levels);
    std::vector<JumpBasis<2>>        bases;
    for (unsigned int l = 0; l < n_levels; ++l)
      {
        const MeshLevel<2> &mesh      = slider.meshes.level(l);
        const NodeMask      dirichlet = slider.boundary.dirichlet_mask(l);
        bases.push_back(undeformed_basis(mesh, {sides}, dirichlet));
        levels[l].nodes           = mesh.nodes;
        levels[l].nonsmooth_nodes = bases[l].contact_nodes();
        levels[l].fixed           = dirichlet;
        for (unsigned int b = 0; b < mesh.bodies.size(); ++b)
          for (const auto &line : mesh.bodies[b]->bound_nodes().get_lines())
            levels[l].fixed.mask_node(mesh.node(b, line.index));
        for (const unsigned int p : levels[l].nonsmooth_nodes)
          levels[l].fixed.mask(p, 1);
      }
    const BlockSparsity *sparsity =
      &slider.problem.operators().matrix().sparsity();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        levels[l].to_coarser = std::make_shared<GalerkinProduct<2>>(
          levels[l].nodes,
          *sparsity,
          jump_prolongation_rows(bases[l - 1], bases[l], slider.meshes, l),
          levels[l - 1].nodes.owned());
        sparsity = levels[l].to_coarser->coarse_sparsity().get();
      }

    levels.back().fixed = active;
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        std::vector<bool> reaches_active(levels[l - 1].fixed.n_nodes(), false);
        const auto       &P = levels[l].to_coarser->prolongation().matrix();
        for (const unsigned int i : levels[l].nonsmooth_nodes)
          for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
            if (levels[l].fixed.is_active(i, 0))
              reaches_active[P.column[k]] = true;
        for (const unsigned int I : levels[l - 1].nonsmooth_nodes)
          if (!reaches_active[I])
            levels[l - 1].fixed.mask(I, 0);
      }
    return levels;
  }
} // namespace



TEST(Multigrid, CycleIsSymmetric)
{
  LayeredSlider      slider(cells, {{14, 2}}, 3);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  slider.set_step(1e-2, 0.);
  for (const unsigned int sweeps : {1, 2})
    for (const double probability : {0., 0.5, 1.})
      {
        hierarchy.set_smoothing_sweeps(sweeps);
        hierarchy.set_coarse_solver(sweeps == 1 ? CoarseSolverType::direct :
                                                  CoarseSolverType::amg);
        const NodeMask active = truncation(hierarchy.finest(), probability);
        std::vector<Tensor<2, 2>> H(hierarchy.finest().nonsmooth_nodes.size());
        for (unsigned int k = 0; k < H.size(); ++k)
          if (active.is_active(hierarchy.finest().nonsmooth_nodes[k], 0))
            H[k][0][0] = 1e6 * (k % 7);
        hierarchy.linearise(H, active);
        expect_symmetric_cycle(hierarchy, active, 1e-13);
        const NodalVector y    = random_vector(hierarchy.finest(), active);
        NodalVector       once = y, again = y;
        hierarchy.v_cycle(once, y);
        hierarchy.v_cycle(again, y);
        EXPECT_TRUE(is_equal(once, again));
      }
}



TEST(Multigrid, ConvergesAlikeOnAllLevels)
{
  for (const double probability : {0., 1.})
    {
      unsigned int least = 100, most = 0;
      for (const unsigned int n : passes)
        {
          LayeredSlider slider(cells, cells, n);
          slider.set_step(1e-2, 0.);
          LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
          const NodeMask active = truncation(hierarchy.finest(), probability);
          truncate(hierarchy, active);
          const unsigned int iterations =
            cg_iterations(hierarchy, random_vector(hierarchy.finest(), active));
          least = std::min(least, iterations);
          most  = std::max(most, iterations);
        }
      EXPECT_LE(most, 15u) << probability;
      EXPECT_LE(most - least, 2u) << probability;
    }
}



TEST(Multigrid, RandomTruncationDoesNotDiverge)
{
  // Meshes that match at the fault, and others that do not.
  for (const unsigned int upper_cells : {10u, 14u})
    {
      LayeredSlider slider(cells, {{upper_cells, 2}}, 4);
      slider.set_step(1e-2, 0.);
      LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
      for (const double probability : {0.1, 0.5, 0.9})
        {
          SCOPED_TRACE(testing::Message() << upper_cells << ' ' << probability);
          const NodeMask active = truncation(hierarchy.finest(), probability);
          truncate(hierarchy, active);

          // The error of the plain iteration in the energy norm.
          NodalVector error   = random_vector(hierarchy.finest(), active);
          NodalVector product = error, correction = error;
          hierarchy.vmult_linearised(product, error);
          const double first = std::sqrt(error * product);
          double       old   = first;
          for (unsigned int k = 0; k < 30; ++k)
            {
              hierarchy.v_cycle(correction, product);
              error -= correction;
              hierarchy.vmult_linearised(product, error);
              const double norm = std::sqrt(error * product);
              EXPECT_LT(norm, old);
              old = norm;
            }
          EXPECT_LT(std::pow(old / first, 1. / 30), 0.7);
          EXPECT_LE(cg_iterations(hierarchy,
                                  random_vector(hierarchy.finest(), active)),
                    15u);
        }
    }
}



TEST(Multigrid, LinearisationNearFaultsEqualsAllProducts)
{
  LayeredSlider      slider(cells, {{14, 2}}, 3);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  const auto &nodes = hierarchy.finest().nonsmooth_nodes;
  slider.set_step(1e-2, 0.);

  // One after the other on the same hierarchy, so that traces of the last one
  // would show.
  for (const double probability : {0.5, 1., 0., 0.9, 0.2})
    for (const double tau : {1e-2, 1e-4})
      {
        SCOPED_TRACE(testing::Message() << probability << ' ' << tau);
        slider.set_step(tau, 0.);
        const NodeMask active = truncation(hierarchy.finest(), probability);
        BlockMatrix<2> A      = hierarchy.operators().matrix();
        std::vector<Tensor<2, 2>> H(nodes.size());
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (active.is_active(nodes[k], 0))
            {
              H[k][0][0] = 2.5 * (k % 5) * A.diagonal_block(nodes[k])[0][0];
              A.set_diagonal_block(nodes[k], A.diagonal_block(nodes[k]) + H[k]);
            }
        hierarchy.linearise(H, active);

        const auto        levels = describe_levels(slider, active);
        OperatorSum<2>    only_A(levels.back(), {A});
        LevelHierarchy<2> anew(only_A, levels);
        anew.set_cycle_precision(CyclePrecision::double_precision);
        only_A.combine({1.});
        truncate(anew, active);

        const NodalVector b = random_vector(hierarchy.finest(), active);
        NodalVector       x = b, y = b;
        hierarchy.v_cycle(x, b);
        anew.v_cycle(y, b);
        const double size = y.linfty_norm();
        x -= y;
        EXPECT_LE(x.linfty_norm(), 1e-12 * size);

        hierarchy.vmult_linearised(x, b);
        anew.vmult_linearised(y, b);
        x -= y;
        EXPECT_LE(x.linfty_norm(), 1e-14 * y.linfty_norm());
      }
}



TEST(Multigrid, StepSizeBackAndForthChangesNothing)
{
  LayeredSlider      slider(cells, {{14, 2}}, 3);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  const Friction<2>  friction  = friction_along(slider);
  TNNMGParameters    parameters;
  const auto         solve = [&](const double tau) {
    const NodalVector b = slider.set_step(tau, 0.6 * slider.normal_stress);
    NodalVector       w = slider.start();
    EXPECT_TRUE(TNNMGSolver<2>(hierarchy, parameters)
                  .solve(*friction.functional, b, w)
                  .converged);
    return w;
  };
  const NodalVector first = solve(1e-2), other = solve(1e-3);
  EXPECT_FALSE(is_equal(first, other));
  EXPECT_TRUE(is_equal(solve(1e-2), first));
  EXPECT_TRUE(is_equal(solve(1e-3), other));
}



TEST(Multigrid, SingularCoarseMatrixLeavesTheOperatorAsItWas)
{
  SKIP_WHERE_NAN_IS_FATAL();
  LayeredSlider      slider(cells, cells, 2);
  LevelHierarchy<2> &hierarchy = slider.problem.hierarchy();
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  // Coarse rows that are formed again are rounded in another way.
  const auto expect_same = [](NodalVector again, const NodalVector &first) {
    again -= first;
    EXPECT_LT(again.linfty_norm(), 1e-13 * first.linfty_norm());
  };
  const NodeMask   &active = hierarchy.finest().fixed;
  const NodalVector b      = random_vector(hierarchy.finest(), active);
  NodalVector       first = b, again = b;
  slider.set_step(1e-2, 0.);
  truncate(hierarchy, active);
  hierarchy.v_cycle(first, b);

  const double              nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Tensor<2, 2>> no_numbers(
    hierarchy.finest().nonsmooth_nodes.size());
  for (Tensor<2, 2> &H : no_numbers)
    H[0][0] = nan;
  EXPECT_THROW(hierarchy.linearise(no_numbers, active), SingularCoarseMatrix);
  truncate(hierarchy, active);
  hierarchy.v_cycle(again, b);
  expect_same(again, first);

  hierarchy.operators().combine({0., 0., 0.});
  EXPECT_THROW(truncate(hierarchy, active), SingularCoarseMatrix);
  slider.set_step(1e-2, 0.);
  truncate(hierarchy, active);
  hierarchy.v_cycle(again, b);
  expect_same(again, first);
}



TEST(TNNMG, IterationsDoNotGrowWithTheMesh)
{
  struct Moment
  {
    const char *name;
    double      tau, traction;
    double (*alpha)(double, unsigned int);
  };
  const Moment moments[] = {
    {"stuck", 1e-1, 0.3, [](double, unsigned) { return 0.; }},
    {"half and half",
     1e-2,
     0.65,
     [](double x, unsigned) { return 3.5 + 10.5 * std::tanh(x / 0.5); }},
    {"slipping", 1e-3, 0.75, [](double, unsigned) { return 0.; }}};

  TNNMGParameters parameters;
  for (const Kind kind : {Kind::truncated, Kind::arcsinh})
    for (const Moment &moment : moments)
      {
        unsigned int least = 100, most = 0;
        for (const unsigned int n : passes)
          {
            LayeredSlider     slider(cells, cells, n);
            const NodalVector b =
              slider.set_step(moment.tau,
                              moment.traction * slider.normal_stress);
            const Friction<2>  friction = slider.friction(kind, moment.alpha);
            NodalVector        w        = slider.start();
            const SolveSummary summary =
              TNNMGSolver<2>(slider.problem.hierarchy(), parameters)
                .solve(*friction.functional, b, w);
            EXPECT_TRUE(summary.converged) << summary;
            const unsigned int iterations = summary.iterations.size();
            least                         = std::min(least, iterations);
            most                          = std::max(most, iterations);
          }
        EXPECT_LE(most, 12u) << moment.name;
        EXPECT_LE(most - least, 2u) << moment.name;
      }
}



TEST(TNNMG, CoarseLevelsMayLagBehind)
{
  // A state that varies along the fault, so that all curvatures differ and
  // change in the course of the iteration.
  LayeredSlider     slider(cells, cells, 4);
  const NodalVector b = slider.set_step(1e-3, 0.7 * slider.normal_stress);
  for (const Kind kind : {Kind::truncated, Kind::arcsinh})
    {
      const Friction<2> friction =
        slider.friction(kind, [](double x, unsigned) { return 2. * x; });
      NodalVector  reference   = slider.start();
      unsigned int n_reference = 0;
      for (const double threshold : {0., 0.5, 1e9})
        {
          TNNMGParameters parameters;
          parameters.tolerance               = 1e-11;
          parameters.coarse_update_threshold = threshold;
          NodalVector        w               = slider.start();
          const SolveSummary summary =
            TNNMGSolver<2>(slider.problem.hierarchy(), parameters)
              .solve(*friction.functional, b, w);
          EXPECT_TRUE(summary.converged) << summary;
          if (threshold == 0.)
            {
              reference   = w;
              n_reference = summary.iterations.size();
            }
          if (threshold <= 0.5)
            {
              EXPECT_LE(summary.iterations.size(), n_reference + 1) << summary;
            }
          w -= reference;
          EXPECT_LT(w.linfty_norm(), 1e-9 * reference.linfty_norm());
        }
    }
}



TEST(TNNMG, CoarsestLevelMayBeSolvedByAMG)
{
  // 2,142 nodes on the coarsest level: MUMPS factorises it.
  LayeredSlider   slider({{60, 12}}, {{84, 16}}, 2);
  TNNMGParameters parameters;
  parameters.tolerance             = 1e-11;
  parameters.cycles_per_correction = 3;
  const NodalVector b              = slider.set_step(1e-1, 0.6 * 4.9e4);
  const Friction<2> friction       = friction_along(slider);
  NodalVector       solution[2];
  unsigned int      n_iterations[2];
  for (const unsigned int i : {0, 1})
    {
      parameters.coarse_solver =
        (i == 0 ? CoarseSolverType::direct : CoarseSolverType::amg);
      TNNMGSolver<2> solver(slider.problem.hierarchy(), parameters);
      solution[i] = slider.start();
      const SolveSummary summary =
        solver.solve(*friction.functional, b, solution[i]);
      EXPECT_TRUE(summary.converged);
      n_iterations[i] = summary.iterations.size();
    }
  EXPECT_LE(n_iterations[1], n_iterations[0] + 3);
  const double size = solution[0].linfty_norm();
  EXPECT_GT(size, 0.);
  solution[0] -= solution[1];
  EXPECT_LT(solution[0].linfty_norm(), 1e-8 * size);
}



TEST(TNNMG, SlowCyclesAreAnsweredByMoreOfThem)
{
  // Cells 25 times as wide as high, over which Gauss-Seidel is slow.
  LayeredSlider     slider({{4, 20}}, {{5, 24}}, 3);
  const NodalVector b        = slider.set_step(1e-1, 0.6 * 4.9e4);
  const Friction<2> friction = friction_along(slider);
  TNNMGParameters   parameters;
  parameters.tolerance = 1e-11;
  NodalVector  solution[2];
  unsigned int n_iterations[2], n_cycles[2];
  for (const unsigned int i : {0, 1})
    {
      parameters.linear_reduction =
        (i == 0 ? 1. : TNNMGParameters().linear_reduction);
      TNNMGSolver<2> solver(slider.problem.hierarchy(), parameters);
      solution[i] = slider.start();
      const SolveSummary summary =
        solver.solve(*friction.functional, b, solution[i]);
      EXPECT_TRUE(summary.converged);
      n_iterations[i] = summary.iterations.size();
      n_cycles[i]     = summary.n_cycles();
      for (unsigned int k = 0; i == 0 && k < n_iterations[0]; ++k)
        EXPECT_EQ(summary.iterations[k].cycles, k < 3 ? 1 : 2);
    }
  EXPECT_LE(3 * n_iterations[1], 2 * n_iterations[0]);
  EXPECT_LE(n_cycles[1], n_cycles[0]);
  const double size = solution[0].linfty_norm();
  solution[0] -= solution[1];
  EXPECT_LT(solution[0].linfty_norm(), 1e-8 * size);
}
