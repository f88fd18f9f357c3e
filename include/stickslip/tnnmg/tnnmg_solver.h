// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_tnnmg_solver_h
#define stickslip_tnnmg_tnnmg_solver_h

#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

namespace StickSlip
{
  /**
   * Truncated nonsmooth Newton multigrid (Graeser and Sander 2019). One
   * iteration is
   *
   *   1. a sweep of nonlinear Gauss-Seidel,
   *   2. truncation of the components at which phi is not smooth enough,
   *   3. a correction for the linearisation on the rest, see LinearCorrection,
   *      projected onto the domain of phi,
   *   4. a line search.
   *
   * J decreases in every iteration, which makes the method converge from any
   * initial iterate. On several processes, whose sweeps do not see each other,
   * the change by the sweep is shortened where J would increase.
   */
  template <int n_components>
  class TNNMGSolver : public NonsmoothSolver<n_components>
  {
  public:
    /**
     * The hierarchy holds A, the fixed components and the transfers.
     * @p near_null_space is of use to the linear correction AMG only: vectors
     * like the unknowns, on which A is small, as the rigid motions.
     */
    TNNMGSolver(LevelHierarchy<n_components>   &hierarchy,
                const TNNMGParameters          &parameters,
                const std::vector<NodalVector> &near_null_space = {});

    void
    start(const NodalVector &b, const NodalVector &w) override;

    IterationSummary
    iterate(const NonsmoothFunctional<n_components> &functional,
            const NodalVector                       &b,
            NodalVector                             &w) override;

    /** Nothing is left to do. */
    void
    finish(const NodalVector &b, NodalVector &w) override;

  private:
    /** Step 1, from the iterate in previous; J does not increase. */
    void
    smooth(const NonsmoothFunctional<n_components> &functional,
           const NodalVector                       &b,
           NodalVector                             &w,
           IterationSummary                        &summary);

    /** Step 2 at @p w, where @p force is the negative gradient of J; returns
     * the number of truncated components. */
    unsigned int
    linearise(const NonsmoothFunctional<n_components> &functional,
              const NodalVector                       &w,
              const NodalVector                       &force);

    LevelHierarchy<n_components>                   &hierarchy;
    std::unique_ptr<LinearCorrection<n_components>> linear_correction;

    /** b - A w of the current iterate. */
    NodalVector residual;

    NodeMask    active;
    NodalVector previous, smoothed_residual, correction, A_correction, scratch;
    std::vector<Tensor<2, n_components>> hessians, diagonal_blocks;
  };
} // namespace StickSlip

#endif
