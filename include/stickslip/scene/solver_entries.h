// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_solver_entries_h
#define stickslip_scene_solver_entries_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/tnnmg/solver_parameters.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Declare the settings of the nonsmooth solver in the current subsection of
   * @p prm; their present values are the defaults. The solver itself knows
   * nothing of parameter files.
   */
  void
  declare_solver_entries(ParameterHandler &prm, TNNMGParameters &parameters);
} // namespace StickSlip

#endif
