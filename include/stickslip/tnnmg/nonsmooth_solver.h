// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nonsmooth_solver_h
#define stickslip_tnnmg_nonsmooth_solver_h

#include <stickslip/algebra/operator_sum.h>
#include <stickslip/multigrid/kept_linearisation.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/iteration_summary.h>
#include <stickslip/tnnmg/line_search.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>
#include <stickslip/tnnmg/solver_parameters.h>

#include <array>
#include <limits>
#include <utility>

namespace StickSlip
{
  /**
   * An iteration for the minimisation of
   *
   *   J(w) = 1/2 w . A w - b . w + phi(w)
   *
   * over the components of w that are not fixed, with A symmetric positive
   * definite there and phi a convex functional that is a sum over nodes. J
   * decreases in every iteration, which is
   *
   *   1. a sweep of nonlinear Gauss-Seidel over the nodes of phi, or over all
   *      nodes of a small mesh on one process, and after a slow iteration: one
   *      in which the line search has left less than half of the correction,
   *      since nodes at a kink of phi hold back all the others then, or which
   *      has changed more than half of what the one before it has,
   *   2. truncation of the components at which phi is not smooth enough,
   *   3. a correction for the linearisation on the rest, which may end at
   *      bounds of phi, but not beyond: where it would, it is shortened, and
   *      what belongs to it in the other components is found once more,
   *   4. a line search.
   *
   * Derived classes know A, or what is left of it where only some of the
   * unknowns take part in the iterations: w is the minimiser only after
   * finish().
   */
  template <int n_components>
  class NonsmoothSolver
  {
  public:
    /** @p unknowns: those that the iterations change. @p parameters must live
     * longer than this object. */
    NonsmoothSolver(const Unknowns        &unknowns,
                    const TNNMGParameters &parameters);

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
     * @p b, between which the functional may change, but for its domain. Throws
     * SingularMatrix.
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

    /** Linearisations that the solver goes on to use in later problems, in the
     * order in which recall() takes them. */
    virtual std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const = 0;

    /** Take over what another solver of the same problem has kept, each with
     * the operator set to its coefficients. Collective. */
    virtual void
    recall(const KeptLinearisation<n_components> &kept) = 0;

    /** Return whether the error after the @p last iteration is below the
     * tolerance, by IterationSummary::relative_error() and what is known of the
     * iteration
     * @p before it, if anything. */
    bool
    has_converged(const IterationSummary &last,
                  const IterationSummary *before = nullptr) const;

    /** Let the iterations from now on find
     * IterationSummary::correction_decrease, which takes one more sum over
     * processes. */
    void
    find_correction_decrease()
    {
      with_correction_decrease = true;
    }

  protected:
    /** Announce the iterations of solve(), which may begin from another @p w.
     * By default it does not. */
    virtual void
    begin(const NonsmoothFunctional<n_components> &functional,
          const NodalVector                       &b,
          NodalVector                             &w);

    /** The four steps, with vectors of the unknowns that iterations change,
     * from
     * @p w with its @p residual on. */
    IterationSummary
    carry_out_steps(const NonsmoothFunctional<n_components> &functional,
                    const NodalVector                       &b,
                    NodalVector                             &w);

    /** Step 1: a sweep that changes @p w at the nonsmooth nodes or everywhere,
     * and with it @p r = b - A w. */
    virtual void
    sweep(const NonsmoothFunctional<n_components> &functional,
          const bool                               is_everywhere,
          NodalVector                             &w,
          NodalVector                             &r) = 0;

    /** y = A x. */
    virtual void
    vmult(NodalVector &y, const NodalVector &x) const = 0;

    /** The diagonal block of A at the k-th nonsmooth node. */
    virtual Tensor<2, n_components>
    diagonal_block(const unsigned int k) const = 0;

    /** Step 2: hessians and active are set. See LinearCorrection::linearise(),
     * and correct() for what is returned. */
    virtual bool
    take_linearisation()
    {
      return false;
    }

    /** Step 3, see LinearCorrection::solve(). */
    virtual unsigned int
    correct(NodalVector &x,
            NodalVector &A_x,
            NodalVector &r,
            const double norm,
            const bool   is_outdated) = 0;

    const Unknowns         unknowns;
    const TNNMGParameters &parameters;

    /** b - A w of the current iterate. */
    NodalVector residual;

    /** The linearisation: second derivatives of phi at the nonsmooth nodes, and
     * the components that take part. */
    std::vector<Tensor<2, n_components>> hessians;
    NodeMask                             active;

    /** Forget the iterations so far. */
    void
    restart()
    {
      last_was_slow        = false;
      last_correction_norm = std::numeric_limits<double>::infinity();
    }

    /** The square of the energy norm of the unknowns that iterations leave
     * alone. */
    double square_of_rest = 0;

  private:
    /** True after a slow iteration. */
    bool last_was_slow = false;
    /** True if the sweep of the current iteration goes over all nodes. */
    bool   sweeps_everywhere    = false;
    double last_correction_norm = std::numeric_limits<double>::infinity();

    /** Carry out @p action for the local indices of all components of the nodes
     * that the sweep goes over. */
    template <typename Action>
    void
    for_each_swept_entry(const Action &action) const;

    /** The linearised problem at an iterate with its new_residual, and what
     * processes agree on: the right hand side, the negative gradient of J
     * between active components, is in force. */
    struct LinearProblem
    {
      /** Truncated components of this process. */
      unsigned int n_truncated = 0;
      /** Of this process, or of all: the square of the norm of the right hand
       * side, and whether the linearisation is to be brought up to date. */
      double square      = 0.;
      bool   is_outdated = false;
    };

    /** Take note of the change by the smoother, from @p before to @p w. Returns
     * its products with the residual before it and with A times itself, of this
     * process. */
    std::pair<double, double>
    find_smoothing(const NodalVector &before, const NodalVector &w);

    /** Step 2 at the iterate @p w, for this process. */
    LinearProblem
    truncate(const NonsmoothFunctional<n_components> &functional,
             const NodalVector                       &w);

    /** Let all processes agree on it. Collective. */
    LinearProblem
    agreed(LinearProblem here) const;

    /** The squares of the energy norms of the change of the iterate by the
     * smoother and @p t times the correction, and of the new iterate, which is
     * @p w plus the latter, without square_of_rest; of this process. */
    std::array<double, 2>
    squares_after(const NodalVector &b,
                  const NodalVector &w,
                  const double       t) const;

    /** Step 3, to be followed from the iterate @p w. Returns the cycles spent,
     * and gives the components that get to a bound. */
    unsigned int
    find_correction(const NonsmoothFunctional<n_components> &functional,
                    const NodalVector                       &w,
                    const LinearProblem                     &problem,
                    std::vector<BoundComponent>             &at_bound);

    std::vector<Tensor<2, n_components>> diagonal_blocks;
    NodalVector new_residual, force, correction, A_correction;
    /** The change by the sweep, one swept entry after the other. */
    std::vector<double> smoothing;

    bool with_correction_decrease = false;
  };
} // namespace StickSlip

#endif
