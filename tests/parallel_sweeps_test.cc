// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>
#include <stickslip/algebra/index_set.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

#include <random>

using namespace StickSlip;

namespace
{
  constexpr unsigned int n_components = 2, per_process = 30;

  using Nodes = std::vector<unsigned int>;



  /** A symmetric system with random couplings, the same on all processes, of
   * which each has its rows. Some components take no part. */
  struct SharedSystem
  {
    const unsigned int me = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                       n_nodes = per_process * Utilities::MPI::n_mpi_processes(
                                                 MPI_COMM_WORLD);
    std::mt19937                           generator{7};
    std::uniform_real_distribution<double> number{-1., 1.};
    FullMatrix<double>                     dense{n_nodes * n_components};
    std::vector<Nodes>                     couplings{n_nodes};
    NodePartition                          nodes;
    BlockMatrix<n_components>              matrix;
    NodeMask                               active;

    SharedSystem()
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          couple(i, i);
          for (unsigned int j = 0; j < i; ++j)
            if (const bool is_near = i - j <= 2;
                number(generator) > 0.9 || is_near)
              couple(i, j);
        }
      IndexSet owned(n_nodes);
      owned.add_range(me * per_process, (me + 1) * per_process);
      std::vector<types::global_dof_index> ghosts;
      for (unsigned int i = 0; i < per_process; ++i)
        for (const unsigned int j : couplings[global(i)])
          if (!owned.is_element(j))
            ghosts.push_back(j);
      nodes = NodePartition(owned,
                            make_index_set(n_nodes, ghosts),
                            n_components,
                            MPI_COMM_WORLD);
      std::vector<Nodes> rows(per_process);
      for (unsigned int i = 0; i < per_process; ++i)
        for (const unsigned int j : couplings[global(i)])
          rows[i].push_back(nodes.local_index(j));
      matrix =
        BlockMatrix<n_components>(std::make_shared<const BlockSparsity>(rows));
      for (unsigned int i = 0; i < per_process; ++i)
        for (const unsigned int j : rows[i])
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              matrix.block(
                matrix.sparsity().position(i, j))[c * n_components + d] =
                dense(global(i) * n_components + c,
                      nodes.global_index(j) * n_components + d);
      active = NodeMask(nodes.n_local(), n_components);
      for (unsigned int i = 0; i < nodes.n_local(); ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          if (!is_active(nodes.global_index(i), c))
            active.mask(i, c);
    }

    unsigned int
    global(const unsigned int node) const
    {
      return me * per_process + node;
    }

    void
    couple(const unsigned int i, const unsigned int j)
    {
      couplings[i].push_back(j);
      if (i != j)
        couplings[j].push_back(i);
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < (i == j ? c + 1 : n_components); ++d)
          {
            const unsigned int row    = i * n_components + c,
                               column = j * n_components + d;
            dense(row, column)        = dense(column, row) =
              number(generator) + (row == column ? 20. : 0.);
          }
    }

    static bool
    is_active(const unsigned int node, const unsigned int component)
    {
      return node % 7 != 3 && (node % 5 != 0 || component == 1);
    }

    Vector<double>
    random()
    {
      Vector<double> x(n_nodes * n_components);
      for (unsigned int i = 0; i < x.size(); ++i)
        if (const double value = number(generator);
            is_active(i / n_components, i % n_components))
          x(i) = value;
      return x;
    }

    NodalVector
    part_of(const Vector<double> &x) const
    {
      NodalVector result = nodes.make_vector();
      for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
        result.local_element(i) = x(me * per_process * n_components + i);
      return result;
    }

    void
    expect_equal(const NodalVector &ours, const Vector<double> &x) const
    {
      for (unsigned int i = 0; i < ours.locally_owned_size(); ++i)
        if (const unsigned int k = me * per_process * n_components + i;
            is_active(k / n_components, k % n_components))
          {
            EXPECT_NEAR(ours.local_element(i), x(k), 1e-13);
          }
    }

    /** The equations of the active components of a unit are solved, unit after
     * unit. */
    void
    sweep(Vector<double>           &x,
          const Vector<double>     &b,
          const std::vector<Nodes> &units) const
    {
      for (const Nodes &unit : units)
        {
          std::vector<unsigned int> entries;
          for (const unsigned int i : unit)
            for (unsigned int c = 0; c < n_components; ++c)
              if (is_active(i, c))
                entries.push_back(i * n_components + c);
          const unsigned int n = entries.size();
          if (n == 0)
            continue;
          FullMatrix<double> block(n);
          Vector<double>     rest(n), change(n);
          for (unsigned int k = 0; k < n; ++k)
            {
              rest(k) = b(entries[k]);
              for (unsigned int j = 0; j < x.size(); ++j)
                rest(k) -= dense(entries[k], j) * x(j);
              for (unsigned int m = 0; m < n; ++m)
                block(k, m) = dense(entries[k], entries[m]);
            }
          block.gauss_jordan();
          block.vmult(change, rest);
          for (unsigned int k = 0; k < n; ++k)
            x(entries[k]) += change(k);
        }
    }
  };



  /** All units of all processes in the order of the turns, by global numbers.
   */
  std::vector<Nodes>
  in_order(const SharedSystem       &system,
           const std::vector<Nodes> &units,
           const bool                may_overlap)
  {
    const SweepTurns                turns(system.nodes,
                           system.matrix.sparsity(),
                           units,
                           may_overlap);
    std::vector<std::vector<Nodes>> own(turns.n_turns());
    for (unsigned int turn = 0; turn < turns.n_turns(); ++turn)
      for (const auto &[begin, end] : turns.units(turn))
        for (unsigned int u = begin; u < end; ++u)
          {
            own[turn].emplace_back();
            for (const unsigned int i : units[u])
              own[turn].back().push_back(system.global(i));
          }
    std::vector<Nodes> result;
    const auto         of_all = Utilities::MPI::all_gather(MPI_COMM_WORLD, own);
    for (unsigned int turn = 0; turn < turns.n_turns(); ++turn)
      for (const auto &of_one : of_all)
        result.insert(result.end(), of_one[turn].begin(), of_one[turn].end());
    return result;
  }



  /** Sweeps are those of one process that goes from unit to unit. */
  void
  expect_sweeps_of_the_whole(const std::vector<Nodes> &units,
                             const bool                are_lines,
                             const bool                are_patches)
  {
    SharedSystem                           system;
    BlockGaussSeidel<n_components, double> smoother(
      system.matrix.shared_sparsity(),
      are_lines ? units : std::vector<Nodes>(),
      are_patches ? units : std::vector<Nodes>(),
      system.nodes);
    for (unsigned int i = 0; i < per_process; ++i)
      {
        smoother.set_row(i, system.matrix);
        smoother.set_diagonal(i,
                              system.matrix.diagonal_block(i),
                              system.active);
      }
    smoother.factorise();
    std::vector<Nodes> order = in_order(system, units, are_patches);

    const Vector<double> b      = system.random();
    const NodalVector    ours_b = system.part_of(b);
    Vector<double>       x(b.size()), r(b.size());
    NodalVector          ours = ours_b, residual = ours_b, change = ours_b;
    const auto           expect_residual = [&]() {
      system.dense.residual(r, x, b);
      system.expect_equal(residual, r);
    };

    system.sweep(x, b, order);
    smoother.sweep_from_zero(ours, ours_b);
    system.expect_equal(ours, x);
    smoother.residual_after_first_sweep(residual, ours, ours_b);
    expect_residual();

    system.sweep(x, b, order);
    smoother.sweep_forward(ours, change, ours_b);
    system.expect_equal(ours, x);
    smoother.residual_after_sweep(residual, ours, change, ours_b);
    expect_residual();

    std::reverse(order.begin(), order.end());
    x    = system.random();
    ours = system.part_of(x);
    system.sweep(x, b, order);
    smoother.sweep_backward(ours, ours_b);
    system.expect_equal(ours, x);
  }



  /** Groups of @p n nodes, one beginning @p step nodes behind the other. */
  std::vector<Nodes>
  groups(const unsigned int n, const unsigned int step)
  {
    std::vector<Nodes> result;
    for (unsigned int i = 0; i + n <= per_process; i += step)
      {
        result.emplace_back();
        for (unsigned int k = 0; k < n; ++k)
          result.back().push_back(i + k);
      }
    return result;
  }
} // namespace



TEST(ParallelSweeps, OverNodesAreThoseOfTheWhole)
{
  expect_sweeps_of_the_whole(groups(1, 1), false, false);
}



TEST(ParallelSweeps, OverLinesAreThoseOfTheWhole)
{
  expect_sweeps_of_the_whole(groups(3, 3), true, false);
}



TEST(ParallelSweeps, OverPatchesAreThoseOfTheWhole)
{
  expect_sweeps_of_the_whole(groups(2, 1), false, true);
}
