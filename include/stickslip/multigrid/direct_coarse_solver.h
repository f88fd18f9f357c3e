// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_direct_coarse_solver_h
#define stickslip_multigrid_direct_coarse_solver_h

#include <stickslip/algebra/trilinos_system.h>
#include <stickslip/multigrid/coarse_solver.h>

class Amesos_BaseSolver;

namespace StickSlip
{
  /**
   * Factorisation through Amesos of Trilinos: by KLU, or by MUMPS for large
   * matrices. What depends on the sparsity alone is done once.
   */
  template <int dim>
  class DirectCoarseSolver : public CoarseSolver<dim>
  {
  public:
    DirectCoarseSolver();

    ~DirectCoarseSolver() override;

    void
    set_matrix(const BlockMatrix<dim> &matrix, const NodeMask &mask) override;

    void
    solve(NodalVector &x, const NodalVector &b) override;

  private:
    TrilinosSystem<dim>                system;
    std::unique_ptr<Amesos_BaseSolver> factorisation;
  };
} // namespace StickSlip

#endif
