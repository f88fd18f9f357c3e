// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <stickslip/base/agreement.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/output/interrupt.h>
#include <stickslip/scene/scene_checks.h>
#include <stickslip/simulation/energy_summary.h>
#include <stickslip/simulation/fault_snapshots.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/simulation/restraint.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/space_summary.h>
#include <stickslip/version.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::vector<BodyGeometry<dim>>
    geometries(const SceneParameters<dim> &scene)
    {
      std::vector<BodyGeometry<dim>> result;
      for (const BodyParameters<dim> &body : scene.bodies)
        result.push_back(body.geometry);
      return result;
    }



    /** The materials of the bodies, once they are known to make sense on the
     * finest meshes. */
    template <int dim>
    std::vector<MaterialFields>
    materials(const SceneParameters<dim> &scene,
              const MeshHierarchy<dim>   &meshes,
              const MPI_Comm             &communicator)
    {
      std::vector<MaterialFields> result;
      for (const BodyParameters<dim> &body : scene.bodies)
        result.push_back(body.material);
      carry_out_agreed(communicator,
                       [&]() { check_materials(meshes.finest(), result); });
      return result;
    }



    template <int dim>
    std::vector<std::string>
    body_names(const SceneParameters<dim> &scene)
    {
      std::vector<std::string> result;
      for (const BodyParameters<dim> &body : scene.bodies)
        result.push_back(body.name);
      return result;
    }



    template <int dim>
    std::vector<std::string>
    fault_names(const SceneParameters<dim> &scene)
    {
      std::vector<std::string> result;
      for (const FaultParameters &fault : scene.faults)
        result.push_back(fault.name);
      return result;
    }



    template <int dim>
    std::vector<bool>
    faults_that_follow(const SceneParameters<dim> &scene)
    {
      std::vector<bool> result;
      for (const FaultParameters &fault : scene.faults)
        result.push_back(fault.normal_stress_follows);
      return result;
    }



    /** The scene itself, if it runs on that many processes. */
    template <int dim>
    const SceneParameters<dim> &
    checked(const SceneParameters<dim> &scene, const MPI_Comm &communicator)
    {
      check_process_count(scene, Utilities::MPI::n_mpi_processes(communicator));
      return scene;
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const SceneParameters<dim> &scene,
                              const MPI_Comm             &communicator)
    : scene(checked(scene, communicator))
    , communicator(communicator)
    , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
    , mesh_hierarchy(geometries(scene), scene.topology, communicator)
    , boundary_values(mesh_hierarchy,
                      scene.boundary_conditions,
                      body_names(scene))
    , problem(mesh_hierarchy,
              materials(scene, mesh_hierarchy, communicator),
              boundary_values,
              scene.gravity_vector(),
              scene.time.inertia == Inertia::dynamic,
              make_slip_rates(scene))
    , step_size_range(scene.time.end_time, 0.)
  {
    construction_timer.stop();
  }



  template <int dim>
  bool
  Simulation<dim>::run()
  {
    set_up();

    // From here on a signal ends the run after the current step.
    const Interrupt interrupt;
    const auto      faults_now = [&]() {
      return make_fault_snapshots(current,
                                  faults,
                                  problem.jump_basis(),
                                  fault_names(scene));
    };
    record = std::make_unique<RunRecord<dim>>(scene,
                                              mesh_hierarchy.finest(),
                                              faults_now());
    record->add(StepRecord(), current, faults_now());
    bool interrupted = false;
    try
      {
        while (!is_finished() && !interrupted)
          {
            advance();
            interrupted = interrupt.is_requested(communicator);
          }
        std::ostringstream how;
        how << (is_finished() ? "reached the end time" :
                                "interrupted by the user")
            << ", t = " << current.time << " s";
        ending = how.str();
      }
    catch (const std::exception &error)
      {
        // If only some processes have failed, the others are elsewhere in the
        // program and cannot take part any more.
        if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
            dynamic_cast<const AgreedFailure *>(&error))
          {
            ending = error.what();
            record->finish(summarise());
          }
        throw;
      }
    record->finish(summarise());
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::cout << "Run " << ending << ". Results are in "
                  << scene.output.directory << '.' << std::endl;
        const double error = step_size_controller->largest_estimated_error();
        if (error > scene.time.tolerance)
          std::cout << "Warning: the estimated error of a time step reached "
                    << error
                    << ", more than Time/Tolerance = " << scene.time.tolerance
                    << ". Steps of one size do not follow the error."
                    << std::endl;
      }
    return is_finished();
  }



  template <int dim>
  void
  Simulation<dim>::set_up()
  {
    TimerOutput::Scope section(timer, "Initial equilibrium");

    const InitialEquilibrium<dim> equilibrium =
      solve_initial_equilibrium(problem);
    equilibrium_iterations = equilibrium.iterations;

    const JumpBasis<dim> &basis = problem.jump_basis();
    faults                      = FaultNodes<dim>(
      basis,
      problem.hierarchy().finest().nodes,
      make_node_laws(scene, basis),
      make_normal_stress(scene, basis, equilibrium, nodes_in_tension));
    check_restraint(scene, faults);
    current = make_initial_state(scene, basis, equilibrium);
    const std::vector<bool> follow = faults_that_follow(scene);
    if (std::find(follow.begin(), follow.end(), true) != follow.end())
      following_stress =
        FollowingStress<dim>(follow, faults, current.contact_pressure);
    slip_at_build = current.slip;
    if (scene.output.energy_balance)
      energy = std::make_unique<EnergyBalance<dim>>(problem, faults, current);

    rate_state_step = std::make_unique<RateStateStep<dim>>(
      problem, faults, scene.time, scene.tnnmg, following_stress);
    step_size_controller = make_step_size_controller(*rate_state_step,
                                                     faults,
                                                     scene.time,
                                                     boundary_values);
  }



  template <int dim>
  void
  Simulation<dim>::advance()
  {
    std::vector<StepResult<dim>> accepted;
    {
      TimerOutput::Scope section(timer, "Time steps");
      accepted = step_size_controller->advance(current);
    }
    for (StepResult<dim> &step : accepted)
      accept(std::move(step));
    if (scene.contact.follow_slip)
      rebuild_contact_if_slid();
  }



  template <int dim>
  void
  Simulation<dim>::accept(StepResult<dim> &&step)
  {
    current = std::move(step.state);
    ++step_number;
    accepted_counts += step.counts;
    step_size_range.first  = std::min(step_size_range.first, step.step_size);
    step_size_range.second = std::max(step_size_range.second, step.step_size);

    if (following_stress.is_needed())
      {
        // A later step may have set another one.
        following_stress.apply(faults, current.contact_pressure);
        most_in_tension =
          std::max(most_in_tension,
                   following_stress.n_in_tension(faults,
                                                 current.contact_pressure));
      }
    if (energy)
      {
        TimerOutput::Scope section(timer, "Energy balance");
        energy->add(current);
      }
    TimerOutput::Scope section(timer, "Output");
    if (record)
      {
        StepRecord row;
        row.step                  = step_number;
        row.time                  = current.time;
        row.step_size             = step.step_size;
        row.rate_state_iterations = step.counts.rate_state_iterations;
        row.tnnmg_iterations      = step.counts.tnnmg_iterations;
        row.multigrid_cycles      = step.counts.multigrid_cycles;
        record->add(row,
                    current,
                    make_fault_snapshots(current,
                                         faults,
                                         problem.jump_basis(),
                                         fault_names(scene)));
      }
  }



  template <int dim>
  void
  Simulation<dim>::rebuild_contact_if_slid()
  {
    const JumpBasis<dim> &basis         = problem.jump_basis();
    double                smallest_face = std::numeric_limits<double>::max();
    for (const FaultContact<dim> &contact : basis.faults())
      smallest_face = std::min(smallest_face, contact.smallest_face);
    if (largest_slip<dim>(current, slip_at_build) <=
        scene.contact.rebuild_fraction * smallest_face)
      return;

    TimerOutput::Scope    section(timer, "Contact mapping");
    const FaultNodes<dim> before = std::move(faults);
    problem.build_contact(current.displacement);
    faults = FaultNodes<dim>(problem.jump_basis(),
                             problem.hierarchy().finest().nodes,
                             before.laws(),
                             before.normal_stress());
    rate_state_step->reinit();
    slip_at_build = current.slip;

    // The slip rates belong to the nodes of the fault and stay; the velocity of
    // the slave side follows from them and from the new partners. Nodes that
    // come into contact get the jump of the velocities as they are.
    const auto follow = [&](NodalVector                     &velocity,
                            std::vector<Tensor<1, dim - 1>> &slip_rate) {
      NodalVector w = problem.make_vector();
      problem.to_jumps(w, velocity);
      for (const unsigned int k : faults.owned_contact())
        {
          w.local_element(faults.node(k) * dim + dim - 1) = 0.;
          if (before.in_contact(k))
            for (unsigned int d = 0; d < dim - 1; ++d)
              w.local_element(faults.node(k) * dim + d) = slip_rate[k][d];
        }
      problem.to_nodal(velocity, w);
      slip_rate = faults.tangential_jumps(w);
    };
    follow(current.velocity, current.slip_rate);
    if (current.mean_velocity.size() > 0)
      follow(current.mean_velocity, current.mean_slip_rate);
    // That of nodes off contact means nothing any more.
    for (unsigned int k = 0; k < current.balancing_traction.size(); ++k)
      if (!faults.in_contact(k))
        current.balancing_traction[k] = Tensor<1, dim - 1>();
    if (energy)
      energy->reinit(current);
  }



  template <int dim>
  bool
  Simulation<dim>::is_finished() const
  {
    return step_size_controller->is_finished(current.time);
  }



  template <int dim>
  RunSummary
  Simulation<dim>::summarise() const
  {
    RunSummary summary;
    summary.add("Run", "program", std::string("stickslip ") + version);
    summary.add("Run", "ending", ending);
    summary.add("Run", "simulated time", current.time, "s");
    summary.add_count("Run",
                      "processes",
                      Utilities::MPI::n_mpi_processes(communicator));
    summarise_meshes(summary, mesh_hierarchy, body_names(scene));
    if (problem.is_coupled())
      summarise_problem(summary,
                        problem,
                        body_names(scene),
                        fault_names(scene));

    summary.add_count("Steps", "accepted", step_number);
    summary.add_count("Steps", "rejected", step_size_controller->n_rejected());
    summary.add_count("Steps", "solved", rate_state_step->n_steps());
    summary.add("Steps", "smallest step size", step_size_range.first, "s");
    summary.add("Steps", "largest step size", step_size_range.second, "s");
    if (scene.time.control != StepSizeControl::step_doubling)
      summary.add("Steps",
                  "largest estimated error",
                  step_size_controller->largest_estimated_error());
    summary.add_count("Steps", "contact mappings built", problem.n_builds());

    const StepCounts &all        = rate_state_step->total_counts();
    const auto        add_counts = [&](const std::string &key,
                                const unsigned int accepted,
                                const unsigned int total) {
      summary.add_count("Iterations", key + ", accepted steps", accepted);
      summary.add_count("Iterations", key + ", all steps", total);
      summary.add("Iterations",
                  key + ", per accepted step",
                  double(accepted) / std::max(step_number, 1u));
    };
    summary.add_count("Iterations", "CG at the start", equilibrium_iterations);
    add_counts("rate-state",
               accepted_counts.rate_state_iterations,
               all.rate_state_iterations);
    add_counts("TNNMG", accepted_counts.tnnmg_iterations, all.tnnmg_iterations);
    add_counts("multigrid cycles",
               accepted_counts.multigrid_cycles,
               all.multigrid_cycles);
    if (nodes_in_tension > 0)
      summary.add_count("Faults",
                        "nodes in tension at the start, without friction",
                        nodes_in_tension);

    if (most_in_tension > 0)
      summary.add_count("Faults",
                        "most nodes in tension at a time",
                        most_in_tension);

    if (energy && problem.is_coupled())
      summarise_energy(summary, *energy, current, scene.time.inertia);

    summary.add("Wall time",
                "Meshes and matrices",
                construction_timer.last_wall_time(),
                "s");
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
    if (problem.is_coupled())
      add_memory(
        "level hierarchy",
        Utilities::MPI::sum(double(problem.hierarchy().memory_consumption()),
                            communicator));
    return summary;
  }



  template <int dim>
  const SystemState<dim> &
  Simulation<dim>::state() const
  {
    return current;
  }



  template <int dim>
  const MeshHierarchy<dim> &
  Simulation<dim>::meshes() const
  {
    return mesh_hierarchy;
  }



  template <int dim>
  SpatialProblem<dim> &
  Simulation<dim>::spatial_problem()
  {
    return problem;
  }



  template <int dim>
  FaultNodes<dim> &
  Simulation<dim>::fault_nodes()
  {
    return faults;
  }



  template <int dim>
  const EnergyBalance<dim> *
  Simulation<dim>::energy_balance() const
  {
    return energy.get();
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace StickSlip
