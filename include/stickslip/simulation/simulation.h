// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_simulation_h
#define stickslip_simulation_simulation_h

#include <deal.II/base/timer.h>

#include <stickslip/scene/scene_parameters.h>
#include <stickslip/simulation/run_record.h>
#include <stickslip/time/energy_balance.h>
#include <stickslip/time/step_size_control.h>

namespace StickSlip
{
  /**
   * The step program: owns everything that belongs to one scene, and runs it.
   *
   * Members are declared in the order in which they depend on each other.
   */
  template <int dim>
  class Simulation
  {
  public:
    /** Builds the meshes and the matrices. Nothing is written yet. */
    Simulation(const SceneParameters<dim> &scene, const MPI_Comm &communicator);

    /**
     * Run the scene to its end time, or until the user interrupts it.
     * Whatever happens, the files written are complete and hold the last good
     * state. Throws StepSizeTooSmall if no step can be taken. Returns whether
     * the end time was reached.
     */
    bool
    run();

    /** The state reached. */
    const SystemState<dim> &
    state() const;

    const MeshHierarchy<dim> &
    meshes() const;

    SpatialProblem<dim> &
    spatial_problem();

    FaultNodes<dim> &
    fault_nodes();

    /** Null where the scene asks for none. */
    const EnergyBalance<dim> *
    energy_balance() const;

    /** Find the static equilibrium and what follows from it. */
    void
    set_up();

    /** One advance of the step size control, one or more accepted steps;
     * rebuilds the contact mapping if that is due. */
    void
    advance();

    bool
    is_finished() const;

  private:
    void
    accept(StepResult<dim> &&step);

    void
    rebuild_contact_if_slid();

    RunSummary
    summarise() const;

    const SceneParameters<dim> scene;
    const MPI_Comm             communicator;
    Timer                      construction_timer;
    mutable TimerOutput        timer;

    MeshHierarchy<dim>                       mesh_hierarchy;
    BoundaryValues<dim>                      boundary_values;
    SpatialProblem<dim>                      problem;
    FaultNodes<dim>                          faults;
    FollowingStress<dim>                     following_stress;
    std::unique_ptr<RateStateStep<dim>>      rate_state_step;
    std::unique_ptr<StepSizeController<dim>> step_size_controller;
    std::unique_ptr<RunRecord<dim>>          record;
    std::unique_ptr<EnergyBalance<dim>>      energy;

    SystemState<dim>                current;
    unsigned int                    step_number = 0;
    StepCounts                      accepted_counts;
    std::pair<double, double>       step_size_range;
    std::vector<Tensor<1, dim - 1>> slip_at_build;
    unsigned int                    nodes_in_tension       = 0;
    unsigned int                    most_in_tension        = 0;
    unsigned int                    equilibrium_iterations = 0;
    std::string                     ending;
  };
} // namespace StickSlip

#endif
