// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_amg_coarse_solver_h
#define stickslip_multigrid_amg_coarse_solver_h

#include <stickslip/multigrid/coarse_solver.h>
#include <stickslip/multigrid/smoothed_aggregation.h>

namespace StickSlip
{
  /**
   * Two cycles of smoothed aggregation with ML of Trilinos, with the
   * translations as near null space: for coarsest levels too large to
   * factorise, as those of meshes that come with little or no hierarchy.
   */
  template <int n_components>
  class AMGCoarseSolver : public CoarseSolver<n_components>
  {
  public:
    /** @p frames: axes of the @p nodes. */
    AMGCoarseSolver(const NodePartition &nodes, const LocalFrames &frames);

    void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) override;

    void
    solve(NodalVector &x, const NodalVector &b) override;

  private:
    SmoothedAggregation<n_components> cycles;
  };
} // namespace StickSlip

#endif
