// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_explicit_step_h
#define stickslip_time_explicit_step_h

#include <stickslip/condensed/condensed_operator.h>
#include <stickslip/condensed/schur_complement.h>
#include <stickslip/faults/fault_functional.h>
#include <stickslip/faults/following_stress.h>
#include <stickslip/problem/nodal_functional.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

#include <memory>
#include <utility>
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
   * damping. So slip and state obey ordinary differential equations, and a
   * stage is a product with S. Normal stresses that follow are linear in the
   * slip as well, with a second matrix. Bodies are not looked at: forces and
   * pressures are carried from step to step, and complete() brings the bodies
   * of a state into equilibrium, for those who want to see them.
   *
   * Prescribed motion and loads are linear in time within a step. Processes
   * have the friction and the rows of S of their own nodes.
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

    /** Bring the bodies of a state that steps have led to into equilibrium. */
    void
    complete(SystemState<dim> &state);

    /** The values of functionals that complete() would lead to, at the cost of
     * products with what is known, after a solution for each of them at the
     * first call; the same ones at each call. Collective. */
    FunctionalValues
    body_values(const SystemState<dim>             &state,
                const std::vector<NodalFunctional> &functionals);

  private:
    using Slip = std::vector<Tensor<1, dim - 1>>;

    /** Forces on the free and on the known entries of this process, N, and
     * contact pressures of all slave nodes, Pa; or their rates. */
    struct Forces
    {
      std::vector<double> free, known, pressure;
    };

    /** Rates at one of the times within a step: slip rates on the free entries
     * of all processes, and of all nodes. */
    struct Stage
    {
      std::vector<double> rates;
      Slip                slip_rate;
      std::vector<double> state_rate;
      Forces              forces;
    };

    /** A functional of bodies in equilibrium: what it is of known entries, as
     * those on faults, and the displacement by which it depends on loads: with
     * z_I = K_II^-1 e_I for the functional e,
     *
     *   e w = (e - K z) w + z b,
     *
     * which w_I does not enter. */
    struct Influence
    {
      NodalFunctional of_known;
      NodalVector     of_loads;
    };

    /** Make the matrices. */
    void
    prepare();

    /** The velocities that are known at @p time, in the jump basis, and zero
     * else. */
    NodalVector
    known_velocities(const double time) const;

    /** The velocities that a state says in the jump basis: those that are known
     * and slip rates, and zero else. */
    NodalVector
    velocities_of_faults(const SystemState<dim> &state) const;

    /** Set all to zero that is known or free. */
    void
    restrict_to_eliminated(NodalVector &w) const;

    Influence
    influence(const NodalFunctional &functional);

    /** Add to @p w what the eliminated components do in equilibrium with it
     * under the forces @p load. */
    void
    balance(NodalVector &w, const NodalVector &load);

    /** The forces of bodies that have been balanced, or their rates. */
    Forces
    forces_of(const NodalVector &w, const NodalVector &load) const;

    /** The forces in a state: those that it carries, or those of its bodies in
     * equilibrium. */
    Forces
    forces_in(const SystemState<dim> &state);

    /** The rates of forces that go with known velocities and loads alone. */
    const Forces &
    driven_forces(const NodalVector &known, const NodalVector &load_rate);

    /** The change of the load over the step that has led to @p time, over its
     * size; zero at the start. */
    NodalVector
    load_rate(const double time, const double tau) const;

    /** Set slip rates, from those given as a guess, and rates of the state;
     * false if forces, state or normal stress are no numbers. */
    bool
    find_rates(Stage                     &stage,
               const std::vector<double> &alpha,
               const std::vector<double> &force,
               const std::vector<double> &normal_stress) const;

    /** Set the rates of the forces at the @p part of a step that is over. */
    void
    set_force_rates(Stage        &stage,
                    const double  part,
                    const Forces &drive,
                    const Forces &drive_end) const;

    /** The end of a step with these stages and forces, but for its bodies. */
    void
    set_end(SystemState<dim>       &to,
            const SystemState<dim> &from,
            const NodalVector      &mean_known,
            const Forces           &end) const;

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

    const CondensedEntries<n_components> entries;
    /** Positions of the entries of this process whose forces matter although
     * their jumps are known: those that are prescribed, and the normal ones
     * where normal stresses follow. */
    std::vector<unsigned int> known_entries;
    /** Node and direction of each free entry of all processes. */
    std::vector<std::pair<unsigned int, unsigned int>> places;
    /** The number among these of the first one of this process. */
    unsigned int first_place = 0;

    std::unique_ptr<SchurComplement<n_components>> condensed;
    std::unique_ptr<FaultFriction<n_components>>   friction;
    /** The rate of all contact pressures for a rate of one of each free entry
     * of this process, one after the other; empty where nothing follows them.
     */
    std::vector<double> pressures_of_slip;
    /** Of the functionals of body_values(). */
    std::vector<Influence> influences;
    /** Known velocities, and the rates of forces that go with them alone. */
    NodalVector driven_by;
    Forces      driven;
  };
} // namespace StickSlip

#endif
