// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_rate_solver_h
#define stickslip_contrib_rate_solver_h

#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/problem/rigid_body_modes.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <memory>

namespace Measure
{
  using namespace StickSlip;

  /** The solver of rate problems that the scene asks for, as in a time step. */
  template <int dim>
  std::unique_ptr<NonsmoothSolver<dim>>
  make_rate_solver(SpatialProblem<dim>        &problem,
                   const SceneParameters<dim> &scene)
  {
    LevelHierarchy<dim> &hierarchy = problem.hierarchy();
    if (scene.time.rate_solver == RateSolver::condensed_newton)
      return std::make_unique<CondensedSolver<dim>>(hierarchy, scene.tnnmg);
    if (scene.tnnmg.linear_correction == LinearCorrectionType::amg)
      return std::make_unique<TNNMGSolver<dim>>(hierarchy,
                                                scene.tnnmg,
                                                rigid_body_modes(problem));
    return std::make_unique<TNNMGSolver<dim>>(hierarchy, scene.tnnmg);
  }
} // namespace Measure

#endif
