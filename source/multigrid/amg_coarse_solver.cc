// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/amg_coarse_solver.h>

namespace StickSlip
{
  template <int n_components>
  AMGCoarseSolver<n_components>::AMGCoarseSolver()
    : cycles(/*n_cycles=*/2)
  {}



  template <int n_components>
  void
  AMGCoarseSolver<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    if (!cycles.set_matrix(matrix, mask))
      throw SingularCoarseMatrix();
  }



  template <int n_components>
  void
  AMGCoarseSolver<n_components>::solve(NodalVector &x, const NodalVector &b)
  {
    cycles.vmult(x, b);
  }



  template class AMGCoarseSolver<1>;
  template class AMGCoarseSolver<2>;
  template class AMGCoarseSolver<3>;
} // namespace StickSlip
