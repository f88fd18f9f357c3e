// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_rigid_body_modes_h
#define stickslip_contrib_rigid_body_modes_h

#include <stickslip/problem/spatial_problem.h>

namespace Measure
{
  using namespace StickSlip;

  /**
   * The rigid motions of all bodies together in the jump basis, for algebraic
   * multigrid: dim translations, then one (d = 2) or three (d = 3) rotations,
   * without those that turn a periodic axis, which are no motions of the
   * bodies. The jumps of a rigid motion are zero where the two sides of a fault
   * match. Collective.
   */
  template <int dim>
  std::vector<NodalVector>
  rigid_body_modes(const SpatialProblem<dim> &problem);
} // namespace Measure

#endif
