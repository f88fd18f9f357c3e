// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_step_summary_h
#define stickslip_simulation_step_summary_h

#include <deal.II/base/timer.h>

#include <stickslip/output/run_summary.h>
#include <stickslip/simulation/run_state.h>
#include <stickslip/time/time_parameters.h>

namespace StickSlip
{
  /**
   * Steps and iterations of a run, and nodes under tension, if there were any.
   */
  template <int dim>
  void
  summarise_steps(RunSummary           &summary,
                  const RunState<dim>  &state,
                  const StepSizeControl control);

  /**
   * Wall times of the sections of a program and the memory of all processes;
   * @p construction: time for meshes and matrices, s; @p hierarchy_bytes: what
   * the level hierarchy takes on this process, zero if there is none.
   * Collective.
   */
  void
  summarise_resources(RunSummary        &summary,
                      const TimerOutput &timer,
                      const double       construction,
                      const double       hierarchy_bytes,
                      const MPI_Comm     communicator);
} // namespace StickSlip

#endif
