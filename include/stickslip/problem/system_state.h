// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_system_state_h
#define stickslip_problem_system_state_h

#include <deal.II/base/tensor.h>

#include <stickslip/algebra/node_partition.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The state of the whole system at one time. Nodal vectors hold values in
   * the basis of the meshes, whatever the contact mapping; arrays over the
   * slave nodes are ordered as in FaultNodes, jumps are slave relative to
   * master.
   */
  template <int dim>
  struct SystemState
  {
    /** Time, s. */
    double time = 0;

    /** Nodal values, m, m/s, m/s^2; the last empty without inertia. */
    NodalVector displacement, velocity, acceleration;

    /** False if only faults and driven sides have moved in these, and the rest
     * waits for StepSizeController::complete(). */
    bool is_complete = true;

    /** Forces that are not of the contact, dual in the jump basis, N: carried
     * from step to step by the scheme for faults that open (ContactImplicit);
     * empty elsewhere, at the start and after a new contact mapping. */
    NodalVector force;

    /** Size of the step that has led here, s, and mean of the velocity over it,
     * m/s: without inertia. Zero and empty at the start. */
    double      last_step = 0;
    NodalVector mean_velocity;

    /** Logarithm of the state, ln(theta / 1 s). */
    std::vector<double> alpha;

    /** Accumulated slip, m, and slip rate, m/s. */
    std::vector<Tensor<1, dim - 1>> slip, slip_rate;

    /** Mean of the slip rate over the last step, like mean_velocity. */
    std::vector<Tensor<1, dim - 1>> mean_slip_rate;

    /** Shear traction that resists the slip at nodes where friction does not
     * tell it (shear_traction.h), Pa; empty if there are none. */
    std::vector<Tensor<1, dim - 1>> balancing_traction;

    /** Shear traction over the last step, like balancing_traction: the mean of
     * both its ends, about which they swing at nodes that have stopped at once
     * (ContactImplicit). Empty for other schemes and at the start. */
    std::vector<Tensor<1, dim - 1>> mean_traction;

    /** Normal stress at each slave node, Pa, compression positive, none
     * negative. */
    std::vector<double> normal_stress;

    /** Forces of the bodies on each slave node along its slip, N, slave
     * relative to master: carried from step to step by explicit steps; empty
     * elsewhere, at the start and after a new contact mapping. */
    std::vector<Tensor<1, dim - 1>> fault_force;

    /** Contact pressure at each slave node, Pa, see contact_pressures(); empty
     * where nobody needs it. */
    std::vector<double> contact_pressure;

    /** Gap between the sides at each slave node, m, and its rate, m/s: both
     * exactly zero where the sides touch, the gap never negative. Empty where
     * no fault may open. */
    std::vector<double> gap, opening_rate;

    /** One where the sides of a slave node are bonded, zero where they are not
     * or not any more; ordered and empty like gap. */
    std::vector<char> is_bonded;

    /** Time since which the sides of a slave node touch without a bond
     * breaking, s; ordered and empty like gap. */
    std::vector<double> touching_since;

    /** Call @p action with each nodal vector of a state, in a fixed order. */
    template <typename State, typename Action>
    static void
    for_each_vector(State &state, const Action &action)
    {
      action(state.displacement);
      action(state.velocity);
      action(state.acceleration);
      action(state.mean_velocity);
      action(state.force);
    }

    /** Everything but the nodal vectors, to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &is_complete &last_step &alpha &slip &slip_rate
        &mean_slip_rate &balancing_traction &mean_traction &normal_stress
          &fault_force &contact_pressure &gap &opening_rate &is_bonded
            &touching_since;
    }
  };

  /**
   * The work that a step took.
   */
  struct StepCounts
  {
    unsigned int rate_state_iterations = 0;
    unsigned int tnnmg_iterations      = 0;
    unsigned int multigrid_cycles      = 0;

    StepCounts &
    operator+=(const StepCounts &other)
    {
      rate_state_iterations += other.rate_state_iterations;
      tnnmg_iterations += other.tnnmg_iterations;
      multigrid_cycles += other.multigrid_cycles;
      return *this;
    }

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &rate_state_iterations &tnnmg_iterations &multigrid_cycles;
    }
  };

  /**
   * Energy in a step that goes the way of contacts that may open, J (per m in
   * plane strain).
   */
  struct ContactEnergy
  {
    /** Taken by sides that come together, and by bonds that break. */
    double lost = 0;

    /** Work of the normal stress that the bodies do not carry. */
    double of_offset = 0;

    /** Kinetic energy at the start of the step; zero where nothing is lost. */
    double kinetic = 0;
  };

  /**
   * A step of the time stepping that was tried.
   */
  template <int dim>
  struct StepResult
  {
    /** True if the state may be used. */
    bool converged = false;

    /** Reason of a failure; empty if there is none. */
    std::string failure;

    double           step_size = 0;
    SystemState<dim> state;
    StepCounts       counts;
    ContactEnergy    contact_energy;

    /** Velocity and slip rates at the end of the step before sides that have
     * come together are stopped there, m/s; empty if there is nothing to stop.
     */
    NodalVector                     velocity_before_impacts;
    std::vector<Tensor<1, dim - 1>> slip_rate_before_impacts;

    /** The part of the step before the moment of contact, where there are two;
     * what is above then is of the second one, but sizes and counts. */
    std::shared_ptr<const StepResult> before_contact;
  };
} // namespace StickSlip

#endif
