// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/interrupt.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/simulation/checked_scene.h>
#include <stickslip/simulation/contact_change.h>
#include <stickslip/simulation/fault_snapshots.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/simulation/restraint.h>
#include <stickslip/simulation/run_ending.h>
#include <stickslip/simulation/run_state_file.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/simulation_summary.h>

#include <algorithm>
#include <iostream>

namespace StickSlip
{
  template <int dim>
  Simulation<dim>::Simulation(const SceneParameters<dim> &scene,
                              const MPI_Comm             &communicator)
    : scene(checked_scene(scene, communicator))
    , communicator(communicator)
    , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
    , mesh_hierarchy(members_of(scene.bodies, &BodyParameters<dim>::geometry),
                     scene.topology,
                     communicator)
    , boundary_values(mesh_hierarchy,
                      scene.boundary_conditions,
                      names_of(scene.bodies))
    , problem(mesh_hierarchy,
              checked_materials(scene, mesh_hierarchy, communicator),
              boundary_values,
              scene.gravity_vector(),
              scene.time.inertia == Inertia::dynamic,
              make_slip_rates(scene))
    , laws(make_node_laws(scene, problem.jump_basis()))
  {
    construction_timer.stop();
  }



  template <int dim>
  bool
  Simulation<dim>::run()
  {
    if (!step_size_controller)
      set_up();
    open_record();

    // From here on a signal ends the run after the current step.
    const Interrupt interrupt;
    try
      {
        while (!is_finished() && !interrupt.is_requested(communicator))
          advance();
      }
    catch (const std::exception &error)
      {
        if (is_known_to_all(error, communicator))
          finish(error.what());
        throw;
      }
    const std::string ending = describe_ending(is_finished(), state().time);
    finish(ending);
    print_ending(ending,
                 scene.output.directory,
                 run_state.steps.largest_error,
                 scene.time.tolerance,
                 communicator);
    return is_finished();
  }



  template <int dim>
  void
  Simulation<dim>::set_up()
  {
    TimerOutput::Scope section(timer, "Initial equilibrium");

    const InitialEquilibrium<dim> equilibrium =
      solve_initial_equilibrium(problem);
    RunCounts &counts             = run_state.counts;
    counts.contact_mappings       = 1;
    counts.equilibrium_iterations = equilibrium.iterations;
    counts.smallest_step          = scene.time.end_time;

    SystemState<dim> &start = run_state.system;
    start                   = make_initial_state(scene,
                               problem.jump_basis(),
                               equilibrium,
                               counts.initially_in_tension);
    for (unsigned int k = 0; k < start.contact_pressure.size(); ++k)
      run_state.stress_offset.push_back(start.normal_stress[k] -
                                        start.contact_pressure[k]);
    run_state.coupled_displacement = problem.make_nodal_vector();
    run_state.coupled_slip         = start.slip;

    prepare();
    check_restraint(scene, faults, laws, start);
    if (energy)
      energy->start(start);
  }



  template <int dim>
  void
  Simulation<dim>::resume(const std::string &file_name)
  {
    run_state = read_run_state(file_name, mesh_hierarchy.finest());
    couple();
  }



  template <int dim>
  void
  Simulation<dim>::write_state(const std::string &file_name)
  {
    if (record)
      run_state.record = record->state();
    write_run_state(file_name, run_state, mesh_hierarchy.finest());
    couple();
  }



  template <int dim>
  void
  Simulation<dim>::couple()
  {
    problem.build_contact(run_state.coupled_displacement);
    prepare();
  }



  template <int dim>
  void
  Simulation<dim>::prepare()
  {
    faults =
      FaultNodes<dim>(problem.jump_basis(), problem.hierarchy().finest().nodes);
    following_stress =
      FollowingStress<dim>(members_of(scene.faults,
                                      &FaultParameters::normal_stress_follows),
                           faults,
                           run_state.stress_offset);
    // Controller and step of the mapping before go first.
    step_size_controller.reset();
    rate_state_step.reset();
    rate_state_step = std::make_unique<RateStateStep<dim>>(
      problem, faults, laws, scene.time, scene.tnnmg, following_stress);
    step_size_controller =
      make_step_size_controller(*rate_state_step, scene.time, boundary_values);
    if (scene.output.energy_balance)
      energy = std::make_unique<EnergyBalance<dim>>(problem,
                                                    faults,
                                                    laws,
                                                    run_state.energy);
  }



  template <int dim>
  void
  Simulation<dim>::advance()
  {
    std::vector<StepResult<dim>> accepted;
    {
      TimerOutput::Scope section(timer, "Time steps");
      accepted = step_size_controller->advance(state(), run_state.steps);
    }
    for (StepResult<dim> &step : accepted)
      accept(std::move(step));
    if (scene.contact.follow_slip &&
        has_slid<dim>(problem.jump_basis(),
                      state().slip,
                      run_state.coupled_slip,
                      scene.contact.rebuild_fraction))
      follow_contact();
  }



  template <int dim>
  void
  Simulation<dim>::accept(StepResult<dim> &&step)
  {
    RunCounts &counts = run_state.counts;
    counts.add(step.step_size, step.counts);
    run_state.system = std::move(step.state);
    if (following_stress.is_needed())
      counts.most_in_tension = std::max(
        counts.most_in_tension,
        following_stress.n_in_tension(faults, laws, state().contact_pressure));
    if (energy)
      {
        TimerOutput::Scope section(timer, "Energy balance");
        energy->add(state());
      }
    TimerOutput::Scope section(timer, "Output");
    if (record)
      record->add({counts.accepted,
                   state().time,
                   step.step_size,
                   step.counts.rate_state_iterations,
                   step.counts.tnnmg_iterations,
                   step.counts.multigrid_cycles},
                  state(),
                  fault_snapshots());
  }



  template <int dim>
  void
  Simulation<dim>::follow_contact()
  {
    TimerOutput::Scope section(timer, "Contact mapping");
    SystemState<dim>  &current = run_state.system;
    ++run_state.counts.contact_mappings;
    run_state.coupled_displacement = current.displacement;
    run_state.coupled_slip         = current.slip;
    const FaultNodes<dim> before   = faults;
    couple();
    change_contact(current, problem, before, faults);
    if (energy)
      energy->restart(current);
  }



  template <int dim>
  bool
  Simulation<dim>::is_finished() const
  {
    return step_size_controller->is_finished(state().time);
  }



  template <int dim>
  std::vector<FaultSnapshot<dim>>
  Simulation<dim>::fault_snapshots() const
  {
    return make_fault_snapshots(
      state(), faults, laws, problem.jump_basis(), names_of(scene.faults));
  }



  template <int dim>
  void
  Simulation<dim>::open_record()
  {
    record = std::make_unique<RunRecord<dim>>(scene,
                                              mesh_hierarchy.finest(),
                                              fault_snapshots());
    if (run_state.counts.accepted == 0)
      record->add(StepRecord(), state(), fault_snapshots());
    else
      record->resume(run_state.record);
  }



  template <int dim>
  void
  Simulation<dim>::finish(const std::string &ending)
  {
    record->finish(state(),
                   summarise_simulation(ending,
                                        scene,
                                        problem,
                                        run_state,
                                        energy.get(),
                                        timer,
                                        construction_timer.last_wall_time(),
                                        communicator));
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace StickSlip
