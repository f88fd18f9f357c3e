// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nonsmooth_solver_h
#define stickslip_tnnmg_nonsmooth_solver_h

#include <stickslip/algebra/node_partition.h>
#include <stickslip/tnnmg/iteration_summary.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>
#include <stickslip/tnnmg/solver_parameters.h>

namespace StickSlip
{
  /**
   * An iteration for the minimisation of
   *
   *   J(w) = 1/2 w . A w - b . w + phi(w)
   *
   * over the components of w that are not fixed, with A symmetric positive
   * definite there and phi a convex functional that is a sum over nodes. J
   * decreases in every iteration.
   *
   * An iteration may leave components alone on which phi does not act, so that
   * w is the minimiser only after finish().
   */
  template <int n_components>
  class NonsmoothSolver
  {
  public:
    /** @p parameters must live longer than this object. */
    explicit NonsmoothSolver(const TNNMGParameters &parameters);

    virtual ~NonsmoothSolver() = default;

    /**
     * Iterate from @p w until the error is below the tolerance. The
     * fixed components of w keep their values. The caller has to look at
     * SolveSummary::converged. Throws SingularMatrix.
     */
    SolveSummary
    solve(const NonsmoothFunctional<n_components> &functional,
          const NodalVector                       &b,
          NodalVector                             &w);

    /**
     * Announce a sequence of single iterations from @p w with right hand side
     * @p b, between which the functional may change. Throws SingularMatrix.
     */
    virtual void
    start(const NodalVector &b, const NodalVector &w) = 0;

    /** One iteration. Throws SingularMatrix. */
    virtual IterationSummary
    iterate(const NonsmoothFunctional<n_components> &functional,
            const NodalVector                       &b,
            NodalVector                             &w) = 0;

    /** Complete the components that the iterations since start() left alone. */
    virtual void
    finish(const NodalVector &b, NodalVector &w) = 0;

    /** Whether the error after the @p last iteration is below the tolerance,
     * by IterationSummary::relative_error() and what is known of the iteration
     * @p before it, if anything. */
    bool
    has_converged(const IterationSummary &last,
                  const IterationSummary *before = nullptr) const;

  protected:
    const TNNMGParameters &parameters;
  };
} // namespace StickSlip

#endif
