// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/algebra/symmetric_kernels.h>

#include <random>

#include "random_products.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <typename Size>
  class QuadraticForm : public SomeBlocks<Size>
  {};

  TYPED_TEST_SUITE(QuadraticForm, BlockSizes);



  /** The rows of one process of a full symmetric matrix: its own nodes come
   * first, those of the other process are ghosts. */
  template <int n_components>
  double
  part_of_form(const FullMatrix<double>        &A,
               const Vector<double>            &x,
               const std::vector<unsigned int> &own,
               const std::vector<unsigned int> &ghosts)
  {
    std::vector<unsigned int> nodes = own;
    nodes.insert(nodes.end(), ghosts.begin(), ghosts.end());
    std::vector<unsigned int> row_start = {0}, column, diagonal;
    std::vector<double>       values, local_x;
    for (unsigned int i = 0; i < own.size(); ++i)
      {
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            if (i == j)
              diagonal.push_back(column.size());
            column.push_back(j);
            for (unsigned int c = 0; c < n_components && j >= i; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                values.push_back(
                  A(own[i] * n_components + c, nodes[j] * n_components + d));
          }
        row_start.push_back(column.size());
      }
    for (const unsigned int node : nodes)
      for (unsigned int c = 0; c < n_components; ++c)
        local_x.push_back(x[node * n_components + c]);
    return Kernels::quadratic_form<n_components>({static_cast<unsigned int>(
                                                    own.size()),
                                                  row_start.data(),
                                                  diagonal.data(),
                                                  column.data(),
                                                  values.data()},
                                                 local_x.data());
  }
} // namespace



TYPED_TEST(QuadraticForm, IsThatOfTheWholeMatrixOnOneProcessAndOnTwo)
{
  constexpr int      n_components = TestFixture::n_components;
  const unsigned int n            = 7 * n_components;
  std::mt19937       generator(1);
  std::uniform_real_distribution<double> number(-1., 1.);
  FullMatrix<double>                     A(n, n);
  Vector<double>                         x(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      x[i] = number(generator);
      for (unsigned int j = 0; j <= i; ++j)
        A(i, j) = A(j, i) = number(generator);
    }
  const double expected = A.matrix_norm_square(x);
  ASSERT_GT(std::abs(expected), 0.1);

  EXPECT_NEAR(part_of_form<n_components>(A, x, {0, 1, 2, 3, 4, 5, 6}, {}),
              expected,
              1e-13);
  EXPECT_NEAR(part_of_form<n_components>(A, x, {0, 1, 2}, {3, 4, 5, 6}) +
                part_of_form<n_components>(A, x, {3, 4, 5, 6}, {0, 1, 2}),
              expected,
              1e-13);
}
