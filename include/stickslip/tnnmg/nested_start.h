// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nested_start_h
#define stickslip_tnnmg_nested_start_h

#include <stickslip/multigrid/level_hierarchy.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>
#include <stickslip/tnnmg/solver_parameters.h>

namespace StickSlip
{
  /**
   * Nested iteration (Kronsjoe and Dahlquist 1972), for a solution of which
   * nothing is known: add to @p w the prolongation of what minimises J over a
   * coarse level. @p w is zero but in fixed components, and @p residual is b -
   * A w. Most iterations from zero find where the nonsmooth term bends, for
   * which few unknowns are enough.
   *
   * Its term at a coarse node is that of the fine node in the same place, in
   * the axes of the nodes, as many times as it stands for fine ones: close to
   * phi where neighbouring terms are alike, and a place to start from
   * elsewhere.
   *
   * The level is the finest one with at most 1/32 of the nodes that is not the
   * coarsest; a finer one, up to a twelfth, where there is none, or where
   * processes own no fine nodes in the places of their coarse ones. Nothing is
   * done without such a level, or if it does not see the solution: if the
   * operator at its nonsmooth nodes is that of a mass, and not of stiffness.
   * Returns whether anything has been done.
   *
   * The operator has been taken over; nothing is kept from one call to the
   * next. Collective. Throws SingularMatrix.
   */
  template <int n_components>
  bool
  add_coarse_minimiser(const LevelHierarchy<n_components>      &hierarchy,
                       const NonsmoothFunctional<n_components> &functional,
                       const TNNMGParameters                   &parameters,
                       const NodalVector                       &residual,
                       NodalVector                             &w);
} // namespace StickSlip

#endif
