// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/scene/members_of.h>
#include <stickslip/simulation/energy_summary.h>
#include <stickslip/simulation/simulation_summary.h>
#include <stickslip/simulation/space_summary.h>
#include <stickslip/simulation/step_summary.h>
#include <stickslip/version.h>

namespace StickSlip
{
  template <int dim>
  RunSummary
  summarise_simulation(const std::string          &ending,
                       const SceneParameters<dim> &scene,
                       const SpatialProblem<dim>  &problem,
                       const RunState<dim>        &state,
                       const EnergyBalance<dim>   *energy,
                       const TimerOutput          &timer,
                       const double                construction,
                       const MPI_Comm              communicator)
  {
    RunSummary                     summary;
    const std::vector<std::string> body_names = names_of(scene.bodies);
    summary.add("Run", "program", std::string("stickslip ") + version);
    summary.add("Run", "ending", ending);
    summary.add("Run", "simulated time", state.system.time, "s");
    summary.add_count("Run",
                      "processes",
                      Utilities::MPI::n_mpi_processes(communicator));
    summarise_meshes(summary, problem.meshes(), body_names);
    if (problem.is_coupled())
      summarise_problem(summary, problem, body_names, names_of(scene.faults));
    summarise_steps(summary, state, scene.time.control);
    if (energy != nullptr && problem.is_coupled())
      summarise_energy(summary, *energy, state.system, scene.time.inertia);
    summarise_resources(summary,
                        timer,
                        construction,
                        problem.is_coupled() ?
                          problem.hierarchy().memory_consumption() :
                          0.,
                        communicator);
    return summary;
  }



#define STICKSLIP_INSTANTIATE(dim)                                            \
  template RunSummary summarise_simulation<dim>(const std::string &,          \
                                                const SceneParameters<dim> &, \
                                                const SpatialProblem<dim> &,  \
                                                const RunState<dim> &,        \
                                                const EnergyBalance<dim> *,   \
                                                const TimerOutput &,          \
                                                const double,                 \
                                                const MPI_Comm);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
