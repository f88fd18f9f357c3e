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
    : sparsity(sparsity)
    , n_rows(sparsity->n_rows())
  {
    AssertThrow(lines.empty() || patches.empty(),
                ExcMessage("Lines and patches exclude each other."));
    std::vector<std::vector<unsigned int>> units;
    if (!lines.empty() || !patches.empty())
      units = with_single_nodes(lines.empty() ? patches : lines, n_rows);
    turns = SweepTurns(nodes, *sparsity, units, !patches.empty());
    if (!lines.empty())
      {
        factors = LineFactors<n_components, Number>(*sparsity, units);
        remainder.resize(factors.longest() * n_components);
      }
    if (!patches.empty())
      {
        patch_factors = PatchFactors<n_components, Number>(n_rows, units);
        remainder.resize(patch_factors.largest() * n_components);
        components.assign(n_rows, 0);
        diagonal.resize(std::size_t(n_rows) * n_components * n_components);
      }
    if (has_lines() || (turns.n_turns() > 1 && !has_patches()))
      sorted_columns = sparsity->column;
    lower.row_start.reserve(n_rows + 1);
    upper.row_start.reserve(n_rows + 1);
    first_upper.reserve(n_rows);
    std::vector<unsigned int> below, beside, above;
    for (unsigned int i = 0; i < n_rows; ++i)
      {
        below.clear();
        beside.clear();
        above.clear();
        for (unsigned int k = sparsity->row_start[i];
             k < sparsity->row_start[i + 1];
             ++k)
          {
            const unsigned int j    = sparsity->column[k];
            const Part        *part = part_of(i, j);
            if (part == &lower)
              below.push_back(j);
            else if (part == &upper)
              above.push_back(j);
            else if (i != j)
              beside.push_back(j);
          }
        if (!sorted_columns.empty())
          {
            beside.push_back(i);
            auto next = sorted_columns.begin() + sparsity->row_start[i];
            for (const auto *columns : {&below, &beside, &above})
              next = std::copy(columns->begin(), columns->end(), next);
          }
        lower.row_start.push_back(lower.row_start.back() + below.size());
        upper.row_start.push_back(upper.row_start.back() + above.size());
        first_upper.push_back(sparsity->row_start[i + 1] - above.size());
      }
    for (Part *part : {&lower, &upper})
      part->values.resize(std::size_t(part->row_start.back()) * n_components *
                            n_components +
                          Kernels::sweep_padding);
    if (!has_lines() && !has_patches())
      inverse_diagonal.resize(std::size_t(n_rows) * n_components *
                                n_components +
                              Kernels::sweep_padding);
  }



  template <int n_components, typename Number>
  typename BlockGaussSeidel<n_components, Number>::Part *
  BlockGaussSeidel<n_components, Number>::part_of(const unsigned int row,
                                                  const unsigned int column)
  {
    const unsigned int turn        = has_patches() ? 0 : turns.turn_of(row),
                       column_turn = has_patches() ? 0 : turns.turn_of(column);
    if (column_turn != turn)
      return column_turn < turn ? &lower : &upper;
    // Ghosts have other turns, but among patches, whose rows have no order.
    unsigned int of_row = row, of_column = column;
    if (has_lines())
      {
        of_row    = factors.line_of(row);
        of_column = factors.line_of(column);
      }
    if (of_row == of_column)
      return nullptr;
    return of_column < of_row ? &lower : &upper;
  }



  template <int n_components, typename Number>
  Kernels::Triangle<Number>
  BlockGaussSeidel<n_components, Number>::lower_rows() const
  {
    return {lower.row_start.data(),
            sparsity->row_start.data(),
            columns().data(),
            lower.values.data()};
  }



  template <int n_components, typename Number>
  Kernels::Triangle<Number>
  BlockGaussSeidel<n_components, Number>::upper_rows() const
  {
    return {upper.row_start.data(),
            first_upper.data(),
            columns().data(),
            upper.values.data()};
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  BlockGaussSeidel<n_components, Number>::set_row(
    const unsigned int                            i,
    const BlockMatrix<n_components, OtherNumber> &matrix)
  {
    Number *next_lower = lower.values.data() + lower.first_value(i),
           *next_upper = upper.values.data() + upper.first_value(i);
    const auto copy    = [&](Number *&target, const unsigned int k) {
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          target[Kernels::sweep_position<n_components>(c, d)] =
            matrix.block(k)[c * n_components + d];
      target += n_components * n_components;
    };
    const unsigned int begin = sparsity->row_start[i],
                       end   = sparsity->row_start[i + 1];
    if (sorted_columns.empty())
      {
        for (unsigned int k = begin; k < sparsity->diagonal[i]; ++k)
          copy(next_lower, k);
        for (unsigned int k = sparsity->diagonal[i] + 1; k < end; ++k)
          copy(next_upper, k);
        if (has_patches())
          patch_factors.touch(i);
        return;
      }
    for (unsigned int k = begin; k < end; ++k)
      {
        const unsigned int j = sparsity->column[k];
        if (const Part *part = part_of(i, j))
          copy(part == &lower ? next_lower : next_upper, k);
        else if (i != j)
          factors.set_block(i, j, matrix.block(k));
      }
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
        components[i] = 0;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            if (active.is_active(i, c))
              components[i] |= 1u << c;
            for (unsigned int d = 0; d < n_components; ++d)
              diagonal[std::size_t(i) * n_components * n_components +
                       Kernels::sweep_position<n_components>(c, d)] =
                block[c][d];
          }
        patch_factors.touch(i);
        return;
      }

    if (has_lines())
      {
        factors.set_diagonal(i, block, active);
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
    factors.factorise();
    std::vector<double> entries;
    for (unsigned int p = 0; p < patch_factors.n_patches(); ++p)
      if (patch_factors.is_outdated(p))
        {
          copy_patch(p, entries);
          patch_factors.set_patch(p, entries);
        }
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::copy_patch(
    const unsigned int   p,
    std::vector<double> &entries) const
  {
    constexpr unsigned int block_size = n_components * n_components;
    const unsigned int     n_nodes    = patch_factors.n_nodes(p);
    const unsigned int     n          = n_nodes * n_components;
    const unsigned int    *nodes      = patch_factors.nodes(p);
    entries.resize(std::size_t(n) * n);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int b = 0; b <= a; ++b)
        {
          // Nodes are in ascending order, and all of them couple.
          const unsigned int i = nodes[a], j = nodes[b];
          const Number      *block;
          if (a == b)
            block = diagonal.data() + std::size_t(i) * block_size;
          else
            {
              const auto begin = columns().begin() + sparsity->row_start[i];
              const auto found =
                std::find(begin, begin + lower.n_entries(i), j);
              block = lower.values.data() + lower.first_value(i) +
                      std::size_t(found - begin) * block_size;
            }
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              {
                const unsigned int k = a * n_components + c,
                                   m = b * n_components + d;
                const double value =
                  ((components[i] >> c) & (components[j] >> d) & 1u) ?
                    block[Kernels::sweep_position<n_components>(c, d)] :
                    0.;
                entries[k * n + m] = entries[m * n + k] = value;
              }
        }
  }



  template <int n_components, typename Number>
  template <typename Relax>
  void
  BlockGaussSeidel<n_components, Number>::forward(const NodeValues<Number> &x,
                                                  const Relax &relax) const
  {
    for (unsigned int turn = 0; turn < turns.n_turns(); ++turn)
      {
        for (const auto &[begin, end] : turns.units(turn))
          relax(begin, end);
        turns.update_ghosts(x, turn);
      }
  }



  template <int n_components, typename Number>
  template <typename Relax>
  void
  BlockGaussSeidel<n_components, Number>::backward(const NodeValues<Number> &x,
                                                   const Relax &relax) const
  {
    for (unsigned int turn = turns.n_turns(); turn-- > 0;)
      {
        const auto &units = turns.units(turn);
        for (auto range = units.rbegin(); range != units.rend(); ++range)
          relax(range->first, range->second);
        if (turn > 0)
          turns.update_ghosts(x, turn);
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
        forward(x, [&](const unsigned int begin, const unsigned int end) {
          for (unsigned int p = begin; p < end; ++p)
            relax_patch(p, b, x);
        });
      }
    else if (has_lines())
      forward(x, [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int l = begin; l < end; ++l)
          {
            const NodeLine &nodes = factors.nodes(l);
            Kernels::remainder_below<n_components>(lower_rows(),
                                                   nodes.data(),
                                                   nodes.size(),
                                                   b.begin(),
                                                   x.begin(),
                                                   remainder.data());
            solve_line(l, x);
          }
      });
    else
      forward(x, [&](const unsigned int begin, const unsigned int end) {
        Kernels::sweep_from_zero<n_components>(lower_rows(),
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
    if (has_patches())
      forward(x, [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int p = begin; p < end; ++p)
          relax_patch(p, b, x);
      });
    else if (has_lines())
      forward(x, [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int l = begin; l < end; ++l)
          relax_line(l, b, x);
      });
    else
      forward(x, [&](const unsigned int begin, const unsigned int end) {
        Kernels::sweep_forward<n_components>(lower_rows(),
                                             upper_rows(),
                                             inverse_diagonal.data(),
                                             begin,
                                             end,
                                             b.begin(),
                                             x.begin());
      });
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
      for (unsigned int i = 0; i < n_rows; ++i)
        remainder_with_diagonal(
          &i, 1, b, x, r.begin() + std::size_t(i) * n_components);
    else
      Kernels::residual_after_sweep<n_components>(upper_rows(),
                                                  n_rows,
                                                  change.begin(),
                                                  r.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_backward(
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    update_ghosts(x);
    if (has_patches())
      backward(x, [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int p = end; p-- > begin;)
          relax_patch(p, b, x);
      });
    else if (has_lines())
      backward(x, [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int l = end; l-- > begin;)
          relax_line(l, b, x);
      });
    else
      backward(x, [&](const unsigned int begin, const unsigned int end) {
        Kernels::sweep_backward<n_components>(lower_rows(),
                                              upper_rows(),
                                              inverse_diagonal.data(),
                                              begin,
                                              end,
                                              b.begin(),
                                              x.begin());
      });
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::relax_line(
    const unsigned int        l,
    const NodeValues<Number> &b,
    NodeValues<Number>       &x) const
  {
    const NodeLine &nodes = factors.nodes(l);
    Kernels::remainder_beside<n_components>(lower_rows(),
                                            upper_rows(),
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
    factors.solve(l, remainder.data());
    const NodeLine &nodes = factors.nodes(l);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      std::copy_n(remainder.data() + std::size_t(k) * n_components,
                  n_components,
                  x.begin() + std::size_t(nodes[k]) * n_components);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::remainder_with_diagonal(
    const unsigned int       *rows,
    const unsigned int        n,
    const NodeValues<Number> &b,
    const NodeValues<Number> &x,
    Number                   *s) const
  {
    Kernels::remainder_beside<n_components>(
      lower_rows(), upper_rows(), rows, n, b.begin(), x.begin(), s);
    for (unsigned int k = 0; k < n; ++k)
      {
        const std::size_t first = std::size_t(rows[k]) * n_components;
        const Number     *D     = diagonal.data() + first * n_components;
        const Number     *x_k   = x.begin() + first;
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            s[k * n_components + c] -=
              D[Kernels::sweep_position<n_components>(c, d)] * x_k[d];
      }
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::relax_patch(
    const unsigned int        p,
    const NodeValues<Number> &b,
    NodeValues<Number>       &x) const
  {
    remainder_with_diagonal(
      patch_factors.nodes(p), patch_factors.n_nodes(p), b, x, remainder.data());
    patch_factors.add_solution(p, remainder.data(), x.begin());
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
      remainder_with_diagonal(
        &i, 1, b, x, r.begin() + std::size_t(i) * n_components);
  }



  template <int n_components, typename Number>
  std::size_t
  BlockGaussSeidel<n_components, Number>::Part::memory_consumption() const
  {
    return sizeof(unsigned int) * row_start.capacity() +
           sizeof(Number) * values.capacity();
  }



  template <int n_components, typename Number>
  std::size_t
  BlockGaussSeidel<n_components, Number>::memory_consumption() const
  {
    return lower.memory_consumption() + upper.memory_consumption() +
           sizeof(unsigned int) *
             (first_upper.capacity() + sorted_columns.capacity()) +
           sizeof(Number) *
             (inverse_diagonal.capacity() + diagonal.capacity()) +
           turns.memory_consumption() + factors.memory_consumption() +
           components.capacity() + patch_factors.memory_consumption();
  }



#define STICKSLIP_INSTANTIATE(n_components, Number)                      \
  template class BlockGaussSeidel<n_components, Number>;                 \
  template void BlockGaussSeidel<n_components, Number>::set_row<double>( \
    const unsigned int, const BlockMatrix<n_components, double> &);

  STICKSLIP_INSTANTIATE(1, float)
  STICKSLIP_INSTANTIATE(2, float)
  STICKSLIP_INSTANTIATE(1, double)
  STICKSLIP_INSTANTIATE(2, double)
  STICKSLIP_INSTANTIATE(3, float)
  STICKSLIP_INSTANTIATE(3, double)
#undef STICKSLIP_INSTANTIATE

  template void
  BlockGaussSeidel<1, float>::set_row(const unsigned int,
                                      const BlockMatrix<1, float> &);
  template void
  BlockGaussSeidel<2, float>::set_row(const unsigned int,
                                      const BlockMatrix<2, float> &);
  template void
  BlockGaussSeidel<3, float>::set_row(const unsigned int,
                                      const BlockMatrix<3, float> &);
} // namespace StickSlip
