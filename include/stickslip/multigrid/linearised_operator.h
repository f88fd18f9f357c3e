// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_linearised_operator_h
#define stickslip_multigrid_linearised_operator_h

#include <stickslip/multigrid/level_hierarchy.h>

namespace StickSlip
{
  /**
   * The linearised operator S (A + H) S of a hierarchy of levels in the form
   * that deal.II's iterative solvers want.
   */
  template <int n_components>
  struct LinearisedOperator
  {
    const LevelHierarchy<n_components> &hierarchy;

    void
    vmult(NodalVector &y, const NodalVector &x) const
    {
      hierarchy.vmult_linearised(y, x);
    }
  };

  /**
   * Its V-cycle as a preconditioner for these.
   */
  template <int n_components>
  struct CyclePreconditioner
  {
    LevelHierarchy<n_components> &hierarchy;

    void
    vmult(NodalVector &y, const NodalVector &x) const
    {
      hierarchy.v_cycle(y, x);
    }
  };
} // namespace StickSlip

#endif
