// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_random_products_h
#define stickslip_tests_random_products_h

#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>
#include <stickslip/algebra/galerkin_product.h>

#include <random>

#include "serial_matrices.h"

namespace StickSlip::Tests
{
  /** Nodes with random couplings, and a random transfer to them from fewer
   * ones. */
  template <int n_components>
  struct RandomProblem
  {
    std::mt19937                           generator{7};
    std::uniform_real_distribution<double> number{-1., 1.};
    unsigned int                           n_fine = 40, n_coarse = 15;
    std::vector<GlobalRow>                 rows;
    TransferMatrix                         P;
    BlockMatrix<n_components>              A;
    NodeMask                               mask;
    /** Axes of space unless they are set. */
    NodeFrames<n_components> fine_frames, coarse_frames;

    RandomProblem()
    {
      rows.resize(n_fine);
      for (auto &row : rows)
        for (unsigned int k = 0; k < 3; ++k)
          row.emplace_back(generator() % n_coarse, number(generator));
      P = serial_matrix(rows, n_coarse, n_components);

      std::vector<std::vector<unsigned int>> couplings(n_fine);
      for (auto &row : couplings)
        for (unsigned int k = 0; k < 6; ++k)
          row.push_back(generator() % n_fine);
      A = BlockMatrix<n_components>(
        std::make_shared<const BlockSparsity>(std::move(couplings)));
      for (double &value : A.values())
        value = number(generator);

      mask = NodeMask(n_fine, n_components);
      mask.mask(3, n_components - 1);
      mask.mask_node(7);
      mask.mask(20, 0);
    }

    GalerkinProduct<n_components>
    product() const
    {
      return GalerkinProduct<n_components>(
        serial_nodes(n_fine, n_components),
        A.sparsity(),
        rows,
        complete_index_set(n_coarse),
        fine_frames.local_part(serial_nodes(n_fine, n_components)),
        coarse_frames);
    }
  };



  template <int n_components>
  FullMatrix<double>
  expand(const TransferMatrix &P)
  {
    FullMatrix<double> full(P.n_rows() * n_components,
                            P.n_columns() * n_components);
    for (unsigned int i = 0; i < P.n_rows(); ++i)
      for (unsigned int k = P.matrix().row_start[i];
           k < P.matrix().row_start[i + 1];
           ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          full(i * n_components + c, P.matrix().column[k] * n_components + c) =
            P.matrix().value[k];
    return full;
  }



  template <int n_components>
  FullMatrix<double>
  expand(const BlockMatrix<n_components> &A, const NodeMask *mask = nullptr)
  {
    FullMatrix<double>   full(A.n_rows() * n_components,
                            A.n_rows() * n_components);
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < A.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            if (!mask || (mask->is_active(i, c) &&
                          mask->is_active(sparsity.column[k], d)))
              full(i * n_components + c,
                   sparsity.column[k] * n_components + d) =
                A.block(k)[c * n_components + d];
    return full;
  }



  /** A test with blocks of one to three components. */
  template <typename Size>
  class SomeBlocks : public testing::Test
  {
  public:
    static constexpr int n_components = Size::value;
  };

  using BlockSizes = testing::Types<std::integral_constant<int, 1>,
                                    std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
} // namespace StickSlip::Tests

#endif
