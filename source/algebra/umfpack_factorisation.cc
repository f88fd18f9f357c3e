// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/algebra/masked_entries.h>
#include <stickslip/algebra/umfpack_factorisation.h>
#include <umfpack.h>

namespace StickSlip
{
  template <int n_components>
  struct UmfpackFactorisation<n_components>::Implementation
  {
    /** Whose sparsity the arrays have; kept alive, so that its address stays
     * its own. */
    std::shared_ptr<const BlockSparsity> source;
    std::vector<int>                     row_start, column;
    std::vector<double>                  value;
    std::vector<double>                  control;
    void                                *symbolic = nullptr;
    void                                *numeric  = nullptr;

    Implementation()
      : control(UMFPACK_CONTROL)
    {
      umfpack_di_defaults(control.data());
      control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
      control[UMFPACK_IRSTEP]   = 0;
    }

    ~Implementation()
    {
      clear_numeric();
      clear_symbolic();
    }

    void
    clear_numeric()
    {
      if (numeric != nullptr)
        umfpack_di_free_numeric(&numeric);
    }

    void
    clear_symbolic()
    {
      if (symbolic != nullptr)
        umfpack_di_free_symbolic(&symbolic);
    }

    void
    set_sparsity(const std::shared_ptr<const BlockSparsity> &sparsity)
    {
      source = sparsity;
      row_start.assign(1, 0);
      column.clear();
      for (unsigned int i = 0; i < source->n_rows(); ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          {
            for (unsigned int k = source->row_start[i];
                 k < source->row_start[i + 1];
                 ++k)
              for (unsigned int d = 0; d < n_components; ++d)
                column.push_back(source->column[k] * n_components + d);
            row_start.push_back(column.size());
          }
      value.resize(column.size());
    }
  };



  template <int n_components>
  UmfpackFactorisation<n_components>::UmfpackFactorisation()
    : implementation(std::make_unique<Implementation>())
  {}



  template <int n_components>
  UmfpackFactorisation<n_components>::~UmfpackFactorisation() = default;



  template <int n_components>
  void
  UmfpackFactorisation<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    Implementation &data   = *implementation;
    const bool      is_new = (matrix.shared_sparsity() != data.source);
    data.clear_numeric();
    if (is_new)
      data.set_sparsity(matrix.shared_sparsity());
    // The matrix is symmetric, so rows may be given for columns.
    write_masked_entries(matrix, mask, data.value.data());
    const int n = data.row_start.size() - 1;
    if (is_new)
      {
        data.clear_symbolic();
        const int status = umfpack_di_symbolic(n,
                                               n,
                                               data.row_start.data(),
                                               data.column.data(),
                                               data.value.data(),
                                               &data.symbolic,
                                               data.control.data(),
                                               nullptr);
        if (status != UMFPACK_OK)
          data.source = nullptr;
        AssertThrow(status == UMFPACK_OK,
                    ExcMessage("UMFPACK cannot analyse a matrix: error " +
                               std::to_string(status) + "."));
      }
    const int status = umfpack_di_numeric(data.row_start.data(),
                                          data.column.data(),
                                          data.value.data(),
                                          data.symbolic,
                                          &data.numeric,
                                          data.control.data(),
                                          nullptr);
    AssertThrow(status != UMFPACK_ERROR_out_of_memory,
                ExcMessage("UMFPACK has not enough memory."));
    if (status != UMFPACK_OK)
      throw SingularMatrix("the linearised matrix");
  }



  template <int n_components>
  void
  UmfpackFactorisation<n_components>::solve(NodalVector       &x,
                                            const NodalVector &b)
  {
    const Implementation &data   = *implementation;
    const int             status = umfpack_di_solve(UMFPACK_A,
                                        data.row_start.data(),
                                        data.column.data(),
                                        data.value.data(),
                                        x.begin(),
                                        b.begin(),
                                        data.numeric,
                                        data.control.data(),
                                        nullptr);
    AssertThrow(status == UMFPACK_OK,
                ExcMessage("The factors of UMFPACK are of no use."));
  }



  template class UmfpackFactorisation<1>;
  template class UmfpackFactorisation<2>;
  template class UmfpackFactorisation<3>;
} // namespace StickSlip
