// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/middle_nodes.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** Return if a row of the prolongation is that of a node in the middle of a
     * coarse cell, whose weights are a quarter. Beside a fault there are those
     * of its other side as well. */
    bool
    is_middle(const TransferMatrix::Compressed &P, const unsigned int i)
    {
      unsigned int n = 0;
      for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
        n += std::abs(P.value[k] - 0.25) < 0.03;
      return n >= 3;
    }



    /** The entry of T = R^T P Q in row i, at a position of P. */
    template <int n_components>
    Tensor<2, n_components>
    transfer_block(const TransferMatrix &transfer,
                   const unsigned int    i,
                   const unsigned int    position)
    {
      const TransferMatrix::Compressed &P = transfer.matrix();
      const double                     *R = transfer.row_frames().find(i);
      const double *Q = transfer.column_frames().find(P.column[position]);
      Tensor<2, n_components> result;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          if (R != nullptr && Q != nullptr)
            for (unsigned int e = 0; e < n_components; ++e)
              result[c][d] += R[e * n_components + c] * Q[e * n_components + d];
          else if (R != nullptr)
            result[c][d] = R[d * n_components + c];
          else if (Q != nullptr)
            result[c][d] = Q[c * n_components + d];
          else
            result[c][d] = (c == d ? 1. : 0.);
      return P.value[position] * result;
    }
  } // namespace



  template <int n_components>
  template <typename Matrix>
  typename MiddleNodes<n_components>::BlockRow
  MiddleNodes<n_components>::product_row(const TransferMatrix &transfer,
                                         const Matrix         &matrix,
                                         const NodeMask       &mask,
                                         const unsigned int    i)
  {
    const TransferMatrix::Compressed &P        = transfer.matrix();
    const BlockSparsity              &sparsity = matrix.sparsity();
    std::map<unsigned int, Block>     row;
    for (unsigned int m = sparsity.row_start[i]; m < sparsity.row_start[i + 1];
         ++m)
      {
        const unsigned int j    = sparsity.column[m];
        Block              A_ij = matrix.entry(i, m);
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            if (!mask.is_active(j, d))
              A_ij[c][d] = 0.;
        for (unsigned int k = P.row_start[j]; k < P.row_start[j + 1]; ++k)
          row[P.column[k]] +=
            A_ij * transfer_block<n_components>(transfer, j, k);
      }
    return {row.begin(), row.end()};
  }



  template <int n_components>
  template <typename Matrix>
  MiddleNodes<n_components>::MiddleNodes(
    const TransferMatrix            &transfer,
    const NodePartition             &coarse_nodes,
    const BlockSparsity             &coarse_sparsity,
    const std::vector<Matrix>       &matrices,
    const StiffVolumes              &stiff_volumes,
    const NodeMask                  &fixed,
    const std::vector<unsigned int> &nonsmooth_nodes)
  {
    const TransferMatrix::Compressed &P        = transfer.matrix();
    const BlockSparsity              &sparsity = matrices.front().sparsity();
    // Nodes that are not middle nodes, or beside one.
    std::vector<bool> is_excluded(sparsity.n_rows(), false);
    for (const unsigned int i : nonsmooth_nodes)
      is_excluded[i] = true;
    std::vector<std::vector<unsigned int>> shares(coarse_nodes.n_local());
    std::vector<BlockRow>                  products;
    for (unsigned int i = 0; i < stiff_volumes.size(); ++i)
      {
        if (stiff_volumes[i] == numbers::invalid_unsigned_int ||
            is_excluded[i] || !fixed.is_fully_active(i) || !is_middle(P, i))
          continue;
        // Other processes do not know which nodes are excluded here.
        if (std::any_of(sparsity.column.begin() + sparsity.row_start[i],
                        sparsity.column.begin() + sparsity.row_start[i + 1],
                        [&](const unsigned int j) {
                          return j >= is_excluded.size() && is_middle(P, j);
                        }))
          continue;
        const Matrix &A       = matrices[stiff_volumes[i]];
        BlockRow      row     = product_row(transfer, A, fixed, i);
        const Block   inverse = invert(A.diagonal_block(i));
        for (const auto &[J, value] : row)
          {
            shares[J].push_back(nodes.size());
            const auto begin = P.column.begin() + P.row_start[i],
                       end   = P.column.begin() + P.row_start[i + 1];
            if (std::find(begin, end, J) != end)
              {
                column.push_back(J);
                block.push_back(-inverse * value);
              }
          }
        row_start.push_back(column.size());
        nodes.push_back(i);
        products.push_back(std::move(row));
        for (unsigned int m = sparsity.row_start[i];
             m < sparsity.row_start[i + 1];
             ++m)
          if (sparsity.column[m] < is_excluded.size())
            is_excluded[sparsity.column[m]] = true;
      }
    find_ghost_rows(coarse_nodes, coarse_sparsity, products);
    first_share.push_back(0);
    for (const std::vector<unsigned int> &of_row : shares)
      {
        share.insert(share.end(), of_row.begin(), of_row.end());
        first_share.push_back(share.size());
      }
  }



  template <int n_components>
  void
  MiddleNodes<n_components>::find_ghost_rows(
    const NodePartition         &coarse_nodes,
    const BlockSparsity         &coarse_sparsity,
    const std::vector<BlockRow> &products)
  {
    const unsigned int                     n_owned = coarse_nodes.n_owned();
    std::vector<std::vector<unsigned int>> rows(coarse_nodes.n_local() -
                                                n_owned);
    const auto add = [&](const unsigned int I, const unsigned int J) {
      if (I >= n_owned)
        rows[I - n_owned].push_back(J);
    };
    for (unsigned int m = 0; m < nodes.size(); ++m)
      for (unsigned int k = row_start[m]; k < row_start[m + 1]; ++k)
        for (const auto &[J, value] : products[m])
          {
            add(column[k], J);
            add(J, column[k]);
          }
    for (std::vector<unsigned int> &row : rows)
      {
        make_set(row);
        ghost_sparsity.column.insert(ghost_sparsity.column.end(),
                                     row.begin(),
                                     row.end());
        ghost_sparsity.row_start.push_back(ghost_sparsity.column.size());
      }
    ghost_values.resize(std::size_t(ghost_sparsity.column.size()) *
                        n_components * n_components);
    is_exchanged = Utilities::MPI::max(int(!ghost_sparsity.column.empty()),
                                       coarse_nodes.communicator()) > 0;
    if (is_exchanged)
      exchange = RowExchange(coarse_nodes,
                             coarse_sparsity,
                             ghost_sparsity,
                             std::vector<bool>(rows.size(), true));
  }



  template <int n_components>
  void
  MiddleNodes<n_components>::select_rows(const NodePartition &coarse_nodes,
                                         const BlockSparsity &coarse_sparsity,
                                         const std::vector<bool> &is_selected)
  {
    selected = is_selected;
    with_selected.clear();
    for (unsigned int I = 0; I + 1 < first_share.size(); ++I)
      if (selected[I])
        with_selected.insert(with_selected.end(),
                             share.begin() + first_share[I],
                             share.begin() + first_share[I + 1]);
    make_set(with_selected);
    if (is_exchanged)
      exchange_of_selected =
        RowExchange(coarse_nodes,
                    coarse_sparsity,
                    ghost_sparsity,
                    {selected.begin() + coarse_nodes.n_owned(),
                     selected.end()});
  }



  template <int n_components>
  template <typename Number>
  void
  MiddleNodes<n_components>::prolongate_add(
    NodeValues<Number>       &fine,
    const NodeValues<Number> &coarse) const
  {
    for (unsigned int m = 0; m < nodes.size(); ++m)
      {
        Number *x = fine.begin() + std::size_t(nodes[m]) * n_components;
        for (unsigned int k = row_start[m]; k < row_start[m + 1]; ++k)
          {
            const Number *y =
              coarse.begin() + std::size_t(column[k]) * n_components;
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                x[c] += Number(block[k][c][d]) * y[d];
          }
      }
  }



  template <int n_components>
  template <typename Number>
  void
  MiddleNodes<n_components>::restrict_add(NodeValues<Number>       &coarse,
                                          const NodeValues<Number> &fine) const
  {
    for (unsigned int m = 0; m < nodes.size(); ++m)
      {
        const Number *x = fine.begin() + std::size_t(nodes[m]) * n_components;
        for (unsigned int k = row_start[m]; k < row_start[m + 1]; ++k)
          {
            Number *y = coarse.begin() + std::size_t(column[k]) * n_components;
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                y[d] += Number(block[k][c][d]) * x[c];
          }
      }
    if (is_exchanged)
      add_ghosts_to_owners(coarse);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  MiddleNodes<n_components>::add_share(
    const unsigned int                       k,
    const TransferMatrix                    &transfer,
    const FineMatrix                        &fine,
    const NodeMask                          &mask,
    const std::vector<bool>                 &is_selected,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    // With the row R = (A T)_m: C^T R + R^T C + C^T A_mm C.
    const unsigned int   m        = nodes[k];
    const BlockRow       row      = product_row(transfer, fine, mask, m);
    const Block          A_mm     = fine.diagonal_block(m);
    const BlockSparsity &sparsity = coarse.sparsity();
    const auto           add =
      [&](const unsigned int I, const unsigned int J, const Block &value) {
        const auto add_to = [&](auto *target) {
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              target[c * n_components + d] += value[c][d];
        };
        if (I < sparsity.n_rows())
          {
            add_to(coarse.block(sparsity.position(I, J)));
            return;
          }
        const unsigned int ghost = I - sparsity.n_rows();
        const auto         begin = ghost_sparsity.column.begin();
        const auto         found =
          std::lower_bound(begin + ghost_sparsity.row_start[ghost],
                           begin + ghost_sparsity.row_start[ghost + 1],
                           J);
        add_to(ghost_values.data() +
               std::size_t(found - begin) * n_components * n_components);
      };
    const auto is_wanted = [&](const unsigned int I) {
      return is_selected.empty() || is_selected[I];
    };
    for (unsigned int a = row_start[k]; a < row_start[k + 1]; ++a)
      {
        const unsigned int I   = column[a];
        const Block        C_t = transpose(block[a]);
        for (const auto &[J, value] : row)
          {
            const Block product = C_t * value;
            if (is_wanted(I))
              add(I, J, product);
            if (is_wanted(J))
              add(J, I, transpose(product));
          }
        if (is_wanted(I))
          for (unsigned int b = row_start[k]; b < row_start[k + 1]; ++b)
            add(I, column[b], C_t * A_mm * block[b]);
      }
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  MiddleNodes<n_components>::add_to_product(
    const TransferMatrix                    &transfer,
    const FineMatrix                        &fine,
    const NodeMask                          &mask,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    ghost_values.fill(0.);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      add_share(k, transfer, fine, mask, {}, coarse);
    exchange.add_to_owners(ghost_values,
                           coarse.values(),
                           n_components * n_components);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  MiddleNodes<n_components>::add_to_selected_rows(
    const TransferMatrix                    &transfer,
    const FineMatrix                        &fine,
    const NodeMask                          &mask,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    ghost_values.fill(0.);
    for (const unsigned int k : with_selected)
      add_share(k, transfer, fine, mask, selected, coarse);
    exchange_of_selected.add_to_owners(ghost_values,
                                       coarse.values(),
                                       n_components * n_components);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  MiddleNodes<n_components>::add_to_rows(
    const TransferMatrix                    &transfer,
    const FineMatrix                        &fine,
    const NodeMask                          &mask,
    const std::vector<unsigned int>         &rows,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    if (nodes.empty())
      return;
    std::vector<bool>         is_selected(coarse.n_rows(), false);
    std::vector<unsigned int> its_shares;
    for (const unsigned int I : rows)
      {
        is_selected[I] = true;
        its_shares.insert(its_shares.end(),
                          share.begin() + first_share[I],
                          share.begin() + first_share[I + 1]);
      }
    make_set(its_shares);
    for (const unsigned int k : its_shares)
      add_share(k, transfer, fine, mask, is_selected, coarse);
  }



  template <int n_components>
  std::size_t
  MiddleNodes<n_components>::memory_consumption() const
  {
    return sizeof(unsigned int) *
             (nodes.capacity() + row_start.capacity() + column.capacity() +
              first_share.capacity() + share.capacity() +
              with_selected.capacity()) +
           sizeof(Block) * block.capacity() +
           sizeof(double) * ghost_values.capacity() +
           ghost_sparsity.memory_consumption();
  }



#define STICKSLIP_INSTANTIATE_NUMBER(n_components, Number)         \
  template void MiddleNodes<n_components>::prolongate_add<Number>( \
    NodeValues<Number> &, const NodeValues<Number> &) const;       \
  template void MiddleNodes<n_components>::restrict_add<Number>(   \
    NodeValues<Number> &, const NodeValues<Number> &) const;

#define STICKSLIP_INSTANTIATE_TERMS(n_components, ...) \
  template MiddleNodes<n_components>::MiddleNodes(     \
    const TransferMatrix &,                            \
    const NodePartition &,                             \
    const BlockSparsity &,                             \
    const std::vector<__VA_ARGS__> &,                  \
    const StiffVolumes &,                              \
    const NodeMask &,                                  \
    const std::vector<unsigned int> &);

#define STICKSLIP_INSTANTIATE_PRODUCT(n_components, CoarseNumber, ...) \
  template void MiddleNodes<n_components>::add_to_product(             \
    const TransferMatrix &,                                            \
    const __VA_ARGS__ &,                                               \
    const NodeMask &,                                                  \
    BlockMatrix<n_components, CoarseNumber> &);

#define STICKSLIP_INSTANTIATE_ROWS(n_components, CoarseNumber, ...) \
  template void MiddleNodes<n_components>::add_to_rows(             \
    const TransferMatrix &,                                         \
    const __VA_ARGS__ &,                                            \
    const NodeMask &,                                               \
    const std::vector<unsigned int> &,                              \
    BlockMatrix<n_components, CoarseNumber> &);                     \
  template void MiddleNodes<n_components>::add_to_selected_rows(    \
    const TransferMatrix &,                                         \
    const __VA_ARGS__ &,                                            \
    const NodeMask &,                                               \
    BlockMatrix<n_components, CoarseNumber> &);

#define STICKSLIP_INSTANTIATE(n)                                   \
  template class MiddleNodes<n>;                                   \
  STICKSLIP_INSTANTIATE_NUMBER(n, double)                          \
  STICKSLIP_INSTANTIATE_NUMBER(n, float)                           \
  STICKSLIP_INSTANTIATE_TERMS(n, BlockMatrix<n, double>)           \
  STICKSLIP_INSTANTIATE_TERMS(n, BlockMatrix<n, float>)            \
  STICKSLIP_INSTANTIATE_TERMS(n, TermMatrix<n>)                    \
  STICKSLIP_INSTANTIATE_PRODUCT(n, double, BlockMatrix<n, double>) \
  STICKSLIP_INSTANTIATE_PRODUCT(n, float, BlockMatrix<n, float>)   \
  STICKSLIP_INSTANTIATE_PRODUCT(n, double, TermMatrix<n>)          \
  STICKSLIP_INSTANTIATE_PRODUCT(n, float, TermMatrix<n>)           \
  STICKSLIP_INSTANTIATE_ROWS(n, double, BlockMatrix<n, double>)    \
  STICKSLIP_INSTANTIATE_ROWS(n, float, BlockMatrix<n, double>)     \
  STICKSLIP_INSTANTIATE_ROWS(n, float, BlockMatrix<n, float>)

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
