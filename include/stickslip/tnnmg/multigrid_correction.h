// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_multigrid_correction_h
#define stickslip_tnnmg_multigrid_correction_h

#include <stickslip/multigrid/linearised_cg.h>
#include <stickslip/tnnmg/linear_correction.h>

namespace StickSlip
{
  /**
   * Some steps of conjugate gradients from zero, each preconditioned by one
   * symmetric V-cycle of the hierarchy; one step only in the first corrections
   * of a problem.
   */
  template <int dim>
  class MultigridCorrection : public LinearCorrection<dim>
  {
  public:
    MultigridCorrection(LevelHierarchy<dim>   &hierarchy,
                        const TNNMGParameters &parameters);

    void
    start() override;

    void
    linearise(const std::vector<Tensor<2, dim>> &hessians,
              const NodeMask                    &active) override;

    unsigned int
    solve(NodalVector &x, NodalVector &A_x, NodalVector &r) override;

  private:
    LevelHierarchy<dim>   &hierarchy;
    const TNNMGParameters &parameters;
    LinearisedCG<dim>      cg;
    /** Since start(). */
    unsigned int n_solved = 0;
  };
} // namespace StickSlip

#endif
