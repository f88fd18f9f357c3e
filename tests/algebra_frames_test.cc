// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <cmath>

#include "random_axes.h"
#include "random_products.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  Tensor<2, 2>
  turned_by(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return Tensor<2, 2>({{c, -s}, {s, c}});
  }



  /** Nodes of a problem that have axes of their own. */
  enum class Turned
  {
    fine,
    coarse,
    some_of_both,
    all
  };

  constexpr Turned all_cases[] = {Turned::fine,
                                  Turned::coarse,
                                  Turned::some_of_both,
                                  Turned::all};



  template <int n_components>
  RandomProblem<n_components>
  turned_problem(const Turned turned)
  {
    RandomProblem<n_components> problem;
    const unsigned int          step = (turned == Turned::all ? 1 : 3);
    if (turned != Turned::coarse)
      // Nodes 3 and 20 with masked components among them.
      for (unsigned int i = 0; i < problem.n_fine; ++i)
        if (i % step == 0 || i == 20)
          problem.fine_frames.set(i,
                                  random_axes<n_components>(problem.generator));
    if (turned != Turned::fine)
      for (unsigned int i = 0; i < problem.n_coarse; i += step)
        problem.coarse_frames.set(i,
                                  random_axes<n_components>(problem.generator));
    return problem;
  }



  /** The axes of all nodes as one matrix. */
  template <int n_components>
  FullMatrix<double>
  expand(const NodeFrames<n_components> &frames, const unsigned int n_nodes)
  {
    FullMatrix<double> R(n_nodes * n_components);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const auto *axes = frames.find(i);
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            R(i * n_components + c, i * n_components + d) =
              (axes == nullptr ? double(c == d) : (*axes)[c][d]);
      }
    return R;
  }



  /** R_f^T P R_c. */
  template <int n_components>
  FullMatrix<double>
  expand_transfer(const RandomProblem<n_components> &problem)
  {
    const FullMatrix<double> P = Tests::expand<n_components>(problem.P);
    FullMatrix<double>       PR(P.m(), P.n()), T(P.m(), P.n());
    P.mmult(PR, expand(problem.coarse_frames, problem.n_coarse));
    expand(problem.fine_frames, problem.n_fine).Tmmult(T, PR);
    return T;
  }



  template <typename Number>
  void
  expect_near(const std::vector<double> &expected,
              const NodeValues<Number>  &values)
  {
    ASSERT_EQ(expected.size(), values.size());
    const double tolerance = std::is_same_v<Number, double> ? 1e-14 : 2e-6;
    for (unsigned int i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(expected[i], values.local_element(i), tolerance) << i;
  }



  /** Prolongation and restriction beside products of dense matrices. */
  template <int n, typename Number>
  void
  compare_with_dense_transfer(RandomProblem<n> &problem)
  {
    const FullMatrix<double> T       = expand_transfer(problem);
    const GalerkinProduct<n> product = problem.product();
    const TransferMatrix    &P       = product.prolongation();
    NodeValues<Number>       fine =
      serial_nodes(problem.n_fine, n).template make_vector<Number>();
    NodeValues<Number> coarse =
      serial_nodes(problem.n_coarse, n).template make_vector<Number>();
    for (Number &value : fine)
      value = problem.number(problem.generator);
    for (Number &value : coarse)
      value = problem.number(problem.generator);
    std::vector<double> image(T.m()), sum(T.m()), dual(T.n());
    for (unsigned int i = 0; i < T.m(); ++i)
      {
        for (unsigned int j = 0; j < T.n(); ++j)
          {
            image[i] += T(i, j) * coarse.local_element(j);
            dual[j] += T(i, j) * fine.local_element(i);
          }
        sum[i] = fine.local_element(i) + image[i];
      }
    NodeValues<Number> result = fine, restricted = coarse;
    P.prolongate(result, coarse, n);
    expect_near(image, result);
    result = fine;
    P.prolongate_add(result, coarse, n);
    expect_near(sum, result);
    P.restrict_to(restricted, fine, n);
    expect_near(dual, restricted);
  }



  /** A with rows and columns of masked components set to zero, between
   * transfers. */
  template <int n>
  FullMatrix<double>
  dense_product(const RandomProblem<n> &problem)
  {
    const FullMatrix<double> T = expand_transfer(problem);
    const FullMatrix<double> A = Tests::expand<n>(problem.A, &problem.mask);
    FullMatrix<double>       AT(T.m(), T.n()), result(T.n(), T.n());
    A.mmult(AT, T);
    T.Tmmult(result, AT);
    return result;
  }



  template <int n, typename FineNumber, typename CoarseNumber>
  void
  compare_with_dense_product(const RandomProblem<n> &problem,
                             const double            tolerance)
  {
    const FullMatrix<double>   expected = dense_product(problem);
    GalerkinProduct<n>         product  = problem.product();
    BlockMatrix<n, FineNumber> A(problem.A.shared_sparsity());
    std::copy(problem.A.values().begin(),
              problem.A.values().end(),
              A.values().begin());
    BlockMatrix<n, CoarseNumber> all(product.coarse_sparsity()), some = all,
                                                                 selected = all;
    product.compute(A, problem.mask, all);
    const BlockSparsity            &sparsity = *product.coarse_sparsity();
    const std::vector<unsigned int> rows     = {0, 4, 9, 11};
    product.compute_rows(A, problem.mask, rows, some);
    std::vector<bool> is_selected(problem.n_coarse, false);
    for (const unsigned int row : rows)
      is_selected[row] = true;
    product.select_rows(is_selected);
    product.compute_selected_rows(A, problem.mask, selected);
    double largest = 0;
    for (unsigned int I = 0; I < sparsity.n_rows(); ++I)
      for (unsigned int k = sparsity.row_start[I];
           k < sparsity.row_start[I + 1];
           ++k)
        for (unsigned int c = 0; c < n; ++c)
          for (unsigned int d = 0; d < n; ++d)
            {
              const unsigned int entry = c * n + d;
              const double       value =
                expected(I * n + c, sparsity.column[k] * n + d);
              EXPECT_NEAR(all.block(k)[entry], value, tolerance);
              EXPECT_EQ(some.block(k)[entry],
                        is_selected[I] ? all.block(k)[entry] : 0.);
              EXPECT_EQ(selected.block(k)[entry], some.block(k)[entry]);
              largest = std::max(largest, std::abs(value));
            }
    EXPECT_GT(largest, 0.1);
  }



  /** Transfers between nodes with axes of their own. */
  template <typename Size>
  class TurnedBlocks : public SomeBlocks<Size>
  {};

  TYPED_TEST_SUITE(TurnedBlocks, BlockSizes);
} // namespace



TEST(NodeFrames, AreThoseOfSpaceUntilTheyAreSet)
{
  NodeFrames<2> frames;
  EXPECT_TRUE(frames.empty());
  EXPECT_EQ(frames.find(4), nullptr);
  EXPECT_TRUE(frames.local_part(serial_nodes(10, 2)).empty());

  frames.set(7, turned_by(0.3));
  frames.set(4, turned_by(-1.2));
  EXPECT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames.find(5), nullptr);
  ASSERT_NE(frames.find(4), nullptr);
  EXPECT_EQ(*frames.find(4), turned_by(-1.2));
  std::vector<types::global_dof_index> nodes;
  for (const auto &[node, axes] : frames)
    {
      nodes.push_back(node);
      EXPECT_EQ(axes, *frames.find(node));
    }
  EXPECT_EQ(nodes, (std::vector<types::global_dof_index>{4, 7}));

  // Axes of space are not stored.
  frames.set(7, turned_by(0.));
  EXPECT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames.find(7), nullptr);
}



TEST(NodeFrames, MustBeOrthonormal)
{
  NodeFrames<2> frames;
  EXPECT_THROW(frames.set(0, 1.001 * turned_by(0.1)), ExceptionBase);
  EXPECT_THROW(frames.set(0, Tensor<2, 2>({{1., 1e-6}, {0., 1.}})),
               ExceptionBase);
  EXPECT_TRUE(frames.empty());

  // Mirrored axes are axes, too.
  frames.set(0, Tensor<2, 2>({{1., 0.}, {0., -1.}}));
  NodeFrames<1> signs;
  signs.set(3, Tensor<2, 1>({{-1.}}));
  EXPECT_EQ(signs.size(), 1u);
  EXPECT_THROW(signs.set(3, Tensor<2, 1>({{2.}})), ExceptionBase);
}



TEST(NodeFrames, LocalPartHoldsOwnedNodesAndGhosts)
{
  NodeFrames<3> frames;
  Tensor<2, 3>  axes;
  // Columns: the axes y, z and x.
  axes[1][0] = axes[2][1] = axes[0][2] = 1.;
  frames.set(2, axes);
  frames.set(5, -axes);
  const LocalFrames local = frames.local_part(serial_nodes(6, 3));
  EXPECT_FALSE(local.empty());
  EXPECT_EQ(local.n_components(), 3u);
  EXPECT_EQ(local.nodes(), (std::vector<unsigned int>{2, 5}));
  EXPECT_EQ(local.find(0), nullptr);
  ASSERT_NE(local.find(2), nullptr);
  ASSERT_NE(local.find(5), nullptr);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_EQ(local.find(2)[c * 3 + d], axes[c][d]);
        EXPECT_EQ(local.find(5)[c * 3 + d], -axes[c][d]);
      }
  // Others than those of these nodes do not count.
  EXPECT_TRUE(frames.local_part(serial_nodes(2, 3)).empty());
}



TYPED_TEST(TurnedBlocks, TransfersEqualDenseMatrices)
{
  constexpr int n = TestFixture::n_components;
  for (const Turned turned : all_cases)
    {
      SCOPED_TRACE(int(turned));
      RandomProblem<n> problem = turned_problem<n>(turned);
      compare_with_dense_transfer<n, double>(problem);
      compare_with_dense_transfer<n, float>(problem);
    }
}



/* Long rows of nodes that stay as they are, short ones and single ones, with
 * nodes among them that have axes of their own, or none. */
TYPED_TEST(TurnedBlocks, TransfersThatCopyNodesEqualDenseMatrices)
{
  constexpr int n = TestFixture::n_components;
  for (const bool are_turned : {false, true})
    {
      RandomProblem<n> problem;
      problem.n_coarse = 50;
      for (unsigned int i = 0; i < problem.n_fine; ++i)
        if (i < 12)
          problem.rows[i] = {{i + 9, 1.}};
        else if (i < 20 && i != 14)
          problem.rows[i] = {{i + 24, 1.}};
        else if (i >= 22 && i < 38)
          problem.rows[i] = {{i - 15, 1.}};
      problem.P = serial_matrix(problem.rows, problem.n_coarse, n);
      if (are_turned)
        {
          problem.fine_frames.set(32, random_axes<n>(problem.generator));
          for (const unsigned int node : {18, 45})
            problem.coarse_frames.set(node, random_axes<n>(problem.generator));
        }
      compare_with_dense_transfer<n, double>(problem);
      compare_with_dense_transfer<n, float>(problem);
    }
}



TYPED_TEST(TurnedBlocks, ProductsEqualDenseOnes)
{
  constexpr int n = TestFixture::n_components;
  for (const Turned turned : all_cases)
    {
      SCOPED_TRACE(int(turned));
      const RandomProblem<n> problem = turned_problem<n>(turned);
      compare_with_dense_product<n, double, double>(problem, 1e-13);
      compare_with_dense_product<n, double, float>(problem, 1e-5);
      compare_with_dense_product<n, float, float>(problem, 1e-5);
    }
}



TYPED_TEST(TurnedBlocks, AxesOfSpaceChangeNoBit)
{
  constexpr int      n = TestFixture::n_components;
  RandomProblem<n>   problem;
  GalerkinProduct<n> without = problem.product();
  Tensor<2, n>       axes;
  for (unsigned int c = 0; c < n; ++c)
    axes[c][c] = 1.;
  problem.fine_frames.set(5, axes);
  problem.coarse_frames.set(2, axes);
  GalerkinProduct<n> with = problem.product();
  EXPECT_TRUE(with.coarse_frames().empty());
  EXPECT_EQ(with.memory_consumption(), without.memory_consumption());
  BlockMatrix<n> ours(with.coarse_sparsity()),
    theirs(without.coarse_sparsity());
  with.compute(problem.A, problem.mask, ours);
  without.compute(problem.A, problem.mask, theirs);
  EXPECT_TRUE(std::equal(ours.values().begin(),
                         ours.values().end(),
                         theirs.values().begin()));
}
