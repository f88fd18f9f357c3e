// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/masked_entries.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

#include <algorithm>
#include <functional>

namespace StickSlip
{
  namespace
  {
    /** The lines or patches @p groups and all nodes that are in none of them,
     * as groups of one node, in the order of their first nodes. */
    std::vector<std::vector<unsigned int>>
    with_single_nodes(std::vector<std::vector<unsigned int>> groups,
                      const unsigned int                     n_nodes)
    {
      std::vector<bool> is_in_group(n_nodes, false);
      for (const std::vector<unsigned int> &group : groups)
        for (const unsigned int i : group)
          is_in_group[i] = true;
      for (unsigned int i = 0; i < n_nodes; ++i)
        if (!is_in_group[i])
          groups.push_back({i});
      std::stable_sort(groups.begin(),
                       groups.end(),
                       [](const auto &a, const auto &b) {
                         return *std::min_element(a.begin(), a.end()) <
                                *std::min_element(b.begin(), b.end());
                       });
      return groups;
    }



    /** Places of owned nodes and ghosts in the sweep, the same for those of a
     * line; empty if they are relaxed by their numbers. Ghosts that couple to
     * an owned node have another turn than that. */
    std::vector<std::uint64_t>
    order_of_sweep(const SweepTurns            &turns,
                   const std::vector<NodeLine> &lines,
                   const BlockSparsity         &sparsity)
    {
      if (turns.n_turns() == 1 && lines.empty())
        return {};
      unsigned int n_local = sparsity.n_rows();
      for (const unsigned int j : sparsity.column)
        n_local = std::max(n_local, j + 1);
      std::vector<std::uint64_t> order(n_local);
      for (unsigned int i = 0; i < n_local; ++i)
        order[i] = i;
      for (std::uint64_t l = 0; l < lines.size(); ++l)
        for (const unsigned int i : lines[l])
          order[i] = l;
      for (unsigned int i = 0; i < n_local; ++i)
        order[i] += std::uint64_t(turns.turn_of(i)) << 32;
      return order;
    }



    /** The end of the owned and ghost values of a vector. */
    template <typename Vector>
    auto
    end_of_local(Vector &x)
    {
      return x.begin() + x.locally_owned_size() +
             x.get_partitioner()->n_ghost_indices();
    }
  } // namespace



  template <int n_components, typename Number>
  BlockGaussSeidel<n_components, Number>::BlockGaussSeidel(
    const std::shared_ptr<const BlockSparsity> &sparsity,
    const std::vector<NodeLine>                &lines,
    const std::vector<NodePatch>               &patches,
    const NodePartition                        &nodes)
  {
    AssertThrow(lines.empty() || patches.empty(),
                ExcMessage("Lines and patches exclude each other."));
    const unsigned int                     n_rows = sparsity->n_rows();
    std::vector<std::vector<unsigned int>> units;
    if (!lines.empty() || !patches.empty())
      units = with_single_nodes(lines.empty() ? patches : lines, n_rows);
    turns = SweepTurns(nodes, *sparsity, units, !patches.empty());
    if (!patches.empty())
      {
        // Rows of patches are read as a whole, in any order.
        triangles     = SweepTriangles<n_components, Number>(sparsity);
        patch_factors = PatchFactors<n_components, Number>(n_rows, units);
        remainder.resize(patch_factors.largest() * n_components);
        return;
      }
    triangles = SweepTriangles<n_components, Number>(
      sparsity, order_of_sweep(turns, units, *sparsity));
    if (!lines.empty())
      {
        line_factors = LineFactors<n_components, Number>(*sparsity, units);
        remainder.resize(line_factors.longest() * n_components);
      }
    else
      inverse_diagonal.resize(std::size_t(n_rows) * n_components *
                                n_components +
                              Kernels::sweep_padding);
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  BlockGaussSeidel<n_components, Number>::set_row(
    const unsigned int                            i,
    const BlockMatrix<n_components, OtherNumber> &matrix)
  {
    triangles.set_row(i, matrix);
    if (has_lines())
      line_factors.set_row(i, matrix);
    if (has_patches())
      patch_factors.touch(i);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::set_diagonal(
    const unsigned int             i,
    const Tensor<2, n_components> &block,
    const NodeMask                &active)
  {
    if (has_patches())
      {
        patch_factors.set_diagonal(i, block, active);
        return;
      }
    if (has_lines())
      {
        line_factors.set_diagonal(i, block, active);
        return;
      }
    const Tensor<2, n_components> inverse = invert_active(block, active, i);
    Number                       *target =
      inverse_diagonal.data() + std::size_t(i) * n_components * n_components;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        target[Kernels::sweep_position<n_components>(c, d)] = inverse[c][d];
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::factorise()
  {
    line_factors.factorise();
    patch_factors.factorise(triangles);
  }



  template <int n_components, typename Number>
  template <typename Relax>
  void
  BlockGaussSeidel<n_components, Number>::for_each_range(
    const bool                is_forward,
    const NodeValues<Number> &x,
    const Relax              &relax) const
  {
    for (unsigned int k = 0; k < turns.n_turns(); ++k)
      {
        const unsigned int turn   = is_forward ? k : turns.n_turns() - 1 - k;
        const auto        &ranges = turns.units(turn);
        for (unsigned int r = 0; r < ranges.size(); ++r)
          {
            const auto &[begin, end] =
              ranges[is_forward ? r : ranges.size() - 1 - r];
            relax(begin, end);
          }
        if (is_forward || turn > 0)
          turns.update_ghosts(x, turn);
      }
  }



  template <int n_components, typename Number>
  template <typename Relax>
  void
  BlockGaussSeidel<n_components, Number>::for_each_unit(
    const bool                is_forward,
    const NodeValues<Number> &x,
    const Relax              &relax) const
  {
    for_each_range(is_forward,
                   x,
                   [&](const unsigned int begin, const unsigned int end) {
                     for (unsigned int k = 0; k < end - begin; ++k)
                       relax(is_forward ? begin + k : end - 1 - k);
                   });
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep(
    const bool                is_forward,
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    if (has_patches())
      for_each_unit(is_forward, x, [&](const unsigned int p) {
        relax_patch(p, b, x);
      });
    else if (has_lines())
      for_each_unit(is_forward, x, [&](const unsigned int l) {
        relax_line(l, b, x);
      });
    else
      {
        const auto kernel = is_forward ?
                              Kernels::sweep_forward<n_components, Number> :
                              Kernels::sweep_backward<n_components, Number>;
        for_each_range(is_forward,
                       x,
                       [&](const unsigned int begin, const unsigned int end) {
                         kernel(triangles.below(),
                                triangles.above(),
                                inverse_diagonal.data(),
                                begin,
                                end,
                                b.begin(),
                                x.begin());
                       });
      }
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_from_zero(
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    if (has_patches())
      {
        // Patches see each other's nodes before these have been relaxed.
        std::fill(x.begin(), end_of_local(x), Number(0.));
        sweep(/*is_forward=*/true, x, b);
      }
    else if (has_lines())
      for_each_unit(/*is_forward=*/true, x, [&](const unsigned int l) {
        const NodeLine &nodes = line_factors.nodes(l);
        Kernels::remainder_below<n_components>(triangles.below(),
                                               nodes.data(),
                                               nodes.size(),
                                               b.begin(),
                                               x.begin(),
                                               remainder.data());
        solve_line(l, x);
      });
    else
      for_each_range(/*is_forward=*/true,
                     x,
                     [&](const unsigned int begin, const unsigned int end) {
                       Kernels::sweep_from_zero<n_components>(
                         triangles.below(),
                         inverse_diagonal.data(),
                         begin,
                         end,
                         b.begin(),
                         x.begin());
                     });
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_after_first_sweep(
    NodeValues<Number>       &r,
    const NodeValues<Number> &x,
    const NodeValues<Number> &b) const
  {
    residual_after_sweep(r, x, x, b);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_forward(
    NodeValues<Number>       &x,
    NodeValues<Number>       &change,
    const NodeValues<Number> &b) const
  {
    update_ghosts(x);
    std::copy(x.begin(), end_of_local(x), change.begin());
    sweep(/*is_forward=*/true, x, b);
    std::transform(x.begin(),
                   end_of_local(x),
                   change.begin(),
                   change.begin(),
                   std::minus<Number>());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_after_sweep(
    NodeValues<Number>       &r,
    const NodeValues<Number> &x,
    const NodeValues<Number> &change,
    const NodeValues<Number> &b) const
  {
    if (has_patches())
      for (unsigned int i = 0; i < triangles.n_rows(); ++i)
        residual_of(&i, 1, b, x, r.begin() + std::size_t(i) * n_components);
    else
      Kernels::residual_after_sweep<n_components>(triangles.above(),
                                                  triangles.n_rows(),
                                                  change.begin(),
                                                  r.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_in_rows(
    const std::vector<unsigned int> &rows,
    NodeValues<Number>              &r,
    const NodeValues<Number>        &x,
    const NodeValues<Number>        &b) const
  {
    for (const unsigned int i : rows)
      residual_of(&i, 1, b, x, r.begin() + std::size_t(i) * n_components);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_backward(
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    update_ghosts(x);
    sweep(/*is_forward=*/false, x, b);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::relax_line(
    const unsigned int        l,
    const NodeValues<Number> &b,
    NodeValues<Number>       &x) const
  {
    const NodeLine &nodes = line_factors.nodes(l);
    Kernels::remainder_beside<n_components>(triangles.below(),
                                            triangles.above(),
                                            nodes.data(),
                                            nodes.size(),
                                            b.begin(),
                                            x.begin(),
                                            remainder.data());
    solve_line(l, x);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::solve_line(
    const unsigned int  l,
    NodeValues<Number> &x) const
  {
    line_factors.solve(l, remainder.data());
    const NodeLine &nodes = line_factors.nodes(l);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      std::copy_n(remainder.data() + std::size_t(k) * n_components,
                  n_components,
                  x.begin() + std::size_t(nodes[k]) * n_components);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::relax_patch(
    const unsigned int        p,
    const NodeValues<Number> &b,
    NodeValues<Number>       &x) const
  {
    residual_of(
      patch_factors.nodes(p), patch_factors.n_nodes(p), b, x, remainder.data());
    patch_factors.add_solution(p, remainder.data(), x.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_of(
    const unsigned int       *rows,
    const unsigned int        n,
    const NodeValues<Number> &b,
    const NodeValues<Number> &x,
    Number                   *s) const
  {
    Kernels::remainder_beside<n_components>(
      triangles.below(), triangles.above(), rows, n, b.begin(), x.begin(), s);
    for (unsigned int k = 0; k < n; ++k)
      patch_factors.subtract_diagonal(rows[k],
                                      x.begin(),
                                      s + std::size_t(k) * n_components);
  }



  template <int n_components, typename Number>
  std::size_t
  BlockGaussSeidel<n_components, Number>::memory_consumption() const
  {
    return triangles.memory_consumption() + turns.memory_consumption() +
           sizeof(Number) * inverse_diagonal.capacity() +
           line_factors.memory_consumption() +
           patch_factors.memory_consumption();
  }



#define STICKSLIP_INSTANTIATE(n_components)                              \
  template class BlockGaussSeidel<n_components, float>;                  \
  template class BlockGaussSeidel<n_components, double>;                 \
  template void BlockGaussSeidel<n_components, float>::set_row<float>(   \
    const unsigned int, const BlockMatrix<n_components, float> &);       \
  template void BlockGaussSeidel<n_components, float>::set_row<double>(  \
    const unsigned int, const BlockMatrix<n_components, double> &);      \
  template void BlockGaussSeidel<n_components, double>::set_row<double>( \
    const unsigned int, const BlockMatrix<n_components, double> &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
