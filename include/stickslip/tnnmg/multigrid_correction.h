// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_multigrid_correction_h
#define stickslip_tnnmg_multigrid_correction_h

#include <stickslip/multigrid/linearised_cg.h>
#include <stickslip/tnnmg/linear_correction.h>

namespace StickSlip
{
  /**
   * A few steps of conjugate gradients from zero, each preconditioned by one
   * symmetric V-cycle of the hierarchy; one step only in the first corrections
   * of a problem.
   */
  template <int n_components>
  class MultigridCorrection : public LinearCorrection<n_components>
  {
  public:
    MultigridCorrection(LevelHierarchy<n_components> &hierarchy,
                        const TNNMGParameters        &parameters);

    void
    start() override;

    bool
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active) override;

    unsigned int
    solve(NodalVector &x,
          NodalVector &A_x,
          NodalVector &r,
          const double norm,
          const bool   is_outdated) override;

    std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const override;

    void
    recall(const KeptLinearisation<n_components> &kept) override;

    LevelHierarchy<n_components> *
    hierarchy_to_begin_on() override
    {
      return &hierarchy;
    }

  private:
    LevelHierarchy<n_components> &hierarchy;
    const TNNMGParameters        &parameters;
    LinearisedCG<n_components>    cg;
    /** Since start(). */
    unsigned int n_solved = 0;
  };
} // namespace StickSlip

#endif
