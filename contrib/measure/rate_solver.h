// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_rate_solver_h
#define stickslip_contrib_rate_solver_h

#include <stickslip/simulation/scene_parameters.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <memory>

#include "measurement.h"

namespace Measure
{
  using namespace StickSlip;

  /*
   * Settings of the solver that parameter files do not have. Each pair of
   * functions also compiles where the solver does not know the setting.
   */

  template <typename Parameters>
  auto
  omit_nonlinear_smoothing(Parameters &parameters, int)
    -> decltype(void(parameters.nonlinear_smoothing))
  {
    parameters.nonlinear_smoothing = false;
  }

  template <typename Parameters>
  void
  omit_nonlinear_smoothing(Parameters &, long)
  {
    AssertThrow(false, ExcMessage("The smoother cannot be left out."));
  }

  template <typename Parameters>
  auto
  omit_linear_correction(Parameters &parameters, int)
    -> decltype(void(decltype(parameters.linear_correction)::none))
  {
    parameters.linear_correction = decltype(parameters.linear_correction)::none;
  }

  template <typename Parameters>
  void
  omit_linear_correction(Parameters &, long)
  {
    AssertThrow(false, ExcMessage("The correction cannot be left out."));
  }



  /** The solver of rate problems that the scene asks for. */
  template <int dim>
  std::unique_ptr<TNNMGSolver<dim>>
  make_rate_solver(LevelHierarchy<dim>        &hierarchy,
                   const SceneParameters<dim> &scene)
  {
    return std::make_unique<TNNMGSolver<dim>>(hierarchy, scene.tnnmg);
  }
} // namespace Measure

#endif
