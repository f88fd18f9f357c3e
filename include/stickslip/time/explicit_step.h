// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_explicit_step_h
#define stickslip_time_explicit_step_h

#include <stickslip/condensed/condensed_operator.h>
#include <stickslip/faults/fault_functional.h>
#include <stickslip/faults/following_stress.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * A time step of faults between elastic bodies without mass, by the explicit
   * Runge-Kutta method of Dormand and Prince (1980) of fifth order.
   *
   * Bodies follow the slip s at once, so that the forces on the faults are
   * linear in it,
   *
   *   r(t) = r_0 + integral of (R - S V) dt,
   *
   * with the Schur complement S of the stiffness as a dense matrix and what
   * driven sides, prescribed slip and loads add, R. At given forces, state and
   * normal stress each node has its own slip rate, by friction and radiation
   * damping. So slip and state obey ordinary differential equations, a stage is
   * a product with S, and the bodies are looked at once, at the end. Normal
   * stresses that follow are linear in the slip as well, with a second matrix.
   *
   * What is prescribed is taken as linear in time within a step. On one
   * process.
   */
  template <int dim, int n_components = dim>
  class ExplicitStep
  {
  public:
    /** Steps with one contact mapping, of bodies that have neither mass nor
     * viscosity, with faults that do not open. All but @p following must live
     * longer. */
    ExplicitStep(SpatialProblem<dim, n_components> &problem,
                 const FaultNodes<dim>             &faults,
                 const NodeLaws                    &laws,
                 const FollowingStress<dim>        &following);

    /** A step of size @p tau from @p from. Its @p error is that which the
     * embedded method of fourth order tells: the fault_norm() of those of the
     * logarithm of the state and of the slip over the characteristic slip. The
     * step has not converged if that is above the
     * @p tolerance, or no number. */
    StepResult<dim>
    take(const SystemState<dim> &from,
         const double            tau,
         const double            tolerance,
         double                 &error);

  private:
    using Slip = std::vector<Tensor<1, dim - 1>>;

    /** Rates of the forces on the free entries of the faults, N/s, and of the
     * contact pressures of all slave nodes, Pa/s. */
    struct ForceRates
    {
      std::vector<double> force, pressure;
    };

    /** Rates at one of the times within a step. */
    struct Stage
    {
      Slip                slip_rate;
      std::vector<double> state_rate;
      ForceRates          forces;
    };

    /** Make the matrices. */
    void
    prepare();

    /** The velocities that are known at @p time, in the jump basis, and zero
     * else. */
    NodalVector
    known_velocities(const double time) const;

    /** Add to @p w what the eliminated components do in equilibrium with it
     * under the forces @p load. */
    void
    balance(NodalVector &w, const NodalVector &load);

    /** The forces of bodies that have been balanced, or their rates. */
    ForceRates
    forces_of(const NodalVector &w, const NodalVector &load) const;

    /** Set slip rates and those of the state; false if forces, state or normal
     * stress are no numbers. */
    bool
    find_rates(Stage                     &stage,
               const std::vector<double> &alpha,
               const std::vector<double> &force,
               const std::vector<double> &normal_stress) const;

    /** Set the rates of the forces; @p drive: what does not come from the
     * slip. */
    void
    set_force_rates(Stage &stage, const ForceRates &drive) const;

    /** Add rates of slip to a vector of the jump basis. */
    void
    add_slip(NodalVector &w, const Slip &rates, const double factor) const;

    /** True at nodes whose slip rate is to be found. */
    bool
    slips_freely(const unsigned int k) const;

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;
    const FollowingStress<dim>         following;

    const CondensedEntries<n_components>             entries;
    std::unique_ptr<CondensedOperator<n_components>> condensed;
    std::unique_ptr<FaultFriction<n_components>>     friction;
    /** The rate of all contact pressures for a rate of one of each entry, one
     * after the other; empty where nothing follows them. */
    std::vector<double> pressures_of_slip;
    /** Known velocities, and the rates of forces that go with them alone. */
    NodalVector driven_by;
    ForceRates  driven;
  };
} // namespace StickSlip

#endif
