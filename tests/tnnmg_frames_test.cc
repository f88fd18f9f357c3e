// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_cg.h>

#include <gtest/gtest.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/mechanics/node_constraint.h>
#include <stickslip/multigrid/linearised_operator.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "bent_block.h"
#include "coulomb_functional.h"
#include "linear_iterations.h"
#include "random_vectors.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  double
  relative_difference(NodalVector x, const NodalVector &y)
  {
    x -= y;
    return x.linfty_norm() / y.linfty_norm();
  }



  /** The largest difference of an entry of two matrices over the largest entry,
   * the one along axes of nodes, the other one in space. */
  template <int dim>
  double
  difference(const BlockMatrix<dim> &along_axes,
             const LocalFrames      &frames,
             const BlockMatrix<dim> &in_space)
  {
    const auto axes = [&](const unsigned int i) {
      Tensor<2, dim> R;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          R[c][d] = (frames.find(i) ? frames.find(i)[c * dim + d] : c == d);
      return R;
    };
    const BlockSparsity &sparsity = along_axes.sparsity();
    EXPECT_EQ(sparsity.column, in_space.sparsity().column);
    double largest = 0, error = 0;
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          Tensor<2, dim> block, expected;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              {
                block[c][d]    = along_axes.block(k)[c * dim + d];
                expected[c][d] = in_space.block(k)[c * dim + d];
              }
          block   = axes(i) * block * transpose(axes(sparsity.column[k]));
          error   = std::max(error, (block - expected).norm());
          largest = std::max(largest, expected.norm());
        }
    return error / largest;
  }



  /** Compare a problem in the axes of space and in those of the nodes, with
   * curvature at the lower side, where every third node is masked. */
  template <int dim>
  void
  compare_with_problem_in_space(const BentBlock<dim> &block,
                                const bool            all_nodes_turned,
                                const CyclePrecision  precision,
                                const double          tolerance)
  {
    auto space = block.make(std::vector<NodeFrames<dim>>(block.n_levels),
                            false,
                            MPI_COMM_SELF);
    auto turned =
      block.make(block.random_frames(all_nodes_turned), false, MPI_COMM_SELF);
    LevelHierarchy<dim>         &in_space = *space.hierarchy;
    LevelHierarchy<dim>         &along    = *turned.hierarchy;
    const LevelDescription<dim> &finest   = along.finest();
    const LocalFrames           &frames   = finest.frames;
    ASSERT_FALSE(frames.empty());
    in_space.set_cycle_precision(precision);
    along.set_cycle_precision(precision);

    // Several linearisations, so that rows near changes are formed anew.
    std::mt19937                     engine(9);
    std::normal_distribution<double> normal;
    for (unsigned int step = 0; step < 3; ++step)
      {
        SCOPED_TRACE(step);
        NodeMask                    active = finest.fixed;
        std::vector<Tensor<2, dim>> H, R_H;
        for (const unsigned int i : finest.nonsmooth_nodes)
          {
            if ((i + step) % 3 == 0)
              active.mask_node(i);
            Tensor<2, dim> h;
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                h[c][d] = normal(engine);
            H.push_back(h * transpose(h));
            Tensor<2, dim> R;
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                R[c][d] =
                  (frames.find(i) ? frames.find(i)[c * dim + d] : c == d);
            R_H.push_back(transpose(R) * H.back() * R);
          }
        in_space.linearise(H, active);
        along.linearise(R_H, active);
        for (unsigned int l = 0; l < block.n_levels; ++l)
          EXPECT_LT(difference(along.level_matrix(l),
                               along.description(l).frames,
                               in_space.level_matrix(l)),
                    tolerance)
            << "level " << l;

        const NodalVector b        = random_vector(finest, active, step);
        NodalVector       b_turned = b, x = b, x_turned = b;
        to_frames(b_turned, frames);
        in_space.v_cycle(x, b);
        along.v_cycle(x_turned, b_turned);
        to_space(x_turned, frames);
        EXPECT_LT(relative_difference<dim>(x_turned, x), 10 * tolerance);
        EXPECT_EQ(cg_iterations(along, b_turned), cg_iterations(in_space, b));
      }
  }



  /** Each tangential component of the lower side is truncated with this
   * probability. */
  template <int dim>
  NodeMask
  truncation(const LevelDescription<dim> &finest, const double probability)
  {
    std::mt19937 engine(5);
    return random_truncation(finest, probability, engine);
  }



  /** CG iterations for a block that slides along its lower side, with random
   * truncation there, bent and straight. */
  template <int dim>
  std::array<unsigned int, 2>
  iterations_of_sliding_blocks(const std::array<unsigned int, dim> &cells,
                               const unsigned int                   n_levels,
                               const double                         probability)
  {
    std::array<unsigned int, 2> iterations;
    for (const bool is_bent : {true, false})
      {
        const BentBlock<dim> block(cells, n_levels, is_bent);
        const auto           problem =
          block.make(block.frames_of_lower_side(), true, MPI_COMM_SELF);
        LevelHierarchy<dim> &hierarchy = *problem.hierarchy;
        EXPECT_EQ(hierarchy.finest().frames.empty(), !is_bent);
        const NodeMask active = truncation(hierarchy.finest(), probability);
        linearise_without_friction(hierarchy, active);
        iterations[is_bent ? 0 : 1] =
          cg_iterations(hierarchy,
                        random_vector(hierarchy.finest(), active, 1));
      }
    return iterations;
  }
} // namespace



TEST(Frames, CyclesEqualThoseInSpace)
{
  const BentBlock<2> block({{4, 2}}, 3, true);
  const BentBlock<3> block_3d({{3, 2, 1}}, 3, true);
  for (const bool all : {false, true})
    {
      SCOPED_TRACE(all);
      compare_with_problem_in_space(block,
                                    all,
                                    CyclePrecision::double_precision,
                                    1e-13);
      compare_with_problem_in_space(block,
                                    all,
                                    CyclePrecision::single_precision,
                                    1e-6);
      compare_with_problem_in_space(block_3d,
                                    all,
                                    CyclePrecision::double_precision,
                                    1e-13);
      compare_with_problem_in_space(block_3d,
                                    all,
                                    CyclePrecision::single_precision,
                                    1e-6);
    }
}



TEST(Frames, CycleIsSymmetric)
{
  const BentBlock<2> block({{8, 2}}, 4, true);
  const auto         problem =
    block.make(block.frames_of_lower_side(), true, MPI_COMM_SELF);
  LevelHierarchy<2> &hierarchy = *problem.hierarchy;
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  for (const CoarseSolverType type :
       {CoarseSolverType::direct, CoarseSolverType::amg})
    {
      hierarchy.set_coarse_solver(type);
      const NodeMask active = truncation(hierarchy.finest(), 0.5);
      linearise_without_friction(hierarchy, active);
      expect_symmetric_cycle(hierarchy, active, 1e-13);
    }
}



TEST(Frames, SlidingAlongACircleConvergesAsAlongALine)
{
  for (const double probability : {0., 0.5, 1.})
    for (const unsigned int n_levels : {3, 4, 5})
      {
        const auto [bent, straight] =
          iterations_of_sliding_blocks<2>({{8, 2}}, n_levels, probability);
        EXPECT_LE(bent, straight + 1) << probability << ' ' << n_levels;
        EXPECT_LE(straight, 15u);
      }
}



TEST(Frames, SlidingAlongAPipeConvergesAsAlongAPlane)
{
  for (const double probability : {0., 0.5, 1.})
    {
      const auto [bent, straight] =
        iterations_of_sliding_blocks<3>({{6, 2, 2}}, 3, probability);
      EXPECT_LE(bent, straight + 1) << probability;
      EXPECT_LE(straight, 15u);
    }
}



TEST(Frames, AlgebraicMultigridKnowsTheTranslations)
{
  // The one level is solved by cycles of it.
  std::array<unsigned int, 2> iterations;
  for (const bool are_turned : {true, false})
    {
      const BentBlock<2> block({{64, 16}}, 1, true);
      const auto         problem =
        block.make(are_turned ? block.random_frames(true) :
                                std::vector<NodeFrames<2>>(1),
                   false,
                   MPI_COMM_SELF);
      LevelHierarchy<2> &hierarchy = *problem.hierarchy;
      hierarchy.set_coarse_solver(CoarseSolverType::amg);
      hierarchy.set_cycle_precision(CyclePrecision::double_precision);
      const NodeMask &active = hierarchy.finest().fixed;
      linearise_without_friction(hierarchy, active);
      NodalVector b = random_vector(hierarchy.finest(), active, 1);
      to_frames(b, hierarchy.finest().frames);
      iterations[are_turned ? 0 : 1] = cg_iterations(hierarchy, b);
    }
  EXPECT_LE(iterations[0], iterations[1] + 3);
  EXPECT_LE(iterations[1], 30u);
}



TEST(Frames, FrictionAlongACircleConvergesAsAlongALine)
{
  std::array<unsigned int, 2> iterations;
  for (const bool is_bent : {true, false})
    {
      const BentBlock<2> block({{8, 2}}, 4, is_bent);
      const auto         problem =
        block.make(block.frames_of_lower_side(), true, MPI_COMM_SELF);
      LevelHierarchy<2>         &hierarchy = *problem.hierarchy;
      const LevelDescription<2> &finest    = hierarchy.finest();
      const CoulombFunctional<2> friction(
        finest.nonsmooth_nodes,
        std::vector<double>(finest.nonsmooth_nodes.size(), 0.015));
      // Drawn along, weakly at the ends.
      NodalVector b = finest.nodes.make_vector();
      for (unsigned int k = 0; k < finest.nonsmooth_nodes.size(); ++k)
        b.local_element(finest.nonsmooth_nodes[k] * 2) =
          0.02 *
          std::sin(numbers::PI * k / (finest.nonsmooth_nodes.size() - 1));

      TNNMGParameters parameters;
      parameters.tolerance = 1e-10;
      NodalVector        w = finest.nodes.make_vector(), condensed = w;
      const SolveSummary summary =
        TNNMGSolver<2>(hierarchy, parameters).solve(friction, b, w);
      EXPECT_TRUE(summary.converged);
      iterations[is_bent ? 0 : 1] = summary.iterations.size();

      // Sticking nodes and sliding ones.
      unsigned int n_sliding = 0;
      for (const unsigned int i : finest.nonsmooth_nodes)
        n_sliding += (w.local_element(2 * i) != 0.);
      EXPECT_GT(n_sliding, finest.nonsmooth_nodes.size() / 4);
      EXPECT_LT(n_sliding, finest.nonsmooth_nodes.size() * 3 / 4);

      CondensedSolver<2> solver(hierarchy.operators(), parameters);
      EXPECT_TRUE(solver.solve(friction, b, condensed).converged);
      EXPECT_LT(relative_difference<2>(w, condensed), 1e-8);
    }
  EXPECT_LE(iterations[0], iterations[1] + 1);
}



TEST(Frames, RollersAlongTiltedSidesEqualThoseAlongLevelOnes)
{
  // A block that rolls along its left and its lower side.
  const auto solve = [](const BentBlock<2>                &block,
                        const std::vector<NodeFrames<2>>  &frames,
                        const std::array<unsigned int, 2> &normal_of_side,
                        const Tensor<1, 2>                &load) {
    const auto problem = block.make(
      frames,
      [&](const unsigned int l,
          const unsigned int node,
          const unsigned int index,
          NodeMask          &fixed) {
        const bool left  = block.reference_point(l, node)[0] == 0.;
        const bool lower = node < block.n_lower(l);
        if (left && lower)
          fixed.mask_node(index);
        else if (left || lower)
          fixed.mask(index, normal_of_side[left ? 0 : 1]);
      },
      MPI_COMM_SELF);
    LevelHierarchy<2> &hierarchy = *problem.hierarchy;
    hierarchy.set_cycle_precision(CyclePrecision::double_precision);
    linearise_without_friction(hierarchy, hierarchy.finest().fixed);
    NodalVector u = hierarchy.finest().nodes.make_vector(), b = u;
    for (unsigned int i = 0; i < b.size() / 2; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        b.local_element(2 * i + c) = load[c] * std::sin(0.1 * i);
    to_frames(b, hierarchy.finest().frames);
    hierarchy.finest().fixed.apply(b);
    SolverControl control(100, 1e-14 * b.l2_norm());
    SolverCG<NodalVector>(control).solve(LinearisedOperator<2>{hierarchy},
                                         u,
                                         b,
                                         CyclePreconditioner<2>{hierarchy});
    to_space(u, hierarchy.finest().frames);
    return std::make_pair(u, control.last_step());
  };

  const double       tilt = 0.7, c = std::cos(tilt), s = std::sin(tilt);
  const Tensor<2, 2> Q({{c, -s}, {s, c}});
  const Tensor<1, 2> load({1., 0.3});
  const BentBlock<2> level({{4, 2}}, 4, false),
    tilted({{4, 2}}, 4, false, tilt);
  const auto [expected, n_expected] =
    solve(level, std::vector<NodeFrames<2>>(4), {{0, 1}}, load);

  std::vector<NodeFrames<2>> frames(4);
  for (unsigned int l = 0; l < 4; ++l)
    for (unsigned int node = 0; node < tilted.n_nodes(l); ++node)
      {
        NodeConstraint<2> constraint;
        if (tilted.reference_point(l, node)[0] == 0.)
          constraint.add(Q * Tensor<1, 2>({-1., 0.}));
        if (node < tilted.n_lower(l))
          constraint.add(Q * Tensor<1, 2>({0., -1.}));
        if (constraint.size() == 1)
          frames[l].set(node, constraint.axes());
      }
  auto [u, n] = solve(tilted, frames, {{1, 1}}, Q * load);
  EXPECT_EQ(n, n_expected);
  for (unsigned int i = 0; i < u.size() / 2; ++i)
    {
      const Tensor<1, 2> back =
        transpose(Q) *
        Tensor<1, 2>({u.local_element(2 * i), u.local_element(2 * i + 1)});
      for (unsigned int d = 0; d < 2; ++d)
        u.local_element(2 * i + d) = back[d];
    }
  EXPECT_LT(relative_difference<2>(u, expected), 1e-12);
}



TEST(Frames, TransfersAndLevelsMustAgree)
{
  const BentBlock<2> block({{4, 2}}, 2, true);
  const auto         problem =
    block.make(block.frames_of_lower_side(), true, MPI_COMM_SELF);
  std::vector<LevelDescription<2>> levels = {problem.hierarchy->description(0),
                                             problem.hierarchy->description(1)};
  EXPECT_NO_THROW(LevelHierarchy<2>(*problem.operators, levels));
  levels[0].frames = {};
  EXPECT_THROW(LevelHierarchy<2>(*problem.operators, levels), ExceptionBase);
}
