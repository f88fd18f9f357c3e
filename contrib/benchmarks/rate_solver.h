// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_rate_solver_h
#define stickslip_contrib_rate_solver_h

#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <memory>

#include "amg_correction.h"
#include "rigid_body_modes.h"

namespace Measure
{
  using namespace StickSlip;

  /** The linear correction of TNNMG. */
  enum class Correction
  {
    of_scene,
    /** By conjugate gradients with cycles of algebraic multigrid. */
    amg
  };

  /** The solver of rate problems that the scene asks for, as in a time step,
   * but for the @p correction. */
  template <int dim>
  std::unique_ptr<NonsmoothSolver<dim>>
  make_rate_solver(SpatialProblem<dim>        &problem,
                   const SceneParameters<dim> &scene,
                   const Correction            correction)
  {
    OperatorSum<dim>      &operators  = problem.operators();
    const TNNMGParameters &parameters = scene.tnnmg;
    if (scene.time.rate_solver == RateSolver::condensed_newton)
      return std::make_unique<CondensedSolver<dim>>(operators, parameters);
    if (correction == Correction::amg)
      return std::make_unique<TNNMGSolver<dim>>(
        operators,
        parameters,
        std::make_unique<AMGCorrection<dim>>(operators,
                                             parameters,
                                             rigid_body_modes(problem)));
    return std::make_unique<TNNMGSolver<dim>>(problem.hierarchy(), parameters);
  }
} // namespace Measure

#endif
