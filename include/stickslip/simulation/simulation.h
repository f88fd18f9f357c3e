// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_simulation_h
#define stickslip_simulation_simulation_h

#include <deal.II/base/timer.h>

#include <stickslip/base/section_times.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/simulation/checkpoints.h>
#include <stickslip/simulation/run_record.h>
#include <stickslip/simulation/run_state.h>
#include <stickslip/time/rate_solver_choice.h>
#include <stickslip/time/step_size_control.h>

#include <functional>

namespace StickSlip
{
  /**
   * The step program: owns everything that belongs to one scene, and runs it.
   * Whatever changes from step to step is in a RunState.
   *
   * Members are declared in the order in which they depend on each other.
   */
  template <int dim, int n_components = dim>
  class Simulation
  {
  public:
    /** Builds the meshes and the matrices. Nothing is written yet. */
    Simulation(const SceneParameters<dim> &scene, const MPI_Comm &communicator);

    /**
     * Run the scene to its end time, or until the user interrupts it.
     * Whatever happens, the files written are complete and hold the last good
     * state. Starts with set_up(), or goes on, also in its files, with the run
     * that was resumed. Throws StepSizeTooSmall if no step can be taken.
     * Returns whether the end time was reached.
     */
    bool
    run();

    /** Start at the static equilibrium. */
    void
    set_up();

    /** Go on from the state in a file of write_state(), on any number of
     * processes. Throws InputError if there is no such file or if it is of
     * another scene. Collective. */
    void
    resume(const std::string &file_name);

    /**
     * Write everything that a run needs to go on from the present state; on the
     * same number of processes the one that is resumed goes on with the same
     * bits as this one, which does not notice. Throws InputError if the file
     * cannot be written. Collective.
     */
    void
    write_state(const std::string &file_name);

    /** One advance of the step size control, one or more accepted steps; the
     * contact mapping follows if that is due. */
    void
    advance();

    bool
    is_finished() const
    {
      return step_size_controller->is_finished(state().time);
    }

    /** Let the bodies of the state follow its faults, where steps leave that to
     * those who look at them (Time/Step size control = Runge-Kutta). */
    void
    complete_state();

    /** The state reached. */
    const SystemState<dim> &
    state() const
    {
      return run_state.system;
    }

    /** Steps, work and contact mappings up to now. */
    const RunCounts &
    counts() const
    {
      return run_state.counts;
    }

    const MeshHierarchy<dim> &
    meshes() const
    {
      return mesh_hierarchy;
    }

    SpatialProblem<dim, n_components> &
    spatial_problem()
    {
      return problem;
    }

    const FaultNodes<dim> &
    fault_nodes() const
    {
      return faults;
    }

    const NodeLaws &
    node_laws() const
    {
      return laws;
    }

    /** The positions of all slave nodes before any displacement, m. */
    std::vector<Point<dim>>
    fault_points() const;

    /** Null where the scene asks for none. */
    const EnergyBalance<dim, n_components> *
    energy_balance() const
    {
      return energy.get();
    }

  private:
    /** Make everything anew that depends on the contact mapping: at the start,
     * with a new mapping and where a run is resumed. */
    void
    prepare();

    void
    accept(StepResult<dim> &&step);

    /** Let the bodies follow the faults, if a step has left that: for the
     * energy, at the end of the step @p step from the present state. */
    void
    complete_step(StepResult<dim> &step);

    /** sliding_distances() of this scene. */
    std::vector<double>
    sliding_distances() const;

    /** Couple the faults anew if a node has slid too far since the last time.
     */
    void
    follow_contact();

    /** Take in the gaps of a new contact mapping. Throws AgreedFailure if
     * the sides of a fault have come apart. */
    void
    note_gaps();

    /** The fields of the faults, with @p tractions by shear_tractions(). */
    std::vector<FaultSnapshot<dim>>
    fault_snapshots(const std::vector<Tensor<1, dim - 1>> &tractions) const;

    /** Create the files of a run, with the present state if it is the first.
     */
    void
    open_record();

    void
    write_checkpoint(Checkpoints &checkpoints);

    /** Complete the files of a run that has ended. */
    void
    finish(const std::string &ending);

    const SceneParameters<dim> scene;
    const MPI_Comm             communicator;
    Timer                      construction_timer;
    SectionTimes               times;

    MeshHierarchy<dim>                mesh_hierarchy;
    BoundaryValues<dim, n_components> boundary_values;
    SpatialProblem<dim, n_components> problem;
    /** The solver of the rate problems, and settings with it. */
    const RateSolverChoice rate_solver;
    const TimeParameters   time_parameters;
    NodeLaws               laws;
    /** Of each slave node, empty where no fault may open. */
    std::vector<NodeOpening> openings;

    RunState<dim, n_components> run_state;

    /** True if the user has asked for the end of the run; empty before run().
     * Collective. */
    std::function<bool()> must_stop;

    FaultNodes<dim>                                        faults;
    FollowingStress<dim>                                   following_stress;
    std::unique_ptr<RateStateStep<dim, n_components>>      rate_state_step;
    std::unique_ptr<StepSizeController<dim, n_components>> step_size_controller;
    std::unique_ptr<EnergyBalance<dim, n_components>>      energy;
    std::unique_ptr<RunRecord<dim, n_components>>          record;
  };
} // namespace StickSlip

#endif
