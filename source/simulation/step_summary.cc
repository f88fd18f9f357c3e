// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <stickslip/simulation/step_summary.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  void
  summarise_steps(RunSummary           &summary,
                  const RunState<dim>  &state,
                  const StepSizeControl control)
  {
    const RunCounts       &counts = state.counts;
    const StepMemory<dim> &steps  = state.steps;
    summary.add_count("Steps", "accepted", counts.accepted);
    summary.add_count("Steps", "rejected", steps.n_rejected);
    summary.add_count("Steps", "solved", steps.n_solved);
    summary.add("Steps", "smallest step size", counts.smallest_step, "s");
    summary.add("Steps", "largest step size", counts.largest_step, "s");
    if (control != StepSizeControl::step_doubling)
      summary.add("Steps", "largest estimated error", steps.largest_error);
    summary.add_count("Steps",
                      "contact mappings built",
                      counts.contact_mappings);

    const auto add_counts = [&](const std::string &key,
                                unsigned int StepCounts::*const member) {
      summary.add_count("Iterations",
                        key + ", accepted steps",
                        counts.work.*member);
      summary.add_count("Iterations", key + ", all steps", steps.work.*member);
      summary.add("Iterations",
                  key + ", per accepted step",
                  double(counts.work.*member) / std::max(counts.accepted, 1u));
    };
    summary.add_count("Iterations",
                      "CG at the start",
                      counts.equilibrium_iterations);
    add_counts("rate-state", &StepCounts::rate_state_iterations);
    add_counts("TNNMG", &StepCounts::tnnmg_iterations);
    add_counts("multigrid cycles", &StepCounts::multigrid_cycles);
    if (counts.initially_in_tension > 0)
      summary.add_count("Faults",
                        "nodes in tension at the start, without friction",
                        counts.initially_in_tension);
    if (counts.most_in_tension > 0)
      summary.add_count("Faults",
                        "most nodes in tension at a time",
                        counts.most_in_tension);
  }



  void
  summarise_resources(RunSummary        &summary,
                      const TimerOutput &timer,
                      const double       construction,
                      const double       hierarchy_bytes,
                      const MPI_Comm     communicator)
  {
    summary.add("Wall time", "Meshes and matrices", construction, "s");
    for (const auto &section :
         timer.get_summary_data(TimerOutput::total_wall_time))
      summary.add("Wall time", section.first, section.second, "s");
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    const auto add_memory = [&](const std::string &key, const double bytes) {
      summary.add("Memory", key, bytes / 1048576., "MiB");
    };
    add_memory("largest resident size",
               Utilities::MPI::max(memory.VmHWM * 1024., communicator));
    add_memory("resident size of all processes",
               Utilities::MPI::sum(memory.VmHWM * 1024., communicator));
    const double of_hierarchy =
      Utilities::MPI::sum(hierarchy_bytes, communicator);
    if (of_hierarchy > 0.)
      add_memory("level hierarchy", of_hierarchy);
  }



  template void
  summarise_steps(RunSummary &, const RunState<2> &, const StepSizeControl);
  template void
  summarise_steps(RunSummary &, const RunState<3> &, const StepSizeControl);
} // namespace StickSlip
