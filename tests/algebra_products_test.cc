// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include "random_products.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A block or scalar matrix as a matrix of the library. */
  struct LibraryMatrix
  {
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;

    explicit LibraryMatrix(const FullMatrix<double> &full)
    {
      DynamicSparsityPattern dsp(full.m(), full.n());
      for (unsigned int i = 0; i < full.m(); ++i)
        for (unsigned int j = 0; j < full.n(); ++j)
          if (full(i, j) != 0.)
            dsp.add(i, j);
      pattern.copy_from(dsp);
      matrix.reinit(pattern);
      for (unsigned int i = 0; i < full.m(); ++i)
        for (unsigned int j = 0; j < full.n(); ++j)
          if (full(i, j) != 0.)
            matrix.set(i, j, full(i, j));
    }
  };



  /** Products and matrices with blocks of one to three components. */
  template <typename Size>
  class BlockAlgebra : public SomeBlocks<Size>
  {};

  TYPED_TEST_SUITE(BlockAlgebra, BlockSizes);
} // namespace



TYPED_TEST(BlockAlgebra, ProductEqualsThatOfTheLibrary)
{
  constexpr int                 n_components = TestFixture::n_components;
  RandomProblem<n_components>   problem;
  GalerkinProduct<n_components> product = problem.product();
  BlockMatrix<n_components>     coarse(product.coarse_sparsity());
  product.compute(problem.A, problem.mask, coarse);

  const LibraryMatrix A(expand<n_components>(problem.A, &problem.mask));
  const LibraryMatrix P(expand<n_components>(problem.P));
  // Patterns large enough for whatever the products fill in.
  const std::vector<double> entries(problem.n_fine * problem.n_coarse *
                                      n_components * n_components,
                                    1.);
  const FullMatrix<double>  ones(problem.n_fine * n_components,
                                problem.n_coarse * n_components,
                                entries.data());
  LibraryMatrix             AP(ones), PtAP(expand<n_components>(coarse));
  A.matrix.mmult(AP.matrix, P.matrix);
  P.matrix.Tmmult(PtAP.matrix, AP.matrix);

  const FullMatrix<double> ours    = expand<n_components>(coarse);
  double                   largest = 0;
  for (unsigned int i = 0; i < ours.m(); ++i)
    for (unsigned int j = 0; j < ours.n(); ++j)
      {
        EXPECT_NEAR(ours(i, j), PtAP.matrix.el(i, j), 1e-13);
        largest = std::max(largest, std::abs(ours(i, j)));
      }
  EXPECT_GT(largest, 0.1);
}



TYPED_TEST(BlockAlgebra, SomeRowsOfProductEqualThoseOfTheWhole)
{
  constexpr int                 n_components = TestFixture::n_components;
  RandomProblem<n_components>   problem;
  GalerkinProduct<n_components> product = problem.product();
  BlockMatrix<n_components>     whole(product.coarse_sparsity());
  BlockMatrix<n_components>     partial(product.coarse_sparsity());
  product.compute(problem.A, problem.mask, whole);
  const std::vector<unsigned int> rows = {0, 4, 11};
  std::vector<bool>               is_selected(problem.n_coarse, false);
  for (const unsigned int row : rows)
    is_selected[row] = true;
  product.select_rows(is_selected);
  product.compute_selected_rows(problem.A, problem.mask, partial);
  const BlockSparsity &sparsity = *product.coarse_sparsity();
  for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
    {
      const bool computed =
        std::find(rows.begin(), rows.end(), i) != rows.end();
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        for (unsigned int c = 0; c < n_components * n_components; ++c)
          EXPECT_EQ(partial.block(k)[c], computed ? whole.block(k)[c] : 0.);
    }
}



TYPED_TEST(BlockAlgebra, ProlongationAndRestrictionAreAdjoint)
{
  constexpr int               n_components = TestFixture::n_components;
  RandomProblem<n_components> problem;
  NodalVector fine = serial_nodes(problem.n_fine, n_components).make_vector();
  NodalVector coarse =
    serial_nodes(problem.n_coarse, n_components).make_vector();
  NodalVector image = fine, dual = coarse;
  for (double &value : fine)
    value = problem.number(problem.generator);
  for (double &value : coarse)
    value = problem.number(problem.generator);
  problem.P.prolongate(image, coarse, n_components);
  problem.P.restrict_to(dual, fine, n_components);
  EXPECT_NEAR(image * fine, dual * coarse, 1e-12);

  const FullMatrix<double> P = expand<n_components>(problem.P);
  for (unsigned int i = 0; i < P.m(); ++i)
    {
      double sum = 0;
      for (unsigned int j = 0; j < P.n(); ++j)
        sum += P(i, j) * coarse.local_element(j);
      EXPECT_NEAR(sum, image.local_element(i), 1e-14);
    }
}



TYPED_TEST(BlockAlgebra, ProductsEqualDenseAlgebra)
{
  constexpr int               n_components = TestFixture::n_components;
  RandomProblem<n_components> problem;
  const FullMatrix<double>    A = expand<n_components>(problem.A);
  const unsigned int          n = A.m();
  std::vector<double>         x(n), b(n), y(n), r(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      x[i] = problem.number(problem.generator);
      b[i] = problem.number(problem.generator);
    }
  Kernels::vmult<n_components>(
    problem.A.rows(), 0, n / n_components, x.data(), y.data());
  Kernels::residual<n_components>(
    problem.A.rows(), 0, n / n_components, b.data(), x.data(), r.data());
  for (unsigned int i = 0; i < n; ++i)
    {
      double sum = 0;
      for (unsigned int j = 0; j < n; ++j)
        sum += A(i, j) * x[j];
      EXPECT_NEAR(sum, y[i], 1e-14);
      EXPECT_NEAR(b[i] - sum, r[i], 1e-14);
    }

  // Rows are columns of a symmetric matrix.
  for (unsigned int node = 0; node < n / n_components; ++node)
    {
      NodeValues<double> rest(n);
      std::copy(r.begin(), r.end(), rest.begin());
      Tensor<1, n_components> values;
      for (unsigned int c = 0; c < n_components; ++c)
        values[c] = x[node * n_components + c];
      problem.A.subtract_column(node, values, rest);
      for (unsigned int i = 0; i < n; ++i)
        {
          double expected = r[i];
          for (unsigned int c = 0; c < n_components; ++c)
            expected -= A(node * n_components + c, i) * values[c];
          EXPECT_NEAR(rest.local_element(i), expected, 1e-14);
        }
    }
}



TYPED_TEST(BlockAlgebra, LinearCombination)
{
  constexpr int               n_components = TestFixture::n_components;
  RandomProblem<n_components> problem;
  BlockMatrix<n_components>   B = problem.A, C = problem.A,
                            sum(problem.A.shared_sparsity());
  for (double &value : B.values())
    value = problem.number(problem.generator);
  for (double &value : C.values())
    value = problem.number(problem.generator);
  sum.combine({{2., &problem.A}, {-3., &B}, {0.5, &C}}, 0, sum.n_rows());
  for (unsigned int i = 0; i < sum.values().size(); ++i)
    EXPECT_NEAR(sum.values()[i],
                2. * problem.A.values()[i] - 3. * B.values()[i] +
                  0.5 * C.values()[i],
                1e-14);

  // Some of the rows.
  const BlockMatrix<n_components> before = sum;
  const unsigned int              begin = 2, end = sum.n_rows() - 1;
  sum.combine({{4., &B}}, begin, end);
  for (unsigned int i = 0; i < sum.n_rows(); ++i)
    for (unsigned int k = sum.sparsity().row_start[i];
         k < sum.sparsity().row_start[i + 1];
         ++k)
      for (unsigned int c = 0; c < n_components * n_components; ++c)
        EXPECT_NEAR(sum.block(k)[c],
                    i >= begin && i < end ? 4. * B.block(k)[c] :
                                            before.block(k)[c],
                    1e-14);
}
