// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <stickslip/algebra/masked_entries.h>
#include <stickslip/algebra/trilinos_system.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <vector>

namespace StickSlip
{
  template <int n_components>
  struct TrilinosSystem<n_components>::Implementation
  {
    Epetra_MpiComm                    communicator{MPI_COMM_SELF};
    std::unique_ptr<Epetra_CrsMatrix> matrix;
    std::unique_ptr<Epetra_Vector>    solution, rhs;
    Epetra_LinearProblem              problem;

    /** Whose sparsity the matrix was made from. */
    const BlockSparsity *source = nullptr;

    void
    reinit(const BlockSparsity &sparsity)
    {
      const unsigned int n = sparsity.n_rows();
      const Epetra_Map   map(int(n * n_components), 0, communicator);
      std::vector<int>   row_sizes;
      for (unsigned int i = 0; i < n; ++i)
        row_sizes.insert(row_sizes.end(),
                         n_components,
                         (sparsity.row_start[i + 1] - sparsity.row_start[i]) *
                           n_components);
      matrix =
        std::make_unique<Epetra_CrsMatrix>(Copy, map, row_sizes.data(), true);
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<int> columns;
          for (unsigned int k = sparsity.row_start[i];
               k < sparsity.row_start[i + 1];
               ++k)
            for (unsigned int d = 0; d < n_components; ++d)
              columns.push_back(sparsity.column[k] * n_components + d);
          const std::vector<double> values(columns.size(), 1.);
          for (unsigned int c = 0; c < n_components; ++c)
            matrix->InsertGlobalValues(i * n_components + c,
                                       columns.size(),
                                       values.data(),
                                       columns.data());
        }
      matrix->FillComplete();
      matrix->OptimizeStorage();
      solution = std::make_unique<Epetra_Vector>(map);
      rhs      = std::make_unique<Epetra_Vector>(map);
      problem.SetOperator(matrix.get());
      problem.SetLHS(solution.get());
      problem.SetRHS(rhs.get());
      source = &sparsity;
    }
  };



  template <int n_components>
  TrilinosSystem<n_components>::TrilinosSystem()
    : implementation(std::make_unique<Implementation>())
  {}



  template <int n_components>
  TrilinosSystem<n_components>::~TrilinosSystem() = default;



  template <int n_components>
  bool
  TrilinosSystem<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    const BlockSparsity &sparsity = matrix.sparsity();
    const bool           is_new   = (implementation->source != &sparsity);
    if (is_new)
      implementation->reinit(sparsity);

    int    *row_start, *columns;
    double *value;
    implementation->matrix->ExtractCrsDataPointers(row_start, columns, value);
    write_masked_entries(matrix, mask, value);
    return is_new;
  }



  template <int n_components>
  unsigned int
  TrilinosSystem<n_components>::size() const
  {
    return implementation->rhs->MyLength();
  }



  template <int n_components>
  Epetra_RowMatrix &
  TrilinosSystem<n_components>::matrix()
  {
    return *implementation->matrix;
  }



  template <int n_components>
  Epetra_LinearProblem &
  TrilinosSystem<n_components>::problem()
  {
    return implementation->problem;
  }



  template <int n_components>
  void
  TrilinosSystem<n_components>::set_rhs(const NodalVector &b)
  {
    std::copy_n(b.begin(), size(), implementation->rhs->Values());
  }



  template <int n_components>
  void
  TrilinosSystem<n_components>::get_solution(NodalVector &x) const
  {
    std::copy_n(implementation->solution->Values(), size(), x.begin());
  }



  struct SilentErrors::Implementation
  {
    std::ostringstream text;
    std::streambuf    *original;
  };



  SilentErrors::SilentErrors()
    : implementation(std::make_unique<Implementation>())
  {
    implementation->original = std::cerr.rdbuf(implementation->text.rdbuf());
  }



  SilentErrors::~SilentErrors()
  {
    std::cerr.rdbuf(implementation->original);
  }



  template class TrilinosSystem<1>;
  template class TrilinosSystem<2>;
  template class TrilinosSystem<3>;
} // namespace StickSlip
