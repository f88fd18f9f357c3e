// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_coarse_solver_h
#define stickslip_multigrid_coarse_solver_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_frames.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/singular_matrix.h>

#include <memory>

namespace StickSlip
{
  /**
   * Thrown where the matrix of the coarsest level cannot be factorised.
   */
  class SingularCoarseMatrix : public SingularMatrix
  {
  public:
    SingularCoarseMatrix()
      : SingularMatrix("the matrix of the coarsest level")
    {}
  };

  /**
   * The ways to solve the coarsest level.
   */
  enum class CoarseSolverType
  {
    /** Factorisation. */
    direct,
    /** Cycles of an algebraic multigrid method. */
    amg
  };

  /**
   * Solution on the coarsest level, a symmetric linear map of the right hand
   * side. Masked components are zero. The nodes all belong to the process that
   * has an object of this class.
   */
  template <int n_components>
  class CoarseSolver
  {
  public:
    virtual ~CoarseSolver() = default;

    /** Prepare for a matrix. Throws SingularCoarseMatrix. */
    virtual void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) = 0;

    /** x = A^-1 b, or an approximation. */
    virtual void
    solve(NodalVector &x, const NodalVector &b) = 0;
  };

  /** @p frames: axes of the @p nodes of the coarsest level. */
  template <int n_components>
  std::unique_ptr<CoarseSolver<n_components>>
  make_coarse_solver(const CoarseSolverType type,
                     const NodePartition   &nodes,
                     const LocalFrames     &frames);
} // namespace StickSlip

#endif
