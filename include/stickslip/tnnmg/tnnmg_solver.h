// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_tnnmg_solver_h
#define stickslip_tnnmg_tnnmg_solver_h

#include <stickslip/tnnmg/iteration_summary.h>
#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>

namespace StickSlip
{
  /**
   * Truncated nonsmooth Newton multigrid (Graeser and Sander 2019) for the
   * minimisation of
   *
   *   J(w) = 1/2 w . A w - b . w + phi(w)
   *
   * over the components of w that are not fixed, with A symmetric positive
   * definite there and phi a convex functional that is a sum over nodes. One
   * iteration is
   *
   *   1. a sweep of nonlinear Gauss-Seidel,
   *   2. truncation of the components at which phi is not smooth enough,
   *   3. a correction for the linearisation on the rest, see LinearCorrection,
   *   4. a line search.
   *
   * J decreases in every iteration, which makes the method converge from any
   * initial iterate. On several processes, whose sweeps do not see each other,
   * the change by the sweep is shortened where J would increase.
   */
  template <int dim>
  class TNNMGSolver
  {
  public:
    /** The hierarchy holds A, the fixed components and the transfers. */
    TNNMGSolver(LevelHierarchy<dim>   &hierarchy,
                const TNNMGParameters &parameters);

    /**
     * Iterate from @p w until the correction is below the tolerance. The
     * fixed components of w keep their values. The caller has to look at
     * SolveSummary::converged.
     */
    SolveSummary
    solve(const NonsmoothFunctional<dim> &functional,
          const NodalVector              &b,
          NodalVector                    &w);

    /**
     * Announce a sequence of single iterations from @p w with right hand side
     * @p b, between which the functional may change.
     */
    void
    start(const NodalVector &b, const NodalVector &w);

    /** One iteration. */
    IterationSummary
    iterate(const NonsmoothFunctional<dim> &functional,
            const NodalVector              &b,
            NodalVector                    &w);

    /** Whether an iteration's correction is below the tolerance. */
    bool
    has_converged(const IterationSummary &summary) const;

  private:
    /** Step 1, from the iterate in previous; J does not increase. */
    void
    smooth(const NonsmoothFunctional<dim> &functional,
           const NodalVector              &b,
           NodalVector                    &w,
           IterationSummary               &summary);

    /** Truncate and linearise phi at @p w; returns the number of truncated
     * components. */
    unsigned int
    linearise(const NonsmoothFunctional<dim> &functional, const NodalVector &w);

    LevelHierarchy<dim>                   &hierarchy;
    const TNNMGParameters                 &parameters;
    std::unique_ptr<LinearCorrection<dim>> linear_correction;

    /** b - A w of the current iterate. */
    NodalVector residual;

    NodeMask    active;
    NodalVector previous, smoothed_residual, correction, A_correction, scratch;
    std::vector<Tensor<2, dim>> hessians;
  };
} // namespace StickSlip

#endif
