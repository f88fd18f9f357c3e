// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_RowMatrix.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <stickslip/multigrid/smoothed_aggregation.h>

namespace StickSlip
{
  template <int n_components>
  SmoothedAggregation<n_components>::SmoothedAggregation(
    const unsigned int              n_cycles,
    const std::vector<NodalVector> &near_null_space)
    : n_cycles(n_cycles)
    , n_modes(near_null_space.size())
  {
    for (const NodalVector &mode : near_null_space)
      null_space.insert(null_space.end(),
                        mode.begin(),
                        mode.begin() + mode.locally_owned_size());
  }



  template <int n_components>
  SmoothedAggregation<n_components>::~SmoothedAggregation() = default;



  template <int n_components>
  bool
  SmoothedAggregation<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    const SilentErrors silence;
    // Old cycles refer to the matrix.
    cycles.reset();
    system.set_matrix(matrix, mask);

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", n_components);
    // The preconditioner of conjugate gradients must be symmetric.
    list.set("smoother: type", "symmetric Gauss-Seidel");
    list.set("smoother: sweeps", 1);
    list.set("coarse: type", "Amesos-KLU");
    list.set("cycle applications", static_cast<int>(n_cycles));
    if (n_modes > 0)
      {
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", static_cast<int>(n_modes));
        list.set("null space: vectors", null_space.data());
      }
    cycles = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
      system.matrix(), list, /*ComputePrec=*/false);
    if (cycles->ComputePreconditioner() != 0)
      cycles.reset();
    return is_set();
  }



  template <int n_components>
  void
  SmoothedAggregation<n_components>::vmult(NodalVector &x, const NodalVector &b)
  {
    system.set_rhs(b);
    const int error = cycles->ApplyInverse(*system.problem().GetRHS(),
                                           *system.problem().GetLHS());
    AssertThrow(error == 0, ExcMessage("The cycle of ML failed."));
    system.get_solution(x);
  }



  template class SmoothedAggregation<1>;
  template class SmoothedAggregation<2>;
  template class SmoothedAggregation<3>;
} // namespace StickSlip
