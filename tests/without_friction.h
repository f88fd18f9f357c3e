// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_without_friction_h
#define stickslip_tests_without_friction_h

#include <stickslip/multigrid/level_hierarchy.h>

namespace StickSlip::Tests
{
  /** Prepare the cycle for the quadratic part of the energy alone, in the
   * @p active components. */
  template <int n_components>
  void
  linearise_without_friction(LevelHierarchy<n_components> &hierarchy,
                             const NodeMask               &active)
  {
    hierarchy.linearise(std::vector<Tensor<2, n_components>>(
                          hierarchy.finest().nonsmooth_nodes.size()),
                        active);
  }
} // namespace StickSlip::Tests

#endif
