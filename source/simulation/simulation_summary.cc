// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/scene/members_of.h>
#include <stickslip/simulation/energy_summary.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/space_summary.h>
#include <stickslip/simulation/step_summary.h>
#include <stickslip/version.h>

namespace StickSlip
{
  template <int dim>
  RunSummary
  Simulation<dim>::summarise(const std::string &ending) const
  {
    RunSummary                     summary;
    const std::vector<std::string> body_names = names_of(scene.bodies);
    summary.add("Run", "program", std::string("stickslip ") + version);
    summary.add("Run", "ending", ending);
    summary.add("Run", "simulated time", state().time, "s");
    summary.add_count("Run",
                      "processes",
                      Utilities::MPI::n_mpi_processes(communicator));
    summarise_meshes(summary, mesh_hierarchy, body_names);
    if (problem.is_coupled())
      summarise_problem(summary, problem, body_names, names_of(scene.faults));
    summarise_steps(summary, run_state, scene.time.control);
    if (energy && problem.is_coupled())
      summarise_energy(summary, *energy, state(), scene.time.inertia);
    summarise_resources(summary,
                        timer,
                        construction_timer.last_wall_time(),
                        problem.is_coupled() ?
                          problem.hierarchy().memory_consumption() :
                          0.,
                        communicator);
    return summary;
  }



  template RunSummary
  Simulation<2>::summarise(const std::string &) const;
  template RunSummary
  Simulation<3>::summarise(const std::string &) const;
} // namespace StickSlip
