// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_coarse_solver_h
#define stickslip_tnnmg_coarse_solver_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>

#include <memory>
#include <stdexcept>

namespace StickSlip
{
  /**
   * Thrown where the matrix of the coarsest level cannot be factorised.
   */
  class SingularCoarseMatrix : public std::runtime_error
  {
  public:
    SingularCoarseMatrix()
      : std::runtime_error("the matrix of the coarsest level is singular")
    {}
  };

  /**
   * Direct solution on the coarsest level, through UMFPACK. Masked components
   * are zero.
   */
  template <int dim>
  class CoarseSolver
  {
  public:
    CoarseSolver();

    ~CoarseSolver();

    CoarseSolver(CoarseSolver &&) noexcept;

    CoarseSolver &
    operator=(CoarseSolver &&) noexcept;

    /** Throws SingularCoarseMatrix. */
    void
    factorize(const BlockMatrix<dim> &matrix, const NodeMask &mask);

    /** x = A^-1 b. */
    void
    solve(NodalVector &x, const NodalVector &b);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace StickSlip

#endif
