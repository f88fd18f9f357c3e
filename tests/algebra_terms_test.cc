// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "random_products.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Blocks of a mass matrix in all rows but 3, 4 and 20. */
  template <int n_components>
  BlockMatrix<n_components>
  with_multiples_of_identity(RandomProblem<n_components> &problem)
  {
    BlockMatrix<n_components> result   = problem.A;
    const BlockSparsity      &sparsity = result.sparsity();
    for (unsigned int i = 0; i < result.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1] && i != 3 && i != 4 && i != 20;
           ++k)
        {
          const double value = problem.number(problem.generator);
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              result.block(k)[c * n_components + d] = (c == d ? value : 0.);
        }
    return result;
  }



  template <int n_components>
  void
  expect_equal(const BlockMatrix<n_components> &ours,
               const BlockMatrix<n_components> &expected)
  {
    ASSERT_EQ(ours.values().size(), expected.values().size());
    for (unsigned int k = 0; k < ours.values().size(); ++k)
      EXPECT_NEAR(ours.values()[k], expected.values()[k], 1e-14);
  }



  template <typename Size>
  class Terms : public SomeBlocks<Size>
  {};

  TYPED_TEST_SUITE(Terms, BlockSizes);
} // namespace



TYPED_TEST(Terms, AreTheMatricesThatTheyAreMadeOf)
{
  constexpr int                   n_components = TestFixture::n_components;
  constexpr unsigned int          n            = n_components * n_components;
  RandomProblem<n_components>     problem;
  const BlockMatrix<n_components> mass = with_multiples_of_identity(problem);
  const TermMatrix<n_components>  compact =
                                   TermMatrix<n_components>::compact(mass),
                                 full(problem.A);
  const BlockSparsity &sparsity = mass.sparsity();
  ASSERT_EQ(compact.is_compact(), n_components > 1);
  EXPECT_FALSE(full.is_compact());

  std::vector<double> buffer;
  for (unsigned int i = 0; i < mass.n_rows(); ++i)
    for (const auto &[term, matrix] :
         {std::pair<const TermMatrix<n_components> &,
                    const BlockMatrix<n_components> &>(compact, mass),
          {full, problem.A}})
      {
        const unsigned int begin = sparsity.row_start[i];
        const double      *row   = term.row(i, buffer);
        for (unsigned int k = begin; k < sparsity.row_start[i + 1]; ++k)
          {
            EXPECT_EQ(term.entry(i, k), matrix.entry(i, k));
            for (unsigned int c = 0; c < n; ++c)
              EXPECT_EQ(row[(k - begin) * n + c], matrix.block(k)[c]);
          }
        EXPECT_EQ(term.diagonal_block(i), matrix.diagonal_block(i));
      }

  NodalVector x =
    serial_nodes(problem.n_fine, n_components).template make_vector<double>();
  NodalVector b = x, ours = x, expected = x;
  for (unsigned int i = 0; i < x.size(); ++i)
    {
      x.local_element(i) = problem.number(problem.generator);
      b.local_element(i) = problem.number(problem.generator);
    }
  const auto expect_equal_vectors = [&]() {
    for (unsigned int i = 0; i < x.size(); ++i)
      EXPECT_NEAR(ours.local_element(i), expected.local_element(i), 1e-13);
  };
  compact.vmult(ours, x);
  mass.vmult(expected, x);
  expect_equal_vectors();
  compact.residual(ours, b, x);
  mass.residual(expected, b, x);
  expect_equal_vectors();

  if (n_components > 1)
    {
      EXPECT_LT(compact.memory_consumption(), 0.6 * full.memory_consumption());
      expect_equal(compact.block_matrix(), mass);
    }
}



TYPED_TEST(Terms, AreTheSameWithOneTriangle)
{
  constexpr int      n_components = TestFixture::n_components;
  const unsigned int n            = 30;
  std::mt19937       generator(1);
  std::vector<std::vector<unsigned int>> couplings(n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < 5; ++k)
      {
        const unsigned int j = generator() % n;
        couplings[i].push_back(j);
        couplings[j].push_back(i);
      }
  BlockMatrix<n_components> A(
    std::make_shared<const BlockSparsity>(std::move(couplings)));
  std::uniform_real_distribution<double> number(-1., 1.);
  const BlockSparsity                   &sparsity = A.sparsity();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = sparsity.diagonal[i]; k < sparsity.row_start[i + 1];
         ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          {
            const unsigned int opposite =
              sparsity.position(sparsity.column[k], i);
            if (opposite != k || d >= c)
              A.block(k)[c * n_components + d] =
                A.block(opposite)[d * n_components + c] = number(generator);
          }

  const auto term = TermMatrix<n_components>::symmetric(A);
  ASSERT_TRUE(term.is_symmetric());
  EXPECT_LT(term.memory_consumption(),
            (n_components == 1 ? 0.95 : 0.7) * A.memory_consumption());
  expect_equal(term.block_matrix(), A);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = sparsity.row_start[i]; k < sparsity.row_start[i + 1];
         ++k)
      EXPECT_EQ(term.entry(i, k), A.entry(i, k));

  NodalVector x = serial_nodes(n, n_components).template make_vector<double>();
  NodalVector b = x, ours = x, expected = x;
  for (unsigned int i = 0; i < x.size(); ++i)
    {
      x.local_element(i) = number(generator);
      b.local_element(i) = number(generator);
    }
  term.vmult(ours, x);
  A.vmult(expected, x);
  EXPECT_NEAR(term.quadratic_form(x), x * expected, 1e-12);
  ours -= expected;
  EXPECT_LT(ours.linfty_norm(), 1e-13);
  term.residual(ours, b, x);
  A.residual(expected, b, x);
  ours -= expected;
  EXPECT_LT(ours.linfty_norm(), 1e-13);

  BlockMatrix<n_components> sum(A.shared_sparsity()), expected_sum = sum;
  expected_sum.combine({{2., &A}, {3., &A}}, 0, n);
  for (const auto &[begin, end] :
       {std::make_pair(0u, 4u), std::make_pair(4u, n)})
    TermMatrix<n_components>::combine({2., 3.}, {term, A}, begin, end, sum);
  expect_equal(sum, expected_sum);
}



TYPED_TEST(Terms, AreCombinedAndMultipliedAsThese)
{
  constexpr int                   n_components = TestFixture::n_components;
  RandomProblem<n_components>     problem;
  const BlockMatrix<n_components> mass = with_multiples_of_identity(problem);

  BlockMatrix<n_components> ours(mass.shared_sparsity()), expected = ours;
  ours.values().fill(7.);
  expected.combine({{2., &problem.A}, {3., &mass}, {-0.5, &problem.A}},
                   0,
                   mass.n_rows());
  // Parts whose ends are rows with blocks and beside them.
  for (const auto &[begin, end] : {std::make_pair(0u, 4u),
                                   std::make_pair(4u, 20u),
                                   std::make_pair(20u, mass.n_rows())})
    TermMatrix<n_components>::combine({2., 3., -0.5},
                                      {problem.A,
                                       TermMatrix<n_components>::compact(mass),
                                       problem.A},
                                      begin,
                                      end,
                                      ours);
  expect_equal(ours, expected);

  GalerkinProduct<n_components> product = problem.product();
  BlockMatrix<n_components>     coarse(product.coarse_sparsity()),
    expected_coarse = coarse;
  product.compute(TermMatrix<n_components>::compact(mass),
                  problem.mask,
                  coarse);
  product.compute(mass, problem.mask, expected_coarse);
  expect_equal(coarse, expected_coarse);
}
