// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

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
    const unsigned int               n_coarse,
    const std::vector<Matrix>       &matrices,
    const StiffVolumes              &stiff_volumes,
    const NodeMask                  &fixed,
    const std::vector<unsigned int> &nonsmooth_nodes)
  {
    const TransferMatrix::Compressed &P        = transfer.matrix();
    const BlockSparsity              &sparsity = matrices.front().sparsity();
    // Nodes that are not middle nodes, or beside one.
    std::vector<bool> is_excluded(stiff_volumes.size(), false);
    for (const unsigned int i : nonsmooth_nodes)
      is_excluded[i] = true;
    std::vector<std::vector<unsigned int>> shares(n_coarse);
    for (unsigned int i = 0; i < stiff_volumes.size(); ++i)
      {
        if (stiff_volumes[i] == numbers::invalid_unsigned_int ||
            is_excluded[i] || !fixed.is_fully_active(i) || !is_middle(P, i))
          continue;
        bool is_local = true;
        for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
          is_local &= P.column[k] < n_coarse;
        for (unsigned int m = sparsity.row_start[i];
             m < sparsity.row_start[i + 1];
             ++m)
          is_local &= sparsity.column[m] < is_excluded.size();
        if (!is_local)
          continue;
        const Matrix  &A   = matrices[stiff_volumes[i]];
        const BlockRow row = product_row(transfer, A, fixed, i);
        if (row.back().first >= n_coarse)
          continue;
        const Block inverse = invert(A.diagonal_block(i));
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
        for (unsigned int m = sparsity.row_start[i];
             m < sparsity.row_start[i + 1];
             ++m)
          is_excluded[sparsity.column[m]] = true;
      }
    if (nodes.empty())
      return;
    first_share.push_back(0);
    for (const std::vector<unsigned int> &of_row : shares)
      {
        share.insert(share.end(), of_row.begin(), of_row.end());
        first_share.push_back(share.size());
      }
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
    BlockMatrix<n_components, CoarseNumber> &coarse) const
  {
    // With the row R = (A T)_m: C^T R + R^T C + C^T A_mm C.
    const unsigned int   m        = nodes[k];
    const BlockRow       row      = product_row(transfer, fine, mask, m);
    const Block          A_mm     = fine.diagonal_block(m);
    const BlockSparsity &sparsity = coarse.sparsity();
    const auto           add =
      [&](const unsigned int I, const unsigned int J, const Block &value) {
        CoarseNumber *target = coarse.block(sparsity.position(I, J));
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            target[c * n_components + d] += value[c][d];
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
    BlockMatrix<n_components, CoarseNumber> &coarse) const
  {
    for (unsigned int k = 0; k < nodes.size(); ++k)
      add_share(k, transfer, fine, mask, {}, coarse);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  MiddleNodes<n_components>::add_to_rows(
    const TransferMatrix                    &transfer,
    const FineMatrix                        &fine,
    const NodeMask                          &mask,
    const std::vector<unsigned int>         &rows,
    BlockMatrix<n_components, CoarseNumber> &coarse) const
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
              first_share.capacity() + share.capacity()) +
           sizeof(Block) * block.capacity();
  }



#define STICKSLIP_INSTANTIATE_NUMBER(n_components, Number)         \
  template void MiddleNodes<n_components>::prolongate_add<Number>( \
    NodeValues<Number> &, const NodeValues<Number> &) const;       \
  template void MiddleNodes<n_components>::restrict_add<Number>(   \
    NodeValues<Number> &, const NodeValues<Number> &) const;

#define STICKSLIP_INSTANTIATE_TERMS(n_components, ...) \
  template MiddleNodes<n_components>::MiddleNodes(     \
    const TransferMatrix &,                            \
    const unsigned int,                                \
    const std::vector<__VA_ARGS__> &,                  \
    const StiffVolumes &,                              \
    const NodeMask &,                                  \
    const std::vector<unsigned int> &);

#define STICKSLIP_INSTANTIATE_PRODUCT(n_components, CoarseNumber, ...) \
  template void MiddleNodes<n_components>::add_to_product(             \
    const TransferMatrix &,                                            \
    const __VA_ARGS__ &,                                               \
    const NodeMask &,                                                  \
    BlockMatrix<n_components, CoarseNumber> &) const;

#define STICKSLIP_INSTANTIATE_ROWS(n_components, CoarseNumber, ...) \
  template void MiddleNodes<n_components>::add_to_rows(             \
    const TransferMatrix &,                                         \
    const __VA_ARGS__ &,                                            \
    const NodeMask &,                                               \
    const std::vector<unsigned int> &,                              \
    BlockMatrix<n_components, CoarseNumber> &) const;

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
