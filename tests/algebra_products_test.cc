// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>
#include <stickslip/algebra/galerkin_product.h>

#include <random>

#include "serial_matrices.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr int dim = 2;

  struct RandomProblem
  {
    std::mt19937                           generator{7};
    std::uniform_real_distribution<double> number{-1., 1.};
    unsigned int                           n_fine = 40, n_coarse = 15;
    std::vector<GlobalRow>                 rows;
    TransferMatrix                         P;
    BlockMatrix<dim>                       A;
    NodeMask                               mask;

    RandomProblem()
    {
      rows.resize(n_fine);
      for (auto &row : rows)
        for (unsigned int k = 0; k < 3; ++k)
          row.emplace_back(generator() % n_coarse, number(generator));
      P = serial_matrix(rows, n_coarse, dim);

      std::vector<std::vector<unsigned int>> couplings(n_fine);
      for (auto &row : couplings)
        for (unsigned int k = 0; k < 6; ++k)
          row.push_back(generator() % n_fine);
      A = BlockMatrix<dim>(
        std::make_shared<const BlockSparsity>(std::move(couplings)));
      for (double &value : A.values())
        value = number(generator);

      mask = NodeMask(n_fine, dim);
      mask.mask(3, 1);
      mask.mask_node(7);
      mask.mask(20, 0);
    }

    GalerkinProduct<dim>
    product() const
    {
      return GalerkinProduct<dim>(serial_nodes(n_fine, dim),
                                  A.sparsity(),
                                  rows,
                                  complete_index_set(n_coarse));
    }
  };



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



  FullMatrix<double>
  expand(const TransferMatrix &P)
  {
    FullMatrix<double> full(P.n_rows() * dim, P.n_columns() * dim);
    for (unsigned int i = 0; i < P.n_rows(); ++i)
      for (unsigned int k = P.matrix().row_start[i];
           k < P.matrix().row_start[i + 1];
           ++k)
        for (unsigned int c = 0; c < dim; ++c)
          full(i * dim + c, P.matrix().column[k] * dim + c) =
            P.matrix().value[k];
    return full;
  }



  FullMatrix<double>
  expand(const BlockMatrix<dim> &A, const NodeMask *mask = nullptr)
  {
    FullMatrix<double>   full(A.n_rows() * dim, A.n_rows() * dim);
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < A.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            if (!mask || (mask->is_active(i, c) &&
                          mask->is_active(sparsity.column[k], d)))
              full(i * dim + c, sparsity.column[k] * dim + d) =
                A.block(k)[c * dim + d];
    return full;
  }
} // namespace



TEST(GalerkinProduct, EqualsTheLibraryProduct)
{
  RandomProblem        problem;
  GalerkinProduct<dim> product = problem.product();
  BlockMatrix<dim>     coarse(product.coarse_sparsity());
  product.compute(problem.A, problem.mask, coarse);

  const LibraryMatrix A(expand(problem.A, &problem.mask));
  const LibraryMatrix P(expand(problem.P));
  // Patterns large enough for whatever the products fill in.
  const std::vector<double> entries(problem.n_fine * problem.n_coarse * dim *
                                      dim,
                                    1.);
  const FullMatrix<double>  ones(problem.n_fine * dim,
                                problem.n_coarse * dim,
                                entries.data());
  LibraryMatrix             AP(ones), PtAP(expand(coarse));
  A.matrix.mmult(AP.matrix, P.matrix);
  P.matrix.Tmmult(PtAP.matrix, AP.matrix);

  const FullMatrix<double> ours    = expand(coarse);
  double                   largest = 0;
  for (unsigned int i = 0; i < ours.m(); ++i)
    for (unsigned int j = 0; j < ours.n(); ++j)
      {
        EXPECT_NEAR(ours(i, j), PtAP.matrix.el(i, j), 1e-13);
        largest = std::max(largest, std::abs(ours(i, j)));
      }
  EXPECT_GT(largest, 0.1);
}



TEST(GalerkinProduct, SomeRowsEqualThoseOfTheWhole)
{
  RandomProblem        problem;
  GalerkinProduct<dim> product = problem.product();
  BlockMatrix<dim>     whole(product.coarse_sparsity());
  BlockMatrix<dim>     partial(product.coarse_sparsity());
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
        for (unsigned int c = 0; c < dim * dim; ++c)
          EXPECT_EQ(partial.block(k)[c], computed ? whole.block(k)[c] : 0.);
    }
}



TEST(TransferMatrix, ProlongationAndRestrictionAreAdjoint)
{
  RandomProblem problem;
  NodalVector   fine   = serial_nodes(problem.n_fine, dim).make_vector();
  NodalVector   coarse = serial_nodes(problem.n_coarse, dim).make_vector();
  NodalVector   image = fine, dual = coarse;
  for (double &value : fine)
    value = problem.number(problem.generator);
  for (double &value : coarse)
    value = problem.number(problem.generator);
  problem.P.prolongate(image, coarse, dim);
  problem.P.restrict_to(dual, fine, dim);
  EXPECT_NEAR(image * fine, dual * coarse, 1e-12);

  const FullMatrix<double> P = expand(problem.P);
  for (unsigned int i = 0; i < P.m(); ++i)
    {
      double sum = 0;
      for (unsigned int j = 0; j < P.n(); ++j)
        sum += P(i, j) * coarse.local_element(j);
      EXPECT_NEAR(sum, image.local_element(i), 1e-14);
    }
}



TEST(BlockMatrix, VmultAndGaussSeidelEqualDenseAlgebra)
{
  RandomProblem            problem;
  const FullMatrix<double> A = expand(problem.A);
  const unsigned int       n = A.m();
  std::vector<double>      x(n), b(n), y(n), r(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      x[i] = problem.number(problem.generator);
      b[i] = problem.number(problem.generator);
    }
  Kernels::vmult<dim>(problem.A.rows(), 0, n / dim, x.data(), y.data());
  Kernels::residual<dim>(
    problem.A.rows(), 0, n / dim, b.data(), x.data(), r.data());
  for (unsigned int i = 0; i < n; ++i)
    {
      double sum = 0;
      for (unsigned int j = 0; j < n; ++j)
        sum += A(i, j) * x[j];
      EXPECT_NEAR(sum, y[i], 1e-14);
      EXPECT_NEAR(b[i] - sum, r[i], 1e-14);
    }

  std::vector<double> inverse(n * dim);
  for (double &value : inverse)
    value = problem.number(problem.generator);
  std::vector<double> ours = x, dense = x;
  Kernels::gauss_seidel_forward<dim>(
    problem.A.rows(), inverse.data(), 0, n / dim, b.data(), ours.data());
  for (unsigned int i = 0; i < n / dim; ++i)
    {
      double s[dim];
      for (unsigned int c = 0; c < dim; ++c)
        {
          s[c] = b[i * dim + c];
          for (unsigned int j = 0; j < n; ++j)
            s[c] -= A(i * dim + c, j) * dense[j];
        }
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          dense[i * dim + c] += inverse[(i * dim + c) * dim + d] * s[d];
    }
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(ours[i], dense[i], 1e-9 * (1 + std::abs(dense[i])));
}



TEST(BlockMatrix, LinearCombination)
{
  RandomProblem    problem;
  BlockMatrix<dim> B = problem.A, C = problem.A,
                   sum(problem.A.shared_sparsity());
  for (double &value : B.values())
    value = problem.number(problem.generator);
  for (double &value : C.values())
    value = problem.number(problem.generator);
  sum.combine({2., -3., 0.5}, {problem.A, B, C}, 0, sum.n_rows());
  for (unsigned int i = 0; i < sum.values().size(); ++i)
    EXPECT_NEAR(sum.values()[i],
                2. * problem.A.values()[i] - 3. * B.values()[i] +
                  0.5 * C.values()[i],
                1e-14);

  // Some of the rows.
  const BlockMatrix<dim> before = sum;
  const unsigned int     begin = 2, end = sum.n_rows() - 1;
  sum.combine({4.}, {B}, begin, end);
  for (unsigned int i = 0; i < sum.n_rows(); ++i)
    for (unsigned int k = sum.sparsity().row_start[i];
         k < sum.sparsity().row_start[i + 1];
         ++k)
      for (unsigned int c = 0; c < dim * dim; ++c)
        EXPECT_NEAR(sum.block(k)[c],
                    i >= begin && i < end ? 4. * B.block(k)[c] :
                                            before.block(k)[c],
                    1e-14);
}
