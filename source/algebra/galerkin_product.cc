// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/galerkin_product.h>
#include <stickslip/algebra/index_set.h>
#include <stickslip/algebra/turned_blocks.h>
#include <stickslip/base/make_set.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace StickSlip
{
  namespace
  {
    /**
     * The sparsity of P^T A P as far as this process contributes: a list of
     * columns for each row.
     */
    std::vector<std::vector<unsigned int>>
    symbolic_product(const BlockSparsity &A, const TransferMatrix &transfer)
    {
      const auto &P  = transfer.matrix();
      const auto &Pt = transfer.transpose();

      std::vector<std::vector<unsigned int>> rows(transfer.n_columns());
      std::vector<unsigned int>              last_fine(transfer.n_rows(),
                                          numbers::invalid_unsigned_int);
      std::vector<unsigned int>              last_coarse(transfer.n_columns(),
                                            numbers::invalid_unsigned_int);
      for (unsigned int I = 0; I < rows.size(); ++I)
        for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
          {
            const unsigned int i = Pt.column[k];
            for (unsigned int m = A.row_start[i]; m < A.row_start[i + 1]; ++m)
              {
                const unsigned int j = A.column[m];
                if (last_fine[j] == I)
                  continue;
                last_fine[j] = I;
                for (unsigned int q = P.row_start[j]; q < P.row_start[j + 1];
                     ++q)
                  if (last_coarse[P.column[q]] != I)
                    {
                      last_coarse[P.column[q]] = I;
                      rows[I].push_back(P.column[q]);
                    }
              }
          }
      return rows;
    }



    /**
     * The rows of ghost nodes as lists of global numbers, each after the
     * number of the node, sent to the owners; returns what is received.
     */
    std::vector<std::vector<types::global_dof_index>>
    send_to_owners(const NodePartition                          &nodes,
                   const std::vector<std::vector<unsigned int>> &rows)
    {
      using Rows = std::vector<std::vector<types::global_dof_index>>;
      std::map<unsigned int, Rows> to_send;
      unsigned int                 local = nodes.n_owned();
      for (const auto &[rank, n_ghosts] : nodes.nodes()->ghost_targets())
        for (const unsigned int end = local + n_ghosts; local < end; ++local)
          if (!rows[local].empty())
            {
              to_send[rank].push_back({nodes.global_index(local)});
              for (const unsigned int column : rows[local])
                to_send[rank].back().push_back(nodes.global_index(column));
            }
      Rows result;
      for (auto &[rank, received] :
           Utilities::MPI::some_to_some(nodes.communicator(), to_send))
        std::move(received.begin(), received.end(), std::back_inserter(result));
      return result;
    }
  } // namespace



  template <int n_components>
  GalerkinProduct<n_components>::GalerkinProduct(
    const NodePartition            &fine_nodes,
    const BlockSparsity            &fine,
    const std::vector<GlobalRow>   &prolongation,
    const IndexSet                 &owned_coarse,
    const LocalFrames              &fine_frames,
    const NodeFrames<n_components> &coarse_frames)
    : row_position(fine_nodes.n_local(), -1)
  {
    AssertDimension(prolongation.size(), fine_nodes.n_local());
    const MPI_Comm communicator = fine_nodes.communicator();
    std::vector<types::global_dof_index> ghosts;
    for (const GlobalRow &row : prolongation)
      for (const auto &entry : row)
        if (!owned_coarse.is_element(entry.first))
          ghosts.push_back(entry.first);
    const auto set_coarse_nodes = [&]() {
      nodes    = NodePartition(owned_coarse,
                            make_index_set(owned_coarse.size(), ghosts),
                            n_components,
                            communicator);
      transfer = TransferMatrix(prolongation,
                                fine_nodes,
                                nodes,
                                fine_frames,
                                coarse_frames.local_part(nodes));
    };
    set_coarse_nodes();
    std::vector<std::vector<unsigned int>> rows =
      symbolic_product(fine, transfer);

    // Other processes may contribute columns that are not known here.
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      {
        const auto received = send_to_owners(nodes, rows);
        for (const auto &row : received)
          for (const types::global_dof_index column : row)
            if (!owned_coarse.is_element(column))
              ghosts.push_back(column);
        const NodePartition provisional = nodes;
        set_coarse_nodes();
        std::vector<std::vector<unsigned int>> renumbered(nodes.n_local());
        for (unsigned int I = 0; I < rows.size(); ++I)
          for (const unsigned int J : rows[I])
            renumbered[nodes.local_index(provisional.global_index(I))]
              .push_back(nodes.local_index(provisional.global_index(J)));
        for (const auto &row : received)
          for (unsigned int k = 1; k < row.size(); ++k)
            renumbered[nodes.local_index(row[0])].push_back(
              nodes.local_index(row[k]));
        rows = std::move(renumbered);
      }

    for (unsigned int I = nodes.n_owned(); I < rows.size(); ++I)
      {
        ghost_sparsity.column.insert(ghost_sparsity.column.end(),
                                     rows[I].begin(),
                                     rows[I].end());
        ghost_sparsity.row_start.push_back(ghost_sparsity.column.size());
      }
    ghost_values.resize(std::size_t(ghost_sparsity.column.size()) *
                        n_components * n_components);
    rows.resize(nodes.n_owned());
    sparsity = std::make_shared<const BlockSparsity>(std::move(rows));
    coarse_position.resize(nodes.n_local());
    all = make_rows(std::vector<bool>(nodes.n_local(), true));
  }



  template <int n_components>
  typename GalerkinProduct<n_components>::Rows
  GalerkinProduct<n_components>::make_rows(
    const std::vector<bool> &is_selected) const
  {
    AssertDimension(is_selected.size(), nodes.n_local());
    Rows rows;
    for (unsigned int I = 0; I < nodes.n_owned(); ++I)
      if (is_selected[I])
        rows.owned.push_back(I);
    for (unsigned int I = nodes.n_owned(); I < nodes.n_local(); ++I)
      if (is_selected[I])
        rows.ghosts.push_back(I);
    rows.exchange =
      RowExchange(nodes,
                  *sparsity,
                  ghost_sparsity,
                  {is_selected.begin() + nodes.n_owned(), is_selected.end()});
    return rows;
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  GalerkinProduct<n_components>::compute(
    const FineMatrix                        &fine,
    const NodeMask                          &fine_mask,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    compute(fine, fine_mask, all, coarse);
  }



  template <int n_components>
  void
  GalerkinProduct<n_components>::select_rows(
    const std::vector<bool> &is_selected)
  {
    selected = make_rows(is_selected);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  GalerkinProduct<n_components>::compute_selected_rows(
    const FineMatrix                        &fine,
    const NodeMask                          &fine_mask,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    compute(fine, fine_mask, selected, coarse);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  GalerkinProduct<n_components>::compute(
    const FineMatrix                        &fine,
    const NodeMask                          &fine_mask,
    const Rows                              &rows,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    for (const unsigned int I : rows.owned)
      compute_row(fine, fine_mask, I, *sparsity, I, coarse.values().data());
    for (const unsigned int I : rows.ghosts)
      compute_row(fine,
                  fine_mask,
                  I,
                  ghost_sparsity,
                  I - nodes.n_owned(),
                  ghost_values.data());
    rows.exchange.add_to_owners(ghost_values,
                                coarse.values(),
                                n_components * n_components);
  }



  template <int n_components>
  std::vector<unsigned int>
  GalerkinProduct<n_components>::rows_from(
    const std::vector<unsigned int> &fine_rows) const
  {
    const auto &P = transfer.matrix();
    return columns_of_rows(P.row_start, P.column, fine_rows);
  }



  template <int n_components>
  template <typename FineMatrix, typename CoarseNumber>
  void
  GalerkinProduct<n_components>::compute_rows(
    const FineMatrix                        &fine,
    const NodeMask                          &fine_mask,
    const std::vector<unsigned int>         &coarse_rows,
    BlockMatrix<n_components, CoarseNumber> &coarse)
  {
    AssertDimension(Utilities::MPI::n_mpi_processes(nodes.communicator()), 1);
    for (const unsigned int I : coarse_rows)
      compute_row(fine, fine_mask, I, *sparsity, I, coarse.values().data());
  }



  template <int n_components>
  std::size_t
  GalerkinProduct<n_components>::memory_consumption() const
  {
    return transfer.memory_consumption() + ghost_sparsity.memory_consumption() +
           sizeof(double) * ghost_values.size();
  }



  template <int n_components>
  template <typename FineMatrix, typename TargetNumber>
  void
  GalerkinProduct<n_components>::compute_row(const FineMatrix    &fine,
                                             const NodeMask      &fine_mask,
                                             const unsigned int   row,
                                             const BlockSparsity &target,
                                             const unsigned int   target_row,
                                             TargetNumber        *values)
  {
    if (transfer.row_frames().empty() && transfer.column_frames().empty())
      compute_row_with<false>(fine, fine_mask, row, target, target_row, values);
    else
      compute_row_with<true>(fine, fine_mask, row, target, target_row, values);
  }



  template <int n_components>
  template <bool with_frames, typename FineMatrix, typename TargetNumber>
  void
  GalerkinProduct<n_components>::compute_row_with(const FineMatrix  &fine,
                                                  const NodeMask    &fine_mask,
                                                  const unsigned int I,
                                                  const BlockSparsity &target,
                                                  const unsigned int target_row,
                                                  TargetNumber      *values)
  {
    constexpr unsigned int n  = n_components * n_components;
    const auto            &P  = transfer.matrix();
    const auto            &Pt = transfer.transpose();
    const BlockSparsity   &A  = fine.sparsity();

    // The row P_I^T A over fine columns ...
    unsigned int n_fine_columns = 0;
    for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
      n_fine_columns +=
        A.row_start[Pt.column[k] + 1] - A.row_start[Pt.column[k]];
    if (row_values.size() < std::size_t(n_fine_columns) * n)
      {
        row_values.resize(std::size_t(n_fine_columns) * n);
        row_columns.resize(n_fine_columns);
      }
    unsigned int *columns  = row_columns.data();
    int          *position = row_position.data();
    double       *sums     = row_values.data();
    n_fine_columns         = 0;
    for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
      {
        const unsigned int i = Pt.column[k];
        if constexpr (with_frames)
          if (const double *axes = transfer.row_frames().find(i))
            {
              // Masked rows of R S A, in the axes of space.
              double weight[n];
              for (unsigned int c = 0; c < n_components; ++c)
                for (unsigned int d = 0; d < n_components; ++d)
                  weight[c * n_components + d] =
                    fine_mask.is_active(i, d) ?
                      Pt.value[k] * axes[c * n_components + d] :
                      0.;
              auto block = fine.row(i, fine_blocks);
              for (unsigned int m = A.row_start[i]; m < A.row_start[i + 1];
                   ++m, block += n)
                {
                  const unsigned int j = A.column[m];
                  if (position[j] < 0)
                    {
                      position[j]             = n_fine_columns;
                      columns[n_fine_columns] = j;
                      std::fill_n(sums + std::size_t(n_fine_columns) * n,
                                  n,
                                  0.);
                      ++n_fine_columns;
                    }
                  add_product<n_components>(
                    weight, block, sums + std::size_t(position[j]) * n);
                }
              continue;
            }
        double weight[n];
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            weight[c * n_components + d] =
              fine_mask.is_active(i, c) ? Pt.value[k] : 0.;
        auto block = fine.row(i, fine_blocks);
        for (unsigned int m = A.row_start[i]; m < A.row_start[i + 1];
             ++m, block += n)
          {
            const unsigned int j = A.column[m];
            if (position[j] < 0)
              {
                double *sum = sums + std::size_t(n_fine_columns) * n;
                position[j] = n_fine_columns;
                columns[n_fine_columns] = j;
                ++n_fine_columns;
                for (unsigned int c = 0; c < n; ++c)
                  sum[c] = weight[c] * block[c];
              }
            else
              {
                double *sum = sums + std::size_t(position[j]) * n;
                for (unsigned int c = 0; c < n; ++c)
                  sum[c] += weight[c] * block[c];
              }
          }
      }

    // ... times P.
    const unsigned int first = target.row_start[target_row];
    const unsigned int size  = target.row_start[target_row + 1] - first;
    coarse_values.assign(std::size_t(size) * n, 0.);
    for (unsigned int k = 0; k < size; ++k)
      coarse_position[target.column[first + k]] = k;
    double             *result = coarse_values.data();
    const unsigned int *place  = coarse_position.data();
    for (unsigned int m = 0; m < n_fine_columns; ++m)
      {
        const unsigned int j   = columns[m];
        double            *sum = sums + std::size_t(m) * n;
        position[j]            = -1;
        if (!fine_mask.is_fully_active(j))
          for (unsigned int d = 0; d < n_components; ++d)
            if (!fine_mask.is_active(j, d))
              for (unsigned int c = 0; c < n_components; ++c)
                sum[c * n_components + d] = 0.;
        if constexpr (with_frames)
          if (const double *axes = transfer.row_frames().find(j))
            turn_columns<n_components, /*to_space=*/true>(sum, axes);
        for (unsigned int q = P.row_start[j]; q < P.row_start[j + 1]; ++q)
          {
            double      *entry  = result + std::size_t(place[P.column[q]]) * n;
            const double weight = P.value[q];
            for (unsigned int c = 0; c < n; ++c)
              entry[c] += weight * sum[c];
          }
      }
    if constexpr (with_frames)
      {
        const LocalFrames &frames = transfer.column_frames();
        const double      *axes   = frames.find(I);
        for (unsigned int k = 0; k < size; ++k)
          {
            double *entry = result + std::size_t(k) * n;
            if (axes != nullptr)
              turn_rows<n_components>(entry, axes);
            if (const double *axes_J = frames.find(target.column[first + k]))
              turn_columns<n_components, /*to_space=*/false>(entry, axes_J);
          }
      }
    std::copy(coarse_values.begin(),
              coarse_values.end(),
              values + std::size_t(first) * n);
  }



#define STICKSLIP_INSTANTIATE_COMPUTE(n, CoarseNumber, ...)      \
  template void GalerkinProduct<n>::compute(const __VA_ARGS__ &, \
                                            const NodeMask &,    \
                                            BlockMatrix<n, CoarseNumber> &);

#define STICKSLIP_INSTANTIATE_ROWS(n, CoarseNumber, ...)                    \
  STICKSLIP_INSTANTIATE_COMPUTE(n, CoarseNumber, __VA_ARGS__)               \
  template void GalerkinProduct<n>::compute_selected_rows(                  \
    const __VA_ARGS__ &, const NodeMask &, BlockMatrix<n, CoarseNumber> &); \
  template void GalerkinProduct<n>::compute_rows(                           \
    const __VA_ARGS__ &,                                                    \
    const NodeMask &,                                                       \
    const std::vector<unsigned int> &,                                      \
    BlockMatrix<n, CoarseNumber> &);

#define STICKSLIP_INSTANTIATE(n)                                \
  template class GalerkinProduct<n>;                            \
  STICKSLIP_INSTANTIATE_ROWS(n, double, BlockMatrix<n, double>) \
  STICKSLIP_INSTANTIATE_ROWS(n, float, BlockMatrix<n, double>)  \
  STICKSLIP_INSTANTIATE_ROWS(n, float, BlockMatrix<n, float>)   \
  STICKSLIP_INSTANTIATE_COMPUTE(n, double, TermMatrix<n>)       \
  STICKSLIP_INSTANTIATE_COMPUTE(n, float, TermMatrix<n>)

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
