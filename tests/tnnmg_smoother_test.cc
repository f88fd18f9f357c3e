// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

#include <limits>
#include <random>

using namespace StickSlip;

namespace
{
  /**
   * A symmetric, diagonally dominant block matrix with random couplings, some
   * masked components, and the same as a dense matrix.
   */
  template <int n_components>
  struct RandomSystem
  {
    static constexpr unsigned int n_nodes = 40;

    std::mt19937                           generator{n_components};
    std::uniform_real_distribution<double> number{-1., 1.};
    NodePartition                          nodes;
    BlockMatrix<n_components>              matrix;
    NodeMask                               active;
    FullMatrix<double>                     dense;

    RandomSystem()
      : nodes(complete_index_set(n_nodes),
              IndexSet(n_nodes),
              n_components,
              MPI_COMM_SELF)
      , active(n_nodes, n_components)
      , dense(n_nodes * n_components)
    {
      std::vector<std::vector<unsigned int>> rows(n_nodes);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = 0; j < i; ++j)
          if (i - j <= 2 || number(generator) > 0.8)
            {
              rows[i].push_back(j);
              rows[j].push_back(i);
            }
      const auto sparsity =
        std::make_shared<const BlockSparsity>(std::move(rows));
      matrix = BlockMatrix<n_components>(sparsity);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int k = sparsity->row_start[i];
             k < sparsity->row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              {
                const unsigned int j      = sparsity->column[k];
                const unsigned int row    = i * n_components + c,
                                   column = j * n_components + d;
                if (column < row)
                  dense(row, column) = dense(column, row);
                else
                  dense(row, column) =
                    number(generator) + (row == column ? 40. : 0.);
                matrix.block(k)[c * n_components + d] = dense(row, column);
              }
      for (unsigned int i = 0; i < n_nodes; i += 3)
        active.mask(i, i % n_components);
      active.mask_node(1);
    }

    Vector<double>
    random()
    {
      Vector<double> x(n_nodes * n_components);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          if (active.is_active(i, c))
            x(i * n_components + c) = number(generator);
      return x;
    }

    /** One sweep by the definition: each node in turn is given the values that
     * solve its own active equations. */
    void
    sweep(Vector<double> &x, const Vector<double> &b, const bool forward) const
    {
      for (unsigned int step = 0; step < n_nodes; ++step)
        {
          const unsigned int        i = forward ? step : n_nodes - 1 - step;
          std::vector<unsigned int> components;
          for (unsigned int c = 0; c < n_components; ++c)
            if (active.is_active(i, c))
              components.push_back(i * n_components + c);
          const unsigned int n = components.size();
          if (n == 0)
            continue;
          FullMatrix<double> block(n);
          Vector<double>     rest(n), change(n);
          for (unsigned int c = 0; c < n; ++c)
            {
              rest(c) = b(components[c]);
              for (unsigned int j = 0; j < x.size(); ++j)
                rest(c) -= dense(components[c], j) * x(j);
              for (unsigned int d = 0; d < n; ++d)
                block(c, d) = dense(components[c], components[d]);
            }
          block.gauss_jordan();
          block.vmult(change, rest);
          for (unsigned int c = 0; c < n; ++c)
            x(components[c]) += change(c);
        }
    }
  };



  template <int n_components, typename Number>
  void
  expect_sweeps_by_definition()
  {
    RandomSystem<n_components> system;
    const double precision = 1e3 * std::numeric_limits<Number>::epsilon();

    BlockGaussSeidel<n_components, Number> smoother(
      system.matrix.shared_sparsity());
    for (unsigned int i = 0; i < system.n_nodes; ++i)
      {
        smoother.set_row(i, system.matrix);
        smoother.set_diagonal(i,
                              system.matrix.diagonal_block(i),
                              system.active);
      }

    const Vector<double> b = system.random();
    Vector<double>       x(b.size()), r(b.size());
    auto                 ours_b   = system.nodes.template make_vector<Number>();
    auto                 ours_x   = ours_b;
    auto                 residual = ours_b, change = ours_b;
    std::copy(b.begin(), b.end(), ours_b.begin());
    const auto expect_equal = [&](const auto &ours, const Vector<double> &y) {
      for (unsigned int i = 0; i < y.size(); ++i)
        EXPECT_NEAR(ours.local_element(i), y(i), precision);
    };
    // The residual counts where components take part.
    const auto expect_residual = [&]() {
      system.dense.residual(r, x, b);
      for (unsigned int i = 0; i < system.n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          if (system.active.is_active(i, c))
            {
              EXPECT_NEAR(residual.local_element(i * n_components + c),
                          r(i * n_components + c),
                          precision);
            }
    };

    system.sweep(x, b, true);
    // Values from before must not matter.
    ours_x = Number(7.);
    smoother.sweep_from_zero(ours_x, ours_b);
    expect_equal(ours_x, x);
    smoother.residual_after_first_sweep(residual, ours_x, ours_b);
    expect_residual();

    system.sweep(x, b, true);
    smoother.sweep_forward(ours_x, change, ours_b);
    expect_equal(ours_x, x);
    smoother.residual_after_sweep(residual, ours_x, change, ours_b);
    expect_residual();

    x = system.random();
    std::copy(x.begin(), x.end(), ours_x.begin());
    system.sweep(x, b, false);
    smoother.sweep_backward(ours_x, ours_b);
    expect_equal(ours_x, x);
  }
} // namespace



TEST(BlockGaussSeidel, SweepsAreThoseOfTheDefinition)
{
  expect_sweeps_by_definition<1, double>();
  expect_sweeps_by_definition<2, double>();
  expect_sweeps_by_definition<3, double>();
}



TEST(BlockGaussSeidel, SinglePrecision)
{
  expect_sweeps_by_definition<1, float>();
  expect_sweeps_by_definition<2, float>();
  expect_sweeps_by_definition<3, float>();
}
