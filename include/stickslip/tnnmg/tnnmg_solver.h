// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_tnnmg_solver_h
#define stickslip_tnnmg_tnnmg_solver_h

#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

namespace StickSlip
{
  /**
   * Truncated nonsmooth Newton multigrid (Graeser and Sander 2019): the steps
   * of NonsmoothSolver on all unknowns, with a LinearCorrection.
   *
   * J decreases in every iteration, which makes the method converge from any
   * initial iterate.
   */
  template <int n_components>
  class TNNMGSolver : public NonsmoothSolver<n_components>
  {
  public:
    /** For the operator of a hierarchy, with the correction that the parameters
     * ask for. The hierarchy must live longer than this object. */
    TNNMGSolver(LevelHierarchy<n_components> &hierarchy,
                const TNNMGParameters        &parameters);

    /** For an operator, which must live longer than this object, with a
     * correction of one's own. */
    TNNMGSolver(const OperatorSum<n_components>                &operators,
                const TNNMGParameters                          &parameters,
                std::unique_ptr<LinearCorrection<n_components>> correction);

    void
    start(const NodalVector &b, const NodalVector &w) override;

    IterationSummary
    iterate(const NonsmoothFunctional<n_components> &functional,
            const NodalVector                       &b,
            NodalVector                             &w) override;

    /** Nothing is left to do. */
    void
    finish(const NodalVector &b, NodalVector &w) override;

    std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const override
    {
      return linear_correction->kept_linearisations();
    }

    void
    recall(const KeptLinearisation<n_components> &kept) override
    {
      linear_correction->recall(kept);
    }

  private:
    /** From zero on a coarse level, see add_coarse_minimiser(). */
    void
    begin(const NonsmoothFunctional<n_components> &functional,
          const NodalVector                       &b,
          NodalVector                             &w) override;

    void
    sweep(const NonsmoothFunctional<n_components> &functional,
          const bool                               is_everywhere,
          NodalVector                             &w,
          NodalVector                             &r) override;

    void
    vmult(NodalVector &y, const NodalVector &x) const override;

    Tensor<2, n_components>
    diagonal_block(const unsigned int k) const override;

    bool
    take_linearisation() override;

    unsigned int
    correct(NodalVector &x,
            NodalVector &A_x,
            NodalVector &r,
            const double norm,
            const bool   is_outdated) override;

    const OperatorSum<n_components>                &operators;
    NonlinearGaussSeidel<n_components>              smoother;
    std::unique_ptr<LinearCorrection<n_components>> linear_correction;
  };
} // namespace StickSlip

#endif
