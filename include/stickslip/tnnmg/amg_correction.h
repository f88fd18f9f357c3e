// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_amg_correction_h
#define stickslip_tnnmg_amg_correction_h

#include <stickslip/multigrid/linearised_cg.h>
#include <stickslip/multigrid/smoothed_aggregation.h>
#include <stickslip/tnnmg/linear_correction.h>

namespace StickSlip
{
  /**
   * Conjugate gradients to a given reduction of the residual, preconditioned
   * by cycles of smoothed aggregation with ML of Trilinos. The aggregates are
   * made anew where the components that take part have changed, or H by more
   * than the coarse levels of multigrid tolerate. On one process.
   */
  template <int n_components>
  class AMGCorrection : public LinearCorrection<n_components>
  {
  public:
    /** Without a @p near_null_space it consists of the translations. */
    AMGCorrection(LevelHierarchy<n_components>   &hierarchy,
                  const TNNMGParameters          &parameters,
                  const std::vector<NodalVector> &near_null_space);

    void
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active) override;

    /** Ends after 200 steps at the latest; what it has by then still is a
     * direction of descent. */
    unsigned int
    solve(NodalVector &x, NodalVector &A_x, NodalVector &r) override;

  private:
    /** Whether the present cycles serve a linearisation. */
    bool
    is_close(const std::vector<Tensor<2, n_components>> &new_hessians,
             const NodeMask                             &new_active) const;

    LevelHierarchy<n_components>     &hierarchy;
    const TNNMGParameters            &parameters;
    SmoothedAggregation<n_components> cycles;

    /** What the cycles are made for. */
    unsigned long                        version = 0;
    NodeMask                             active;
    std::vector<Tensor<2, n_components>> hessians;
    LinearisedCG<n_components>           cg;
  };
} // namespace StickSlip

#endif
