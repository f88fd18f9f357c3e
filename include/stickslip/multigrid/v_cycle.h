// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_v_cycle_h
#define stickslip_multigrid_v_cycle_h

#include <stickslip/multigrid/coarse_solver.h>
#include <stickslip/multigrid/level_description.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The digits of matrices and vectors in a cycle.
   */
  enum class CyclePrecision
  {
    /** Half the memory traffic; as a preconditioner it needs no more. */
    single_precision,
    double_precision
  };

  /**
   * The symmetric V-cycle of a LevelHierarchy, with the operators of the levels
   * that it needs: those of the coarse levels, and a copy of the finest one in
   * the form and precision of the smoother. It only ever preconditions.
   */
  template <int n_components>
  class VCycle
  {
  public:
    virtual ~VCycle() = default;

    /** Set the operator, without a nonsmooth term and truncation: combine the
     * terms on the coarse levels, copy the finest one. */
    virtual void
    set_operator(const OperatorSum<n_components> &A) = 0;

    /** Set a diagonal block on the finest level, and which of its components
     * take part. */
    virtual void
    set_finest_diagonal(const unsigned int             i,
                        const Tensor<2, n_components> &block,
                        const NodeMask                &active) = 0;

    /** Form the operators near the nonsmooth nodes on all coarse levels from
     * that on the finest one, S A S, where S keeps the components that take
     * part. Only what depends on the @p changed rows of S A S is formed anew;
     * after set_operator() these are the rows that the nonsmooth term and
     * the truncation change. Throws SingularCoarseMatrix. */
    virtual void
    set_coarse_levels(const BlockMatrix<n_components> &A,
                      const NodeMask                  &active,
                      const std::vector<unsigned int> &changed) = 0;

    /** The rows of each coarse level, the coarsest first, that
     * set_coarse_levels() has formed since set_operator(); empty on several
     * processes, where it always forms the same ones. */
    virtual std::vector<std::vector<unsigned int>>
    formed_rows() const = 0;

    /** After set_operator(): set_coarse_levels() as another cycle has left it
     * that has formed these rows. */
    virtual void
    recall_coarse_levels(
      const BlockMatrix<n_components>              &A,
      const NodeMask                               &active,
      const std::vector<std::vector<unsigned int>> &formed) = 0;

    /** x = approximate solution, where only @p active components take part;
     * @p size: about that of the entries of b, the same on all processes. */
    virtual void
    vmult(NodalVector       &x,
          const NodalVector &b,
          const double       size,
          const NodeMask    &active) = 0;

    /** The operator on a coarse level. */
    virtual BlockMatrix<n_components>
    coarse_matrix(const unsigned int l) const = 0;

    /** The sum of the terms on a coarse level, without a nonsmooth term and
     * truncation. */
    virtual BlockMatrix<n_components>
    combine_coarse(const unsigned int         l,
                   const std::vector<double> &coefficients) const = 0;

    /** The diagonal block of a row of that sum. */
    virtual Tensor<2, n_components>
    combine_coarse_diagonal(const unsigned int         l,
                            const std::vector<double> &coefficients,
                            const unsigned int         row) const = 0;

    /** Number of sweeps before and after the coarse grid correction. */
    virtual void
    set_smoothing_sweeps(const unsigned int sweeps) = 0;

    /** The operators have to be set again after this. */
    virtual void
    set_coarse_solver(const CoarseSolverType type) = 0;

    /** Bytes on this process. */
    virtual std::size_t
    memory_consumption() const = 0;
  };

  /** The coarsest level first; @p levels must outlive the cycle, @p terms of
   * the operator on the finest one need not. Forms the Galerkin products of
   * these. Collective, like all functions that compute. */
  template <int n_components>
  std::unique_ptr<VCycle<n_components>>
  make_v_cycle(const CyclePrecision                               precision,
               const std::vector<LevelDescription<n_components>> &levels,
               const std::vector<TermMatrix<n_components>>       &terms);
} // namespace StickSlip

#endif
