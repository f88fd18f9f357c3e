// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "algebraic_multigrid.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace Measure
{
  namespace
  {
    /** A copy of a matrix of one process. */
    void
    copy(TrilinosWrappers::SparseMatrix &to, const SparseMatrix<double> &from)
    {
      const IndexSet all = complete_index_set(from.m());
      to.reinit(all, all, from, MPI_COMM_SELF, /*drop_tolerance=*/0.);
    }



    /** Translations and linearised rotations, column after column. */
    template <int dim>
    std::vector<double>
    rigid_body_modes(const DoFHandler<dim> &dof_handler)
    {
      const types::global_dof_index n = dof_handler.n_dofs();
      std::vector<Point<dim>>       points(n);
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                           dof_handler,
                                           points);
      std::vector<double>                  modes(n * (dim == 2 ? 3 : 6));
      std::vector<types::global_dof_index> dofs(
        dof_handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const unsigned int c =
                dof_handler.get_fe().system_to_component_index(i).first;
              const Point<dim> &x    = points[dofs[i]];
              modes[c * n + dofs[i]] = 1.;
              unsigned int mode      = dim;
              for (unsigned int a = 0; a < dim; ++a)
                for (unsigned int b = a + 1; b < dim; ++b, ++mode)
                  modes[mode * n + dofs[i]] =
                    c == a ? -x[b] : (c == b ? x[a] : 0.);
            }
        }
      return modes;
    }
  } // namespace



  template <int dim>
  struct AlgebraicMultigrid<dim>::Implementation
  {
    TrilinosWrappers::SparseMatrix                       matrix;
    std::vector<double>                                  modes;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> cycles;
  };



  template <int dim>
  AlgebraicMultigrid<dim>::AlgebraicMultigrid(const WeldedProblem<dim> &problem)
    : problem(problem)
    , implementation(std::make_unique<Implementation>())
  {}



  template <int dim>
  AlgebraicMultigrid<dim>::~AlgebraicMultigrid() = default;



  template <int dim>
  void
  AlgebraicMultigrid<dim>::copy_matrix()
  {
    copy(implementation->matrix, problem.system_matrix);
    implementation->modes = rigid_body_modes(problem.dof_handler);
  }



  template <int dim>
  void
  AlgebraicMultigrid<dim>::set_up()
  {
    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", dim);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", dim == 2 ? 3 : 6);
    list.set("null space: vectors", implementation->modes.data());
    // As the preconditioner of conjugate gradients must be: symmetric.
    list.set("smoother: type", "symmetric Gauss-Seidel");
    list.set("smoother: sweeps", 1);
    list.set("coarse: type", "Amesos-KLU");
    list.set("coarse: max size", 2000);
    implementation->cycles.reset();
    implementation->cycles =
      std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
        implementation->matrix.trilinos_matrix(), list, /*ComputePrec=*/false);
    const int error = implementation->cycles->ComputePreconditioner();
    AssertThrow(error == 0, ExcMessage("ML failed."));
  }



  template <int dim>
  void
  AlgebraicMultigrid<dim>::vmult(Vector<double>       &y,
                                 const Vector<double> &x) const
  {
    const Epetra_CrsMatrix &matrix = implementation->matrix.trilinos_matrix();
    const Epetra_Vector     b(View,
                          matrix.OperatorRangeMap(),
                          const_cast<double *>(x.begin()));
    Epetra_Vector           result(View, matrix.OperatorDomainMap(), y.begin());
    const int error = implementation->cycles->ApplyInverse(b, result);
    AssertThrow(error == 0, ExcMessage("The cycle of ML failed."));
  }



  template <int dim>
  struct MumpsSolver<dim>::Implementation
  {
    TrilinosWrappers::SparseMatrix matrix;
    SolverControl                  control;
    TrilinosWrappers::SolverDirect solver{
      control,
      TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Mumps")};
  };



  template <int dim>
  MumpsSolver<dim>::MumpsSolver(const WeldedProblem<dim> &problem)
    : implementation(std::make_unique<Implementation>())
  {
    copy(implementation->matrix, problem.system_matrix);
  }



  template <int dim>
  MumpsSolver<dim>::~MumpsSolver() = default;



  template <int dim>
  void
  MumpsSolver<dim>::factorise()
  {
    implementation->solver.initialize(implementation->matrix);
  }



  template <int dim>
  void
  MumpsSolver<dim>::solve(Vector<double> &x, const Vector<double> &b)
  {
    const IndexSet                all = complete_index_set(b.size());
    TrilinosWrappers::MPI::Vector solution(all, MPI_COMM_SELF),
      rhs(all, MPI_COMM_SELF);
    std::copy(b.begin(), b.end(), rhs.begin());
    implementation->solver.solve(solution, rhs);
    std::copy(solution.begin(), solution.end(), x.begin());
  }



  template class AlgebraicMultigrid<2>;
  template class AlgebraicMultigrid<3>;
  template class MumpsSolver<2>;
  template class MumpsSolver<3>;
} // namespace Measure
