// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_test_displacements_h
#define stickslip_simulation_test_displacements_h

#include <stickslip/problem/spatial_problem.h>

#include <functional>
#include <string>
#include <vector>

namespace StickSlip
{
  /** Slip of one fault along its first axis, all others stuck, as a function of
   * the position before any displacement. */
  template <int dim>
  struct SlipPattern
  {
    unsigned int                              fault = 0;
    std::function<double(const Point<dim> &)> slip;
    /** Name, for messages. */
    std::string name;
    /** Relative error of the energy that counts as one of a load. */
    double allowance = 1.;
  };

  /** A static displacement, m. */
  struct TestDisplacement
  {
    NodalVector values;
    /** See SlipPattern. */
    std::string name;
    double      allowance = 1.;
  };

  /**
   * Static displacements that stand for what bodies go through in a run, m:
   *
   * - the equilibrium under the loads of the start, faults stuck, if there are
   *   any;
   * - the motion of driven sides and of faults with prescribed slip rates in a
   *   second at the rates of @p time, with the tractions that have changed
   *   until then, faults stuck, if there are any;
   * - one for each of the patterns.
   *
   * Changes the combination of matrices of the problem. Throws AgreedFailure if
   * nothing holds a body. Collective.
   */
  template <int dim, int n_components>
  std::vector<TestDisplacement>
  test_displacements(SpatialProblem<dim, n_components>   &problem,
                     const double                         time,
                     const std::vector<SlipPattern<dim>> &patterns);
} // namespace StickSlip

#endif
