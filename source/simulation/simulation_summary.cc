// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <stickslip/scene/members_of.h>
#include <stickslip/scene/version_report.h>
#include <stickslip/simulation/simulation_summary.h>
#include <stickslip/version.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    void
    add_figures(const MeshFigures &mesh, RunSummary::Section &section)
    {
      section.add_count("vertices", mesh.n_vertices);
      section.add_count("cells", mesh.n_cells);
      section.add("smallest cell diameter", mesh.smallest, "m");
      section.add("largest cell diameter", mesh.largest, "m");
    }



    /** Vertices, cells, and the smallest and largest cell diameter of the
     * finest mesh of each body and of all, and the number of levels. */
    template <int dim>
    void
    summarise_meshes(RunSummary                     &summary,
                     const MeshHierarchy<dim>       &meshes,
                     const std::vector<std::string> &body_names)
    {
      const MeshLevel<dim> &finest        = meshes.finest();
      const MPI_Comm        all_processes = finest.nodes.communicator();
      MeshFigures           all;
      for (unsigned int i = 0; i < finest.bodies.size(); ++i)
        {
          MeshFigures one = finest.bodies[i]->figures();
          one.smallest    = Utilities::MPI::min(one.smallest, all_processes);
          one.largest     = Utilities::MPI::max(one.largest, all_processes);
          add_figures(one,
                      summary.add_section("Mesh of body " + body_names[i]));
          all.n_vertices += one.n_vertices;
          all.n_cells += one.n_cells;
          all.smallest = std::min(all.smallest, one.smallest);
          all.largest  = std::max(all.largest, one.largest);
        }
      RunSummary::Section &section = summary.add_section("Mesh of all bodies");
      add_figures(all, section);
      section.add_count("levels", meshes.n_levels());
    }



    /** Unknowns, and the nodes, slave side, contact area and gap of each fault.
     */
    template <int dim, int n_components>
    void
    summarise_problem(RunSummary                              &summary,
                      const SpatialProblem<dim, n_components> &problem,
                      const std::vector<double>               &largest_gaps,
                      const std::vector<std::string>          &body_names,
                      const std::vector<std::string>          &fault_names)
    {
      const LevelDescription<n_components> &level =
        problem.hierarchy().finest();
      const auto           n_all    = level.nodes.n_global() * n_components;
      RunSummary::Section &unknowns = summary.add_section("Unknowns");
      unknowns.add_count("all", n_all);
      unknowns.add_count(
        "not fixed",
        n_all - Utilities::MPI::sum(level.fixed.n_masked(level.nodes.n_owned()),
                                    level.nodes.communicator()));
      for (unsigned int f = 0; f < fault_names.size(); ++f)
        {
          const FaultContact<dim> &contact = problem.jump_basis().faults()[f];
          RunSummary::Section     &section =
            summary.add_section("Fault " + fault_names[f]);
          section.add_count("nodes", contact.slave.nodes.size());
          std::string slave_bodies;
          for (const BodySide &part : problem.meshes()
                                        .topology()
                                        .faults()[f]
                                        .sides[contact.sides.slave])
            slave_bodies +=
              (slave_bodies.empty() ? "" : ", ") + body_names[part.body];
          section.add("slave body", slave_bodies);
          section.add("area in contact",
                      contact.coupling.covered_area,
                      dim == 2 ? "m" : "m^2");
          if (!std::isnan(largest_gaps[f]))
            section.add("largest gap between the sides", largest_gaps[f], "m");
        }
    }



    /** Steps and iterations of a run, and nodes under tension, if there were
     * any. */
    template <int dim, int n_components>
    void
    summarise_steps(RunSummary                        &summary,
                    const RunState<dim, n_components> &state,
                    const StepSizeControl              control)
    {
      const RunCounts       &counts  = state.counts;
      const StepMemory<dim> &steps   = state.steps;
      RunSummary::Section   &section = summary.add_section("Steps");
      section.add_count("accepted", counts.accepted);
      section.add_count("rejected", steps.n_rejected);
      section.add_count("solved", steps.n_solved);
      section.add("smallest step size", counts.smallest_step, "s");
      section.add("largest step size", counts.largest_step, "s");
      if (control != StepSizeControl::step_doubling)
        {
          section.add("largest estimated error", steps.largest_error.faults);
          section.add("largest estimated error, bodies",
                      steps.largest_error.bodies);
        }
      section.add_count("contact mappings built", counts.contact_mappings);

      RunSummary::Section &iterations = summary.add_section("Iterations");
      iterations.add_count("CG at the start", counts.equilibrium_iterations);
      for (const auto &[key, member] :
           {std::make_pair("rate-state", &StepCounts::rate_state_iterations),
            std::make_pair("TNNMG", &StepCounts::tnnmg_iterations),
            std::make_pair("multigrid cycles", &StepCounts::multigrid_cycles)})
        {
          const std::string  name = key;
          const unsigned int n    = counts.work.*member;
          iterations.add_count(name + ", accepted steps", n);
          iterations.add_count(name + ", all steps", steps.work.*member);
          iterations.add(name + ", per accepted step",
                         double(n) / std::max(counts.accepted, 1u));
        }

      RunSummary::Section &faults = summary.add_section("Faults");
      if (counts.initially_in_tension > 0)
        faults.add_count("nodes in tension at the start, without friction",
                         counts.initially_in_tension);
      if (counts.most_in_tension > 0)
        faults.add_count("most nodes in tension at a time",
                         counts.most_in_tension);
    }



    /** Kinetic and elastic energy at @p state, the work since the start, those
     * of them that the model with this @p inertia has, and what is missing
     * between them, in J, in two dimensions for 1 m of the third one.
     * Collective. */
    template <int dim, int n_components>
    void
    summarise_energy(RunSummary                             &summary,
                     const EnergyBalance<dim, n_components> &energy,
                     const SystemState<dim>                 &state,
                     const Inertia                           inertia)
    {
      const std::string    unit    = (dim == 2) ? "J/m" : "J";
      RunSummary::Section &section = summary.add_section("Energy");
      const auto add = [&](const std::string &key, const double value) {
        section.add(key, value, unit);
      };
      const EnergyTerms &work   = energy.work();
      const double       defect = energy.defect(state);
      if (inertia == Inertia::dynamic)
        add("kinetic, at the end", energy.kinetic_energy(state));
      add("elastic, at the end", energy.elastic_energy(state));
      add("work of driven sides", work.driven_sides);
      add("work of gravity and tractions", work.loads);
      add("dissipated by friction", work.friction);
      add("dissipated by viscosity", work.viscosity);
      if (inertia == Inertia::quasi_dynamic)
        add("dissipated by radiation damping", work.radiation);
      if (work.contact != 0.)
        add("taken by contacts", work.contact);
      if (work.mappings != 0.)
        add("added by new contact mappings", work.mappings);
      add("missing", defect);

      if (const double largest = work.largest(); largest > 0.)
        section.add("missing, over the largest work", defect / largest);
    }



    /** Wall times of the sections of a program and the memory of all processes;
     * @p construction: time for meshes and matrices, s; @p hierarchy_bytes:
     * what the level hierarchy takes on this process, zero if there is none.
     * Collective. */
    void
    summarise_resources(RunSummary         &summary,
                        const SectionTimes &section_times,
                        const double        construction,
                        const double        hierarchy_bytes,
                        const MPI_Comm      communicator)
    {
      RunSummary::Section &times = summary.add_section("Wall time");
      times.add("Meshes and matrices", construction, "s");
      for (const auto &section : section_times.seconds())
        times.add(section.first, section.second, "s");
      Utilities::System::MemoryStats memory;
      Utilities::System::get_memory_stats(memory);
      RunSummary::Section &sizes = summary.add_section("Memory");
      const auto add_memory = [&](const std::string &key, const double bytes) {
        sizes.add(key, bytes / 1048576., "MiB");
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
  } // namespace



  template <int dim, int n_components>
  RunSummary
  summarise_simulation(const std::string                       &ending,
                       const SceneParameters<dim>              &scene,
                       const SpatialProblem<dim, n_components> &problem,
                       const RunState<dim, n_components>       &state,
                       const EnergyBalance<dim, n_components>  *energy,
                       const RateSolverChoice                  &rate_solver,
                       const SectionTimes                      &section_times,
                       const double                             construction,
                       const MPI_Comm                           communicator)
  {
    RunSummary                     summary;
    const std::vector<std::string> body_names = names_of(scene.bodies);
    RunSummary::Section           &run        = summary.add_section("Run");
    run.add("program", std::string("stickslip ") + version);
    run.add("revision", source_revision());
    run.add("ending", ending);
    run.add("simulated time", state.system.time, "s");
    if (!state.restarts.empty())
      {
        run.add_count("restarts", state.restarts.size());
        run.add("last restart at", state.restarts.back(), "s");
      }
    run.add_count("processes", Utilities::MPI::n_mpi_processes(communicator));
    summarise_meshes(summary, problem.meshes(), body_names);
    if (problem.is_coupled())
      summarise_problem(summary,
                        problem,
                        state.largest_gaps,
                        body_names,
                        names_of(scene.faults));
    if (!rate_solver.reason.empty())
      summary.add_section("Rate solver").add("chosen", text_of(rate_solver));
    summarise_steps(summary, state, scene.time.control);
    if (energy != nullptr && problem.is_coupled())
      summarise_energy(summary, *energy, state.system, scene.time.inertia);
    summarise_resources(summary,
                        section_times,
                        construction,
                        problem.is_coupled() ?
                          problem.hierarchy().memory_consumption() :
                          0.,
                        communicator);
    return summary;
  }



  template <int dim, int n_components>
  void
  print_warnings(std::ostream                      &out,
                 const double                       tolerance,
                 const RunState<dim, n_components> &state,
                 const double                       missing)
  {
    // Iterations leave far less.
    constexpr double allowed_part = 1e-3, allowed_by_mappings = 1e-2;

    const double       error   = state.steps.largest_error.faults;
    const EnergyTerms &work    = state.energy.work;
    const double       largest = work.largest();
    const char *const  unit    = dim == 2 ? " J/m" : " J";
    if (error > tolerance)
      out << "Warning: the estimated error of a time step reached " << error
          << ", more than Time/Tolerance = " << tolerance
          << ". Steps of one size do not follow the error." << std::endl;
    if (std::abs(missing) > allowed_part * largest)
      out << "Warning: " << missing << unit
          << " are missing in the balance of energy, " << missing / largest
          << " of the largest work (summary.txt)." << std::endl;
    if (std::abs(work.mappings) > allowed_by_mappings * largest)
      out << "Warning: new contact mappings have added " << work.mappings
          << unit << ", " << work.mappings / largest
          << " of the largest work (summary.txt). A smaller 'Contact/Rebuild "
             "fraction' makes that less."
          << std::endl;
  }



  template decltype(summarise_simulation<2>)    summarise_simulation<2>;
  template decltype(summarise_simulation<3>)    summarise_simulation<3>;
  template decltype(summarise_simulation<2, 1>) summarise_simulation<2, 1>;
  template decltype(print_warnings<2>)          print_warnings<2>;
  template decltype(print_warnings<3>)          print_warnings<3>;
  template decltype(print_warnings<2, 1>)       print_warnings<2, 1>;
} // namespace StickSlip
