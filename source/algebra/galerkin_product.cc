// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/galerkin_product.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  GalerkinProduct<dim>::GalerkinProduct(const TransferMatrix &transfer,
                                        const BlockSparsity  &fine)
    : transfer(&transfer)
    , row_position(fine.n_rows(), -1)
    , coarse_position(transfer.n_columns())
  {
    const auto &P  = transfer.matrix();
    const auto &Pt = transfer.transpose();

    std::vector<std::vector<unsigned int>> rows(transfer.n_columns());
    std::vector<unsigned int>              last_fine(fine.n_rows(),
                                        numbers::invalid_unsigned_int);
    std::vector<unsigned int>              last_coarse(transfer.n_columns(),
                                          numbers::invalid_unsigned_int);
    for (unsigned int I = 0; I < rows.size(); ++I)
      for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
        {
          const unsigned int i = Pt.column[k];
          for (unsigned int m = fine.row_start[i]; m < fine.row_start[i + 1];
               ++m)
            {
              const unsigned int j = fine.column[m];
              if (last_fine[j] == I)
                continue;
              last_fine[j] = I;
              for (unsigned int q = P.row_start[j]; q < P.row_start[j + 1]; ++q)
                if (last_coarse[P.column[q]] != I)
                  {
                    last_coarse[P.column[q]] = I;
                    rows[I].push_back(P.column[q]);
                  }
            }
        }
    sparsity = std::make_shared<const BlockSparsity>(std::move(rows));
  }



  template <int dim>
  const std::shared_ptr<const BlockSparsity> &
  GalerkinProduct<dim>::coarse_sparsity() const
  {
    return sparsity;
  }



  template <int dim>
  void
  GalerkinProduct<dim>::compute(const BlockMatrix<dim> &fine,
                                const NodeMask         &fine_mask,
                                BlockMatrix<dim>       &coarse)
  {
    for (unsigned int I = 0; I < sparsity->n_rows(); ++I)
      compute_row(fine, fine_mask, I, coarse);
  }



  template <int dim>
  void
  GalerkinProduct<dim>::compute_rows(
    const BlockMatrix<dim>          &fine,
    const NodeMask                  &fine_mask,
    const std::vector<unsigned int> &coarse_rows,
    BlockMatrix<dim>                &coarse)
  {
    for (const unsigned int I : coarse_rows)
      compute_row(fine, fine_mask, I, coarse);
  }



  template <int dim>
  void
  GalerkinProduct<dim>::compute_row(const BlockMatrix<dim> &fine,
                                    const NodeMask         &fine_mask,
                                    const unsigned int      I,
                                    BlockMatrix<dim>       &coarse)
  {
    constexpr unsigned int n  = dim * dim;
    const auto            &P  = transfer->matrix();
    const auto            &Pt = transfer->transpose();
    const BlockSparsity   &A  = fine.sparsity();

    // The row P_I^T A over fine columns ...
    row_columns.clear();
    row_values.clear();
    for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
      {
        const unsigned int i = Pt.column[k];
        double             weight[dim];
        for (unsigned int c = 0; c < dim; ++c)
          weight[c] = fine_mask.is_active(i, c) ? Pt.value[k] : 0.;
        for (unsigned int m = A.row_start[i]; m < A.row_start[i + 1]; ++m)
          {
            const unsigned int j = A.column[m];
            if (row_position[j] < 0)
              {
                row_position[j] = row_columns.size();
                row_columns.push_back(j);
                row_values.resize(row_values.size() + n, 0.);
              }
            double       *sum   = &row_values[row_position[j] * n];
            const double *block = fine.block(m);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                sum[c * dim + d] += weight[c] * block[c * dim + d];
          }
      }

    // ... times P.
    for (unsigned int K = sparsity->row_start[I];
         K < sparsity->row_start[I + 1];
         ++K)
      {
        coarse_position[sparsity->column[K]] = K;
        std::fill_n(coarse.block(K), n, 0.);
      }
    for (unsigned int m = 0; m < row_columns.size(); ++m)
      {
        const unsigned int j   = row_columns[m];
        double            *sum = &row_values[m * n];
        row_position[j]        = -1;
        if (!fine_mask.is_fully_active(j))
          for (unsigned int d = 0; d < dim; ++d)
            if (!fine_mask.is_active(j, d))
              for (unsigned int c = 0; c < dim; ++c)
                sum[c * dim + d] = 0.;
        for (unsigned int q = P.row_start[j]; q < P.row_start[j + 1]; ++q)
          {
            double *entry = coarse.block(coarse_position[P.column[q]]);
            for (unsigned int c = 0; c < n; ++c)
              entry[c] += P.value[q] * sum[c];
          }
      }
  }



  template class GalerkinProduct<2>;
  template class GalerkinProduct<3>;
} // namespace StickSlip
