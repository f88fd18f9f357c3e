// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/output/interrupt.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_checks.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/contact_change.h>
#include <stickslip/simulation/fault_snapshots.h>
#include <stickslip/simulation/initial_balance.h>
#include <stickslip/simulation/initial_motion.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/kept_tractions.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/simulation/node_openings.h>
#include <stickslip/simulation/restraint.h>
#include <stickslip/simulation/run_state_file.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/simulation_summary.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** A force that goes from the last value of another one to zero, as fast as
     * that has changed. If sides slip less than was foreseen, it must not pull
     * at them for ever. */
    PartnerForce
    fading(const PartnerForce &force, const double time)
    {
      PartnerForce result{force.last, force.last, time, force.rate};
      result.last = 0.;
      return result;
    }



    /** The scene itself, if it runs on that many processes. */
    template <int dim>
    const SceneParameters<dim> &
    checked_scene(const SceneParameters<dim> &scene,
                  const MPI_Comm             &communicator)
    {
      check_process_count(scene, Utilities::MPI::n_mpi_processes(communicator));
      return scene;
    }



    /** The materials of the bodies, if they make sense on the finest meshes. */
    template <int dim>
    std::vector<MaterialFields>
    checked_materials(const SceneParameters<dim> &scene,
                      const MeshHierarchy<dim>   &meshes,
                      const MPI_Comm             &communicator)
    {
      const std::vector<MaterialFields> materials =
        members_of(scene.bodies, &BodyParameters<dim>::material);
      carry_out_agreed(communicator,
                       [&]() { check_materials(meshes.finest(), materials); });
      return materials;
    }



    TimeParameters
    with_solver(TimeParameters parameters, const RateSolver solver)
    {
      parameters.rate_solver = solver;
      return parameters;
    }
  } // namespace



  template <int dim, int n_components>
  Simulation<dim, n_components>::Simulation(const SceneParameters<dim> &scene,
                                            const MPI_Comm &communicator)
    : scene(checked_scene(scene, communicator))
    , communicator(communicator)
    , mesh_hierarchy(scene.coarse_bodies(),
                     scene.topology,
                     communicator,
                     MeshHierarchy<dim>::usual_nodes_per_process,
                     n_components)
    , boundary_values(mesh_hierarchy,
                      scene.boundary_conditions,
                      names_of(scene.bodies))
    , problem(mesh_hierarchy,
              checked_materials(scene, mesh_hierarchy, communicator),
              boundary_values,
              scene.gravity_vector(),
              scene.time.inertia == Inertia::dynamic,
              make_slip_rates(scene),
              BackgroundStress<dim>(scene.faults),
              make_opening_parts(scene))
    , rate_solver(
        choose_rate_solver(this->scene.time, this->scene.tnnmg, problem))
    , time_parameters(with_solver(this->scene.time, rate_solver.solver))
    , laws(make_node_laws(scene, problem.jump_basis()))
    , openings(make_node_openings(scene, problem))
  {
    AssertDimension(scene.n_components(), n_components);
    construction_timer.stop();
  }



  template <int dim, int n_components>
  bool
  Simulation<dim, n_components>::run()
  {
    if (!step_size_controller)
      set_up();
    open_record();
    if (!rate_solver.reason.empty() &&
        Utilities::MPI::this_mpi_process(communicator) == 0)
      std::cout << "Rate solver: " << text_of(rate_solver) << '.' << std::endl;
    if (scene.time.control == StepSizeControl::central_differences &&
        Utilities::MPI::this_mpi_process(communicator) == 0)
      std::cout << "Central differences: steps of "
                << step_size_controller->longest_step()
                << " s are stable, at least "
                << std::ceil((scene.time.end_time - state().time) /
                             step_size_controller->longest_step())
                << " of them." << std::endl;

    // From here on a signal ends the run after the current step.
    const Interrupt interrupt;
    must_stop = [&]() { return interrupt.is_requested(communicator); };
    step_size_controller->stop_if(must_stop);
    Checkpoints checkpoints(scene.output, state().time, communicator);
    try
      {
        bool is_written = false;
        while (!is_finished() && !must_stop())
          {
            try
              {
                advance();
              }
            catch (const StepInterrupted &)
              {
                break;
              }
            is_written = checkpoints.is_due(state().time);
            if (is_written)
              write_checkpoint(checkpoints);
          }
        if (checkpoints.are_written() && !is_written)
          write_checkpoint(checkpoints);
      }
    catch (const std::exception &error)
      {
        // If only some processes fail, the others are elsewhere in the program
        // and cannot take part in anything any more.
        if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
            dynamic_cast<const AgreedFailure *>(&error) != nullptr ||
            dynamic_cast<const InputError *>(&error) != nullptr)
          try
            {
              finish(sentence(error));
            }
          catch (const std::exception &)
            {
              // Files that cannot be written are no news.
            }
        throw;
      }
    std::ostringstream ending;
    ending << (is_finished() ? "reached the end time" :
                               "interrupted by the user")
           << ", t = " << state().time << " s";
    finish(ending.str());
    const double missing = energy ? energy->defect(state()) : 0.;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::cout << "Run " << ending.str() << ". Results are in "
                  << scene.output.directory << '.' << std::endl;
        print_warnings(std::cout, scene.time.tolerance, run_state, missing);
      }
    return is_finished();
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::set_up()
  {
    SectionTimes::Scope section(times, "Initial equilibrium");

    const InitialEquilibrium<dim> equilibrium =
      solve_initial_equilibrium(problem);
    RunCounts &counts             = run_state.counts;
    counts.contact_mappings       = 1;
    counts.equilibrium_iterations = equilibrium.iterations;
    counts.smallest_step          = scene.time.end_time;

    InitialState<dim> start =
      make_initial_state(scene, problem.jump_basis(), equilibrium, openings);
    counts.initially_in_tension = start.n_in_tension;
    run_state.system            = std::move(start.system);
    if (!state().contact_pressure.empty())
      run_state.stress_offset = std::move(start.stress_offset);
    run_state.coupled_displacement = problem.make_nodal_vector();
    run_state.coupling.slip        = state().slip;

    prepare();
    note_gaps();
    run_state.prestress =
      start_motion(scene, faults, laws, problem, run_state.system);
    check_restraint(scene, faults, laws, state());
    if (energy)
      energy->start(state());
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::resume(const std::string &file_name)
  {
    run_state =
      read_run_state<dim, n_components>(file_name, mesh_hierarchy.finest());
    run_state.restarts.push_back(state().time);
    problem.build_contact(run_state.coupled_displacement,
                          run_state.coupling.expected_slip);
    problem.set_prestress(run_state.prestress);
    problem.set_partner_force(std::move(run_state.partner_force));
    prepare();
    if (energy)
      energy->resume(state());
    rate_state_step->recall(run_state.linearisations);
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::write_state(const std::string &file_name)
  {
    if (record)
      {
        run_state.record          = record->state();
        run_state.recorded_faults = record->faults();
      }
    run_state.partner_force  = problem.partner_force();
    run_state.linearisations = rate_state_step->kept_linearisations();
    write_run_state(file_name,
                    run_state,
                    mesh_hierarchy.finest(),
                    entries_of(scene));
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::prepare()
  {
    faults =
      FaultNodes<dim>(problem.jump_basis(), problem.hierarchy().finest().nodes);
    following_stress =
      FollowingStress<dim>(members_of(scene.faults,
                                      &FaultParameters::normal_stress_follows),
                           faults,
                           run_state.stress_offset,
                           openings);
    // Controller and step of the mapping before go first.
    step_size_controller.reset();
    rate_state_step.reset();
    rate_state_step = std::make_unique<RateStateStep<dim, n_components>>(
      problem,
      faults,
      laws,
      time_parameters,
      scene.tnnmg,
      following_stress,
      UnilateralContact<dim>(faults, openings, run_state.stress_offset));
    step_size_controller =
      make_step_size_controller(*rate_state_step, scene.time, boundary_values);
    step_size_controller->stop_if(must_stop);
    if (scene.output.energy_balance)
      energy = std::make_unique<EnergyBalance<dim, n_components>>(
        problem,
        faults,
        laws,
        run_state.energy,
        step_size_controller->lumped_mass());
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::advance()
  {
    std::vector<StepResult<dim>> accepted;
    try
      {
        SectionTimes::Scope section(times, "Time steps");
        accepted = step_size_controller->advance(state(), run_state.steps);
      }
    catch (const StepSizeTooSmall &failure)
      {
        std::string causes = explain_failure(scene, faults, state());
        if (run_state.counts.accepted == 0)
          for (const std::string &cause : what_friction_does_not_hold(
                 scene, faults, fault_points(), laws, state()))
            causes += " " + cause;
        throw StepSizeTooSmall(failure.what() + causes);
      }
    for (StepResult<dim> &step : accepted)
      accept(std::move(step));
    // Slip out of the plane moves no node along the fault.
    if (scene.contact.follow_slip && n_components == dim &&
        has_slid(
          faults, state().slip, run_state.coupling.slip, sliding_distances()))
      follow_contact();
    else if (const PartnerForce &force = problem.partner_force();
             force.is_there() && state().time >= force.end())
      problem.set_partner_force(fading(force, state().time));
  }



  template <int dim, int n_components>
  std::vector<Point<dim>>
  Simulation<dim, n_components>::fault_points() const
  {
    std::vector<Point<dim>> points;
    for (const FaultContact<dim> &fault : problem.jump_basis().faults())
      points.insert(points.end(),
                    fault.slave.points.begin(),
                    fault.slave.points.end());
    return points;
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::accept(StepResult<dim> &&step)
  {
    RunCounts &counts = run_state.counts;
    counts.add(step.step_size, step.counts);
    const std::vector<Tensor<1, dim - 1>> tractions =
      shear_tractions(faults, laws, step.state);
    if (energy)
      {
        SectionTimes::Scope section(times, "Energy balance");
        complete_step(step);
        energy->add(step, tractions);
      }
    run_state.system = std::move(step.state);
    if (following_stress.is_needed())
      counts.most_in_tension = std::max(
        counts.most_in_tension,
        following_stress.n_in_tension(faults, laws, state().contact_pressure));
    SectionTimes::Scope section(times, "Output");
    if (record)
      record->add({counts.accepted,
                   state().time,
                   step.step_size,
                   step.counts.rate_state_iterations,
                   step.counts.tnnmg_iterations,
                   step.counts.multigrid_cycles,
                   run_state.steps.last_error.faults,
                   run_state.steps.last_error.bodies},
                  state(),
                  fault_snapshots(tractions),
                  energy.get());
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::complete_step(StepResult<dim> &step)
  {
    SystemState<dim> &to = step.state;
    if (to.is_complete)
      return;
    step_size_controller->complete(to);
    to.mean_velocity = to.displacement;
    to.mean_velocity -= state().displacement;
    to.mean_velocity /= step.step_size;
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::complete_state()
  {
    step_size_controller->complete(run_state.system);
  }



  template <int dim, int n_components>
  std::vector<double>
  Simulation<dim, n_components>::sliding_distances() const
  {
    return StickSlip::sliding_distances(problem.jump_basis(), scene.contact);
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::follow_contact()
  {
    SectionTimes::Scope section(times, "Contact mapping");
    complete_state();
    SystemState<dim> &current = run_state.system;
    ++run_state.counts.contact_mappings;
    const double kinetic_energy = energy ? energy->kinetic_energy(current) : 0.;
    const KeptTractions<dim, n_components> tractions(
      problem, faults, laws, current, step_size_controller->lumped_mass());
    const std::vector<double> distances = sliding_distances();
    MappingPlace<dim>         place{
      current.slip,
      expected_slip(faults, current.slip, run_state.coupling.slip, distances)};
    const double part_to_end =
      way_to_end(problem.jump_basis(), run_state.coupling, place);
    run_state.coupling               = std::move(place);
    run_state.coupled_displacement   = current.displacement;
    const FaultNodes<dim>     before = faults;
    const std::vector<double> background_before =
      background_normal_stress(problem.background_stress(),
                               problem.jump_basis());
    const std::vector<double> distances_before =
      distances_of_gaps(problem, current);
    const std::vector<Tensor<1, dim - 1>> accelerations_before =
      slip_accelerations(problem, faults, current);
    problem.build_contact(run_state.coupled_displacement,
                          run_state.coupling.expected_slip);
    // Normals that have turned meet another background stress.
    const std::vector<double> background =
      background_normal_stress(problem.background_stress(),
                               problem.jump_basis());
    for (unsigned int k = 0; k < background.size(); ++k)
      run_state.stress_offset[k] += background[k] - background_before[k];
    prepare();
    note_gaps();
    change_contact(
      current, problem, before, faults, distances_before, accelerations_before);
    current.fault_force.clear();
    problem.set_partner_force(
      tractions.force(current,
                      step_size_controller->lumped_mass(),
                      part_to_end,
                      n_intervals(faults, current.slip_rate, distances)));
    if (energy)
      energy->restart(current, kinetic_energy);
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::note_gaps()
  {
    // A gap of this part of a face changes where forces act as the mesh does.
    constexpr double allowed_part = 0.05;

    const std::vector<std::optional<LargestGap>> &gaps = problem.gaps();
    run_state.largest_gaps.resize(gaps.size(),
                                  std::numeric_limits<double>::quiet_NaN());
    for (unsigned int f = 0; f < gaps.size(); ++f)
      if (gaps[f])
        {
          double &largest = run_state.largest_gaps[f];
          largest         = std::isnan(largest) ? gaps[f]->absolute :
                                                  std::max(largest, gaps[f]->absolute);
          // Sides that may part are apart without harm.
          if (scene.contact.follow_slip && !scene.faults[f].may_open() &&
              gaps[f]->over_face > allowed_part)
            {
              std::ostringstream message;
              message
                << "The sides of the fault '" << scene.faults[f].name
                << "' are up to " << gaps[f]->absolute << " m apart, "
                << gaps[f]->over_face << " of a face, at t = " << state().time
                << " s: the mesh must resolve the bends that they slide over, "
                   "and 'Contact/Rebuild fraction' be small enough.";
              throw AgreedFailure(message.str());
            }
        }
  }



  template <int dim, int n_components>
  std::vector<FaultSnapshot<dim>>
  Simulation<dim, n_components>::fault_snapshots(
    const std::vector<Tensor<1, dim - 1>> &tractions) const
  {
    std::vector<bool> may_open;
    for (const FaultParameters &fault : scene.faults)
      may_open.push_back(fault.may_open());
    std::vector<FaultSnapshot<dim>> snapshots =
      make_fault_snapshots(state(),
                           faults,
                           state().mean_traction.empty() ?
                             tractions :
                             state().mean_traction,
                           problem.jump_basis(),
                           names_of(scene.faults),
                           may_open);
    for (unsigned int f = 0; f < snapshots.size(); ++f)
      snapshots[f].largest_gap = run_state.largest_gaps[f];
    return snapshots;
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::open_record()
  {
    const bool                      goes_on = !run_state.restarts.empty();
    std::vector<FaultSnapshot<dim>> snapshots =
      fault_snapshots(shear_tractions(faults, laws, state()));
    for (unsigned int f = 0; f < run_state.recorded_faults.size(); ++f)
      {
        FaultSnapshot<dim> &recorded = run_state.recorded_faults[f];
        recorded.name                = snapshots[f].name;
        recorded.points              = snapshots[f].points;
        snapshots[f]                 = recorded;
      }
    record = std::make_unique<RunRecord<dim, n_components>>(
      scene,
      problem,
      snapshots,
      [this]() { complete_state(); },
      [this](const SystemState<dim>             &state,
             const std::vector<NodalFunctional> &functionals) {
        return step_size_controller->body_values(state, functionals);
      },
      goes_on ? &run_state.record : nullptr);
    if (!goes_on)
      record->add(StepRecord(), state(), snapshots, energy.get());
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::write_checkpoint(Checkpoints &checkpoints)
  {
    SectionTimes::Scope section(times, "Checkpoints");
    write_state(checkpoints.file(run_state.counts.accepted));
    checkpoints.note_written(state().time);
  }



  template <int dim, int n_components>
  void
  Simulation<dim, n_components>::finish(const std::string &ending)
  {
    record->finish(state(),
                   summarise_simulation(ending,
                                        scene,
                                        problem,
                                        run_state,
                                        energy.get(),
                                        rate_solver,
                                        times,
                                        construction_timer.last_wall_time(),
                                        communicator),
                   energy.get());
  }



  template class Simulation<2>;
  template class Simulation<3>;
  template class Simulation<2, 1>;
} // namespace StickSlip
