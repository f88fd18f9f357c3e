// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_simulation_summary_h
#define stickslip_simulation_simulation_summary_h

#include <stickslip/base/section_times.h>
#include <stickslip/output/run_summary.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/simulation/run_state.h>
#include <stickslip/time/energy_balance.h>
#include <stickslip/time/rate_solver_choice.h>

#include <ostream>

namespace StickSlip
{
  /**
   * The whole summary of a run: its ending, meshes, unknowns and faults, steps,
   * energies, wall times and memory. Unknowns, faults and energies are left out
   * if the faults are not coupled. @p energy: null where the scene asks for
   * none; @p construction: time for meshes and matrices, s. Collective.
   */
  template <int dim, int n_components = dim>
  RunSummary
  summarise_simulation(const std::string                       &ending,
                       const SceneParameters<dim>              &scene,
                       const SpatialProblem<dim, n_components> &problem,
                       const RunState<dim, n_components>       &state,
                       const EnergyBalance<dim, n_components>  *energy,
                       const RateSolverChoice                  &rate_solver,
                       const SectionTimes                      &section_times,
                       const double                             construction,
                       const MPI_Comm                           communicator);

  /** Print what makes the results of a run doubtful: an error of a step above
   * the @p tolerance of steps, energy that is @p missing, J, and what new
   * contact mappings have added. */
  template <int dim, int n_components = dim>
  void
  print_warnings(std::ostream                      &out,
                 const double                       tolerance,
                 const RunState<dim, n_components> &state,
                 const double                       missing);
} // namespace StickSlip

#endif
