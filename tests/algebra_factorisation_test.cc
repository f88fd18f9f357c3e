// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/algebra/mumps_factorisation.h>
#include <stickslip/algebra/umfpack_factorisation.h>
#include <stickslip/multigrid/direct_coarse_solver.h>

#include <random>

#include "random_products.h"
#include "serial_matrices.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <typename Size>
  class Factorisation : public SomeBlocks<Size>
  {};

  TYPED_TEST_SUITE(Factorisation, BlockSizes);



  /** Springs in random directions between neighbours of a cube of nodes, each
   * of which is also held in its place. */
  template <int n_components>
  struct Springs
  {
    BlockMatrix<n_components> matrix;
    NodeMask                  mask;
    NodePartition             nodes;
    NodalVector               solution, rhs;

    explicit Springs(const unsigned int n)
      : mask(n * n * n, n_components)
      , nodes(serial_nodes(n * n * n, n_components))
      , solution(nodes.make_vector())
      , rhs(solution)
    {
      std::mt19937                           generator(n);
      std::uniform_real_distribution<double> number(-1., 1.);
      std::vector<std::vector<unsigned int>> rows(n * n * n);
      const auto at = [n](const int x, const int y, const int z) {
        return x + n * (y + n * z);
      };
      for (unsigned int z = 0; z < n; ++z)
        for (unsigned int y = 0; y < n; ++y)
          for (unsigned int x = 0; x < n; ++x)
            for (unsigned int k = 0; k < 27; ++k)
              {
                const unsigned int X = x + k % 3 - 1, Y = y + k / 3 % 3 - 1,
                                   Z = z + k / 9 - 1;
                if (X < n && Y < n && Z < n)
                  rows[at(x, y, z)].push_back(at(X, Y, Z));
              }
      const auto sparsity =
        std::make_shared<const BlockSparsity>(std::move(rows));
      matrix = BlockMatrix<n_components>(sparsity);
      for (unsigned int i = 0; i < sparsity->n_rows(); ++i)
        {
          add(i, i, unit_symmetric_tensor<n_components>());
          for (unsigned int p = sparsity->row_start[i];
               p < sparsity->row_start[i + 1];
               ++p)
            if (const unsigned int j = sparsity->column[p]; j > i)
              {
                Tensor<1, n_components> direction;
                for (unsigned int c = 0; c < n_components; ++c)
                  direction[c] = number(generator);
                const Tensor<2, n_components> spring =
                  outer_product(direction, direction);
                add(i, i, spring);
                add(j, j, spring);
                add(i, j, -1. * spring);
                add(j, i, -1. * spring);
              }
          if (i % 7 == 3)
            mask.mask(i, i % n_components);
          for (unsigned int c = 0; c < n_components; ++c)
            solution.local_element(i * n_components + c) = number(generator);
        }
      mask.apply(solution);
      matrix.vmult(rhs, solution);
      mask.apply(rhs);
    }

    void
    add(const unsigned int             i,
        const unsigned int             j,
        const Tensor<2, n_components> &spring)
    {
      double *block = matrix.block(matrix.sparsity().position(i, j));
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          block[c * n_components + d] += spring[c][d];
    }

    /** Expect that a solver finds the solution. */
    template <typename Solver>
    void
    expect_solved_by(Solver &solver) const
    {
      NodalVector x = nodes.make_vector();
      solver.set_matrix(matrix, mask);
      for (unsigned int k = 0; k < 2; ++k)
        {
          solver.solve(x, rhs);
          x -= solution;
          EXPECT_LT(x.linfty_norm(), 1e-9 * solution.linfty_norm())
            << matrix.n_rows() << " nodes";
        }
    }
  };
} // namespace



TYPED_TEST(Factorisation, SolvesMatricesOfAllSizesOneAfterTheOther)
{
  constexpr int                      n_components = TestFixture::n_components;
  MumpsFactorisation<n_components>   mumps;
  UmfpackFactorisation<n_components> umfpack;
  // Smaller ones after larger ones, too, which leave more space than needed.
  for (const unsigned int n : {2, 6, 3, 9, 4})
    {
      const Springs<n_components> springs(n);
      springs.expect_solved_by(mumps);
      springs.expect_solved_by(umfpack);
    }
}



TYPED_TEST(Factorisation, TakesOtherValuesWithOneSparsity)
{
  constexpr int                    n_components = TestFixture::n_components;
  MumpsFactorisation<n_components> mumps;
  Springs<n_components>            springs(5);
  springs.expect_solved_by(mumps);
  for (const double factor : {1e-6, 3., 1e9})
    {
      for (double &value : springs.matrix.values())
        value *= factor;
      springs.rhs *= factor;
      springs.expect_solved_by(mumps);
    }
}



TYPED_TEST(Factorisation, GoesOnAfterASingularMatrix)
{
  constexpr int                    n_components = TestFixture::n_components;
  MumpsFactorisation<n_components> mumps;
  const Springs<n_components>      springs(4);
  springs.expect_solved_by(mumps);
  BlockMatrix<n_components> zero = springs.matrix;
  for (double &value : zero.values())
    value = 0.;
  EXPECT_THROW(mumps.set_matrix(zero, springs.mask), SingularMatrix);
  springs.expect_solved_by(mumps);
}



TYPED_TEST(Factorisation, CoarsestLevelsOfFewAndOfManyUnknowns)
{
  constexpr int n_components = TestFixture::n_components;
  // KLU for the first one, MUMPS for the second one.
  constexpr unsigned int many[] = {18, 14, 8};
  for (const unsigned int n : {3u, many[n_components - 1]})
    {
      const Springs<n_components>      springs(n);
      DirectCoarseSolver<n_components> solver;
      springs.expect_solved_by(solver);
      springs.expect_solved_by(solver);
    }
}
