// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>
#include <Teuchos_ParameterList.hpp>
#include <stickslip/algebra/mumps_factorisation.h>
#include <stickslip/multigrid/direct_coarse_solver.h>

namespace StickSlip
{
  namespace
  {
    /** The number of unknowns from which on MUMPS is faster than KLU, for a
     * factorisation and a dozen solutions. In three dimensions KLU has far more
     * to do. */
    template <int n_components>
    constexpr unsigned int large_matrix = n_components == 3 ? 700 : 5000;



    std::unique_ptr<Amesos_BaseSolver>
    make_klu(const Epetra_LinearProblem &problem)
    {
      std::unique_ptr<Amesos_BaseSolver> result(
        Amesos().Create("Amesos_Klu", problem));
      AssertThrow(result, ExcMessage("This Trilinos lacks KLU."));
      // KLU keeps the pivots of the first factors: the matrix is symmetric and
      // positive definite, and any would do.
      Teuchos::ParameterList parameters;
      parameters.set("Refactorize", true);
      result->SetParameters(parameters);
      return result;
    }
  } // namespace



  template <int n_components>
  DirectCoarseSolver<n_components>::DirectCoarseSolver() = default;



  template <int n_components>
  DirectCoarseSolver<n_components>::~DirectCoarseSolver() = default;



  template <int n_components>
  void
  DirectCoarseSolver<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    if (matrix.n_rows() * n_components >= large_matrix<n_components>)
      {
        if (!mumps)
          mumps = std::make_unique<MumpsFactorisation<n_components>>();
        try
          {
            mumps->set_matrix(matrix, mask);
          }
        catch (const SingularMatrix &)
          {
            throw SingularCoarseMatrix();
          }
        return;
      }

    const SilentErrors silence;
    if (system.set_matrix(matrix, mask))
      {
        klu = make_klu(system.problem());
        if (klu->SymbolicFactorization() != 0)
          throw SingularCoarseMatrix();
      }
    if (klu->NumericFactorization() != 0)
      throw SingularCoarseMatrix();
  }



  template <int n_components>
  void
  DirectCoarseSolver<n_components>::solve(NodalVector &x, const NodalVector &b)
  {
    if (mumps)
      {
        mumps->solve(x, b);
        return;
      }
    system.set_rhs(b);
    const int error = klu->Solve();
    AssertThrow(error == 0,
                ExcMessage("The factors of the coarsest matrix are of no "
                           "use."));
    system.get_solution(x);
  }



  template class DirectCoarseSolver<1>;
  template class DirectCoarseSolver<2>;
  template class DirectCoarseSolver<3>;
} // namespace StickSlip
