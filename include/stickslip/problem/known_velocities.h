// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_known_velocities_h
#define stickslip_problem_known_velocities_h

#include <stickslip/problem/spatial_problem.h>

#include <vector>

namespace StickSlip
{
  /** The velocities in the jump basis, m/s, that boundary conditions and
   * prescribed slip rates set at @p time, and zero else. Collective. */
  template <int dim, int n_components>
  NodalVector
  known_velocities(SpatialProblem<dim, n_components> &problem,
                   const double                       time);

  /** True if these are the same from @p time on. */
  template <int dim, int n_components>
  bool
  velocities_stay(SpatialProblem<dim, n_components> &problem,
                  const double                       time);

  /** Owned entries of a vector that never take part in a linear problem,
   * ascending. */
  std::vector<unsigned int>
  fixed_entries(const Unknowns &unknowns);
} // namespace StickSlip

#endif
