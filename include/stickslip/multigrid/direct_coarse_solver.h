// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_direct_coarse_solver_h
#define stickslip_multigrid_direct_coarse_solver_h

#include <stickslip/algebra/sparse_factorisation.h>
#include <stickslip/algebra/trilinos_system.h>
#include <stickslip/multigrid/coarse_solver.h>

class Amesos_BaseSolver;

namespace StickSlip
{
  /**
   * Factorisation by KLU through Amesos of Trilinos, or of large matrices by
   * MUMPS. What depends on the sparsity alone is done once.
   */
  template <int n_components>
  class DirectCoarseSolver : public CoarseSolver<n_components>
  {
  public:
    DirectCoarseSolver();

    ~DirectCoarseSolver() override;

    void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) override;

    void
    solve(NodalVector &x, const NodalVector &b) override;

  private:
    TrilinosSystem<n_components>       system;
    std::unique_ptr<Amesos_BaseSolver> klu;
    /** In place of both for large matrices. */
    std::unique_ptr<SparseFactorisation<n_components>> mumps;
  };
} // namespace StickSlip

#endif
