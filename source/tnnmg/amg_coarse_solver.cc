// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_RowMatrix.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <stickslip/tnnmg/amg_coarse_solver.h>

namespace StickSlip
{
  namespace
  {
    Teuchos::ParameterList
    settings(const int dim)
    {
      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      list.set("PDE equations", dim);
      // As the preconditioner of conjugate gradients must be: symmetric.
      list.set("smoother: type", "symmetric Gauss-Seidel");
      list.set("smoother: sweeps", 1);
      list.set("coarse: type", "Amesos-KLU");
      list.set("cycle applications", 2);
      return list;
    }
  } // namespace



  template <int dim>
  AMGCoarseSolver<dim>::AMGCoarseSolver() = default;



  template <int dim>
  AMGCoarseSolver<dim>::~AMGCoarseSolver() = default;



  template <int dim>
  void
  AMGCoarseSolver<dim>::set_matrix(const BlockMatrix<dim> &matrix,
                                   const NodeMask         &mask)
  {
    const SilentErrors silence;
    // The hierarchy refers to the matrix.
    cycles.reset();
    system.set_matrix(matrix, mask);
    cycles = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
      system.matrix(), settings(dim), /*ComputePrec=*/false);
    if (cycles->ComputePreconditioner() != 0)
      throw SingularCoarseMatrix();
  }



  template <int dim>
  void
  AMGCoarseSolver<dim>::solve(NodalVector &x, const NodalVector &b)
  {
    system.set_rhs(b);
    const int error = cycles->ApplyInverse(*system.problem().GetRHS(),
                                           *system.problem().GetLHS());
    AssertThrow(error == 0, ExcMessage("The cycle of ML failed."));
    system.get_solution(x);
  }



  template class AMGCoarseSolver<2>;
  template class AMGCoarseSolver<3>;
} // namespace StickSlip
