// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_amg_correction_h
#define stickslip_contrib_amg_correction_h

#include <stickslip/multigrid/linearised_cg.h>
#include <stickslip/multigrid/smoothed_aggregation.h>
#include <stickslip/tnnmg/linear_correction.h>

namespace Measure
{
  using namespace StickSlip;

  /**
   * Conjugate gradients to a given reduction of the residual, preconditioned
   * by cycles of smoothed aggregation with ML of Trilinos. The aggregates are
   * made anew where the components that take part have changed, or H by more
   * than the coarse levels of multigrid tolerate. On one process.
   */
  template <int dim>
  class AMGCorrection : public LinearCorrection<dim>
  {
  public:
    /** Without a @p near_null_space it consists of the translations. */
    AMGCorrection(OperatorSum<dim>               &operators,
                  const TNNMGParameters          &parameters,
                  const std::vector<NodalVector> &near_null_space);

    bool
    linearise(const std::vector<Tensor<2, dim>> &hessians,
              const NodeMask                    &active) override;

    /** Ends after 200 steps at the latest; what it has by then still is a
     * direction of descent. */
    unsigned int
    solve(NodalVector &x,
          NodalVector &A_x,
          NodalVector &r,
          const double norm,
          const bool   is_outdated) override;

  private:
    /** True if the present cycles serve a linearisation. */
    bool
    is_close(const std::vector<Tensor<2, dim>> &new_hessians,
             const NodeMask                    &new_active) const;

    OperatorSum<dim>        &operators;
    const TNNMGParameters   &parameters;
    SmoothedAggregation<dim> cycles;

    /** The linearisation that the cycles are made for. */
    unsigned long               version = 0;
    NodeMask                    active;
    std::vector<Tensor<2, dim>> hessians;
    LinearisedCG<dim>           cg;
  };
} // namespace Measure

#endif
