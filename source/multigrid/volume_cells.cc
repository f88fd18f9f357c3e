// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/multigrid/volume_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    constexpr double largest_ratio = 0.1;

    /** Nodes inside of a mesh of quadrilaterals have so many neighbours. On
     * the surface of a body narrow cells bend easily, whatever they are made
     * of. */
    constexpr unsigned int neighbours_inside = 8;

    /** One node in so many is looked at first. */
    constexpr unsigned int longest_stride = 64, least_samples = 100;

    /** More neighbours than bits of a set, or nodes in a cell, there are only
     * where faults couple rows of both sides. */
    constexpr unsigned int most_neighbours = 64, most_nodes = 16;

    /** A vortex needs more than two. */
    constexpr unsigned int least_nodes = 3;

    /** The least eigenvalue of a symmetric positive definite matrix of n rows,
     * from above, by inverse iteration; infinite if the matrix is not
     * definite. Destroys the matrix. */
    double
    least_eigenvalue(std::vector<double> &A, const unsigned int n)
    {
      double trace = 0.;
      for (unsigned int i = 0; i < n; ++i)
        trace += A[i * n + i];
      try
        {
          factorise_symmetric(A, n, "the matrix of a cell");
        }
      catch (const SingularMatrix &)
        {
          return std::numeric_limits<double>::infinity();
        }
      for (unsigned int i = 0; i < n; ++i)
        if (!(A[i * n + i] * A[i * n + i] > 1e-12 * trace))
          return std::numeric_limits<double>::infinity();
      const auto dot = [](const std::vector<double> &x,
                          const std::vector<double> &y) {
        return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
      };
      std::vector<double> x(n), before;
      for (unsigned int i = 0; i < n; ++i)
        x[i] = 1. + 0.7 * std::sin(2.3 * i + 0.4 * i * i);
      double result = 0.;
      for (unsigned int step = 0; step < 5; ++step)
        {
          const double norm = std::sqrt(dot(x, x));
          for (double &value : x)
            value /= norm;
          before = x;
          solve_factorised(A, x);
          result = 1. / dot(before, x);
        }
      return result;
    }



    /** The ratio of find_stiff_volumes() for the nodes of a cell. */
    template <typename Matrix>
    double
    volume_ratio(const Matrix &matrix, const NodePatch &cell)
    {
      constexpr unsigned int n_components =
        decltype(matrix.diagonal_block(0))::dimension;
      const unsigned int  n = cell.size(), N = n * n_components;
      std::vector<double> A(std::size_t(N) * N), S(std::size_t(n) * n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const auto block =
              matrix.entry(cell[i],
                           matrix.sparsity().position(cell[i], cell[j]));
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                A[(i * n_components + c) * N + j * n_components + d] =
                  block[c][d];
            for (unsigned int c = 0; c < n_components; ++c)
              S[i * n + j] += block[c][c];
          }
      const double of_cell = least_eigenvalue(A, N);
      return std::isfinite(of_cell) ?
               n_components * of_cell / least_eigenvalue(S, n) :
               1.;
    }



    /**
     * The largest sets of nodes that all couple to each other (Bron and
     * Kerbosch 1973), among a part of the nodes.
     */
    class CellFinder
    {
    public:
      CellFinder(const BlockSparsity     &sparsity,
                 const std::vector<bool> &is_part)
        : sparsity(sparsity)
        , is_part(is_part)
        , place(is_part.size(), numbers::invalid_unsigned_int)
      {}

      /** Call @p action(cell) for all cells of a node, or for those only of
       * which it is the first node. */
      template <typename Action>
      void
      for_each_cell(const unsigned int node,
                    const bool         if_first,
                    const Action      &action)
      {
        near.clear();
        for (unsigned int k = sparsity.row_start[node];
             k < sparsity.row_start[node + 1];
             ++k)
          {
            const unsigned int j = sparsity.column[k];
            if (j != node && j < is_part.size() && is_part[j])
              near.push_back(j);
          }
        if (near.size() > most_neighbours)
          return;
        for (unsigned int a = 0; a < near.size(); ++a)
          place[near[a]] = a;
        std::uint64_t candidates = 0, earlier = 0;
        for (unsigned int a = 0; a < near.size(); ++a)
          {
            coupled[a] = 0;
            for (unsigned int k = sparsity.row_start[near[a]];
                 k < sparsity.row_start[near[a] + 1];
                 ++k)
              {
                const unsigned int j = sparsity.column[k];
                if (j < is_part.size() && j != near[a] &&
                    place[j] != numbers::invalid_unsigned_int)
                  coupled[a] |= bit(place[j]);
              }
            (if_first && near[a] < node ? earlier : candidates) |= bit(a);
          }
        for (const unsigned int j : near)
          place[j] = numbers::invalid_unsigned_int;
        extend(node, 0, candidates, earlier, action);
      }

    private:
      static std::uint64_t
      bit(const unsigned int a)
      {
        return std::uint64_t(1) << a;
      }

      /** The cells that have the node and the @p members, any of the @p
       * candidates and none of the nodes @p without. */
      template <typename Action>
      void
      extend(const unsigned int  node,
             const std::uint64_t members,
             std::uint64_t       candidates,
             std::uint64_t       without,
             const Action       &action) const
      {
        if (candidates == 0)
          {
            if (without == 0)
              {
                NodePatch cell = {node};
                for (unsigned int a = 0; a < near.size(); ++a)
                  if (members & bit(a))
                    cell.push_back(near[a]);
                std::sort(cell.begin(), cell.end());
                action(cell);
              }
            return;
          }
        // Neighbours of the node with the most of them come with it.
        unsigned int  most  = 0;
        std::uint64_t pivot = 0;
        for (unsigned int a = 0; a < near.size(); ++a)
          if ((candidates | without) & bit(a))
            {
              const unsigned int n =
                1 + __builtin_popcountll(candidates & coupled[a]);
              if (n > most)
                {
                  most  = n;
                  pivot = coupled[a];
                }
            }
        for (unsigned int a = 0; a < near.size(); ++a)
          if (candidates & ~pivot & bit(a))
            {
              extend(node,
                     members | bit(a),
                     candidates & coupled[a],
                     without & coupled[a],
                     action);
              candidates &= ~bit(a);
              without |= bit(a);
            }
      }

      const BlockSparsity                       &sparsity;
      const std::vector<bool>                   &is_part;
      std::vector<unsigned int>                  place;
      std::vector<unsigned int>                  near;
      std::array<std::uint64_t, most_neighbours> coupled;
    };
  } // namespace



  template <typename Matrix>
  StiffVolumes
  find_stiff_volumes(const BlockSparsity             &sparsity,
                     const std::vector<Matrix>       &matrices,
                     const NodeMask                  &fixed,
                     const std::vector<unsigned int> &nonsmooth_nodes)
  {
    if (fixed.n_components() != 2)
      return {};
    const unsigned int n = sparsity.n_rows();
    std::vector<bool>  is_inside(n);
    for (unsigned int i = 0; i < n; ++i)
      is_inside[i] =
        fixed.is_fully_active(i) &&
        sparsity.row_start[i + 1] - sparsity.row_start[i] > neighbours_inside;
    for (const unsigned int i : nonsmooth_nodes)
      is_inside[i] = false;

    // The least ratio of a cell, and its matrix.
    using Ratio      = std::pair<double, unsigned int>;
    const auto ratio = [&](const NodePatch &cell) {
      Ratio least(1., numbers::invalid_unsigned_int);
      if (cell.size() >= least_nodes)
        for (unsigned int t = 0; t < matrices.size(); ++t)
          least = std::min(least, Ratio(volume_ratio(matrices[t], cell), t));
      return least;
    };

    CellFinder         finder(sparsity, is_inside);
    const unsigned int stride =
      std::max(1u, std::min(longest_stride, n / least_samples));
    bool found = false;
    for (unsigned int i = stride / 2; i < n && !found; i += stride)
      if (is_inside[i])
        {
          bool is_known = false;
          finder.for_each_cell(i, false, [&](const NodePatch &cell) {
            if (is_known || cell.size() < least_nodes)
              return;
            is_known = true;
            found    = ratio(cell).first <= largest_ratio;
          });
        }
    if (!found)
      return {};

    StiffVolumes        result(n, numbers::invalid_unsigned_int);
    std::vector<double> least(n, largest_ratio);
    for (unsigned int i = 0; i < n; ++i)
      if (is_inside[i])
        finder.for_each_cell(i, true, [&](const NodePatch &cell) {
          const Ratio its_ratio = ratio(cell);
          for (const unsigned int j : cell)
            if (its_ratio.first <= least[j])
              {
                least[j]  = its_ratio.first;
                result[j] = its_ratio.second;
              }
        });
    // Also the nodes on surfaces of the same bodies, and where graded meshes
    // have fewer neighbours.
    for (unsigned int time = 0; time < 2; ++time)
      {
        const StiffVolumes before = result;
        for (unsigned int i = 0; i < n; ++i)
          if (before[i] == numbers::invalid_unsigned_int)
            for (unsigned int k = sparsity.row_start[i];
                 k < sparsity.row_start[i + 1];
                 ++k)
              if (sparsity.column[k] < n)
                result[i] = std::min(result[i], before[sparsity.column[k]]);
      }
    return result;
  }



  StiffVolumes
  coarsen_stiff_volumes(const StiffVolumes   &fine,
                        const TransferMatrix &prolongation,
                        const unsigned int    n_coarse)
  {
    if (fine.empty())
      return {};
    StiffVolumes result(n_coarse, numbers::invalid_unsigned_int);
    const TransferMatrix::Compressed &P = prolongation.matrix();
    for (unsigned int i = 0; i < fine.size(); ++i)
      if (fine[i] != numbers::invalid_unsigned_int)
        for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
          if (P.column[k] < n_coarse)
            result[P.column[k]] = std::min(result[P.column[k]], fine[i]);
    return result;
  }



  std::vector<NodePatch>
  find_stiff_cells(const BlockSparsity &sparsity,
                   const NodeMask      &fixed,
                   const StiffVolumes  &stiff_volumes)
  {
    std::vector<NodePatch> result;
    if (stiff_volumes.empty())
      return result;
    std::vector<bool> is_free(stiff_volumes.size(), false);
    for (unsigned int i = 0; i < is_free.size(); ++i)
      for (unsigned int c = 0; c < fixed.n_components(); ++c)
        if (fixed.is_active(i, c))
          is_free[i] = true;
    CellFinder finder(sparsity, is_free);
    for (unsigned int i = 0; i < is_free.size(); ++i)
      if (is_free[i])
        finder.for_each_cell(i, true, [&](const NodePatch &cell) {
          if (cell.size() <= most_nodes &&
              std::any_of(cell.begin(), cell.end(), [&](const unsigned int j) {
                return stiff_volumes[j] != numbers::invalid_unsigned_int;
              }))
            result.push_back(cell);
        });
    return result;
  }



#define STICKSLIP_INSTANTIATE(...)                       \
  template StiffVolumes find_stiff_volumes<__VA_ARGS__>( \
    const BlockSparsity &,                               \
    const std::vector<__VA_ARGS__> &,                    \
    const NodeMask &,                                    \
    const std::vector<unsigned int> &);

  STICKSLIP_INSTANTIATE(TermMatrix<1>)
  STICKSLIP_INSTANTIATE(TermMatrix<2>)
  STICKSLIP_INSTANTIATE(TermMatrix<3>)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
