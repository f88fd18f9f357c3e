// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>

#include <stickslip/base/make_set.h>
#include <stickslip/problem/rotation_coupling.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    template <int n_components>
    Tensor<2, n_components>
    block(const BlockMatrix<n_components> &matrix, const unsigned int position)
    {
      Tensor<2, n_components> result;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          result[c][d] = matrix.block(position)[c * n_components + d];
      return result;
    }



    template <int n_components>
    void
    subtract(const Tensor<2, n_components> &value, double *block)
    {
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          block[c * n_components + d] -= value[c][d];
    }



    /** The position of an entry that must be there, in any build. */
    unsigned int
    position(const BlockSparsity &sparsity,
             const unsigned int   row,
             const unsigned int   column)
    {
      const auto begin = sparsity.column.begin() + sparsity.row_start[row];
      const auto end   = sparsity.column.begin() + sparsity.row_start[row + 1];
      const auto entry = std::lower_bound(begin, end, column);
      AssertThrow(entry != end && *entry == column, ExcInternalError());
      return entry - sparsity.column.begin();
    }



    template <int n_components>
    Tensor<1, n_components>
    value(const NodalVector &vector, const unsigned int node)
    {
      Tensor<1, n_components> result;
      for (unsigned int d = 0; d < n_components; ++d)
        result[d] = vector.begin()[node * n_components + d];
      return result;
    }



    template <int n_components>
    void
    add_value(const Tensor<1, n_components> &value,
              const unsigned int             node,
              NodalVector                   &vector)
    {
      for (unsigned int d = 0; d < n_components; ++d)
        vector.begin()[node * n_components + d] += value[d];
    }
  } // namespace



  template <int dim, int n_components>
  RotationCoupling<dim, n_components>::RotationCoupling(
    const JumpBasis<dim>           &basis,
    const NodeFrames<n_components> &frames,
    const NodePartition            &nodes,
    const BlockSparsity            &sparsity)
    : n_owned(nodes.n_owned())
  {
    // Rotations move nothing out of the plane.
    if (n_components < dim)
      return;
    // Every process has the coupling of all faults.
    Tensor<2, n_components> unit_matrix;
    for (unsigned int c = 0; c < n_components; ++c)
      unit_matrix[c][c] = 1.;
    const auto axes_of = [&](const types::global_dof_index node) {
      const Tensor<2, n_components> *axes = frames.find(node);
      return axes != nullptr ? *axes : unit_matrix;
    };
    for (const auto p : basis.contact_nodes())
      {
        const auto term = basis.rotation_term(p);
        is_needed       = is_needed || !term.empty();
        if (term.empty() || !nodes.is_local(p))
          continue;
        const double averaging_factor = basis.to_jumps(p).front().second;
        Row         &row              = rows[nodes.local_index(p)];
        if constexpr (n_components == dim)
          for (const auto &[q, matrix] : term)
            // Masters of a ghost are columns of the owned rows that it is in.
            if (nodes.is_local(q))
              row.emplace_back(nodes.local_index(q),
                               averaging_factor * transpose(axes_of(p)) *
                                 matrix * axes_of(q));
      }
    if (!is_needed)
      return;

    std::vector<std::vector<unsigned int>> columns(nodes.n_local() - n_owned);
    for (const auto &[p, row] : rows)
      if (p < n_owned)
        for (const auto &entry : row)
          if (entry.first >= n_owned)
            columns[entry.first - n_owned].insert(
              columns[entry.first - n_owned].end(),
              sparsity.column.begin() + sparsity.row_start[p],
              sparsity.column.begin() + sparsity.row_start[p + 1]);
    for (std::vector<unsigned int> &row : columns)
      {
        make_set(row);
        ghost_rows.column.insert(ghost_rows.column.end(),
                                 row.begin(),
                                 row.end());
        ghost_rows.row_start.push_back(ghost_rows.column.size());
      }
    exchange = RowExchange(nodes,
                           sparsity,
                           ghost_rows,
                           std::vector<bool>(columns.size(), true));
  }



  template <int dim, int n_components>
  void
  RotationCoupling<dim, n_components>::add(const double factor,
                                           NodalVector &w) const
  {
    if (empty())
      return;
    update_ghosts(w);
    for (const auto &[p, row] : rows)
      if (p < n_owned)
        for (const auto &[q, matrix] : row)
          add_value<n_components>(factor * (matrix * value<n_components>(w, q)),
                                  p,
                                  w);
  }



  template <int dim, int n_components>
  void
  RotationCoupling<dim, n_components>::add_transpose(const double factor,
                                                     NodalVector &f) const
  {
    if (empty())
      return;
    f.zero_out_ghost_values();
    for (const auto &[p, row] : rows)
      if (p < n_owned)
        for (const auto &[q, matrix] : row)
          add_value<n_components>(
            factor * (transpose(matrix) * value<n_components>(f, p)), q, f);
    add_ghosts_to_owners(f);
  }



  template <int dim, int n_components>
  void
  RotationCoupling<dim, n_components>::transform(
    BlockMatrix<n_components> &A) const
  {
    if (empty())
      return;
    // First A (1 - K), then (1 - K)^T times that.
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < n_owned; ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        if (const auto row = rows.find(sparsity.column[k]); row != rows.end())
          {
            const Tensor<2, n_components> A_ip = block(A, k);
            for (const auto &[q, matrix] : row->second)
              subtract(A_ip * matrix, A.block(position(sparsity, i, q)));
          }

    AlignedVector<double> ghost_values(ghost_rows.column.size() * n_components *
                                       n_components);
    for (const auto &[p, row] : rows)
      if (p < n_owned)
        for (const auto &[q, matrix] : row)
          for (unsigned int k = sparsity.row_start[p];
               k < sparsity.row_start[p + 1];
               ++k)
            {
              const unsigned int j = sparsity.column[k];
              double *const      target =
                q < n_owned ?
                       A.block(position(sparsity, q, j)) :
                       ghost_values.data() + n_components * n_components *
                                          position(ghost_rows, q - n_owned, j);
              subtract(transpose(matrix) * block(A, k), target);
            }
    exchange.add_to_owners(ghost_values,
                           A.values(),
                           n_components * n_components);
  }



  template class RotationCoupling<2>;
  template class RotationCoupling<3>;
  template class RotationCoupling<2, 1>;
} // namespace StickSlip
