// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_quasistatic_bodies_h
#define stickslip_time_quasistatic_bodies_h

#include <stickslip/condensed/condensed_operator.h>
#include <stickslip/condensed/schur_complement.h>
#include <stickslip/faults/fault_functional.h>
#include <stickslip/problem/nodal_functional.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Elastic bodies without mass as their faults feel them: they follow the slip
   * s at once, so that the forces on the faults are linear in it,
   *
   *   r(t) = r_0 + integral of (R - S V) dt,
   *
   * with the Schur complement S of the stiffness as a dense matrix and what
   * driven sides, prescribed slip and loads add, R. Contact pressures are
   * linear in the slip as well, with a second matrix. Both are made when they
   * are asked for first. Displacements inside are found only where someone
   * looks at them, by complete() or body_values().
   *
   * Processes have the rows of S of their own nodes. All members but the
   * short ones and set_free_slip() are collective.
   */
  template <int dim, int n_components = dim>
  class QuasistaticBodies
  {
  public:
    using Slip = std::vector<Tensor<1, dim - 1>>;

    /** Forces on the free entries and on those with a prescribed slip rate, N,
     * both of this process, and contact pressures of all slave nodes, Pa, empty
     * where they are not asked for; or their rates. */
    struct Forces
    {
      std::vector<double> free, prescribed, pressure;
    };

    /** The drive of the bodies at one moment: velocities that are known, in the
     * jump basis and zero else, the slip rates among them, and the rates of
     * forces that go with these velocities and the loads alone. */
    struct Drive
    {
      /** s. */
      double      time;
      NodalVector velocity;
      Slip        slip_rate;
      Forces      force_rate;
    };

    /** Bodies with one contact mapping, that have neither mass nor viscosity,
     * with faults that do not open; @p with_pressures: contact pressures are
     * asked for. All must live longer. */
    QuasistaticBodies(SpatialProblem<dim, n_components> &problem,
                      const FaultNodes<dim>             &faults,
                      const NodeLaws                    &laws,
                      const bool                         with_pressures);

    /** Entries of the slave nodes of this process whose slip is free. */
    const CondensedEntries<n_components> &
    free_entries() const
    {
      return entries;
    }

    /** Node and direction of each free entry of all processes. */
    const std::vector<std::pair<unsigned int, unsigned int>> &
    all_free() const
    {
      return places;
    }

    /** True at nodes whose slip rate is to be found. */
    bool
    slips_freely(const unsigned int k) const;

    /** Values on the free entries of this process to those of all. */
    std::vector<double>
    on_all(const std::vector<double> &values);

    /** The drive at the start and the end of a step of size @p tau from time
     * @p from on, in which loads are linear; the same object for both, and in
     * all such steps, where nothing that is prescribed changes any more. */
    std::pair<std::shared_ptr<const Drive>, std::shared_ptr<const Drive>>
    drive(const double from, const double tau);

    /** The forces in a state: those that it carries, or those of its bodies in
     * equilibrium. */
    Forces
    forces_in(const SystemState<dim> &state);

    /** The rates of forces on free entries and of pressures, but not of forces
     * on prescribed ones, for @p rates of slip on the free entries of all. */
    Forces
    forces_of_slip(const std::vector<double> &rates);

    /** The rates of forces on prescribed entries for @p rates of slip on the
     * free entries of all. */
    std::vector<double>
    prescribed_forces_of_slip(const std::vector<double> &rates);

    /** The forces along the slip of all slave nodes, N; zero where it is
     * neither free nor prescribed. */
    Slip
    forces_on_faults(const Forces &forces) const;

    /** Set the slip rates of the nodes that slip freely in a vector of the jump
     * basis. */
    void
    set_free_slip(NodalVector &w, const Slip &rates) const;

    /** Bring the bodies of a state whose faults alone have moved into
     * equilibrium. */
    void
    complete(SystemState<dim> &state);

    /** The values of functionals that complete() would lead to, at the cost of
     * products with what is known, after a solution for each of them at the
     * first call; the same ones at each call. */
    FunctionalValues
    body_values(const SystemState<dim>             &state,
                const std::vector<NodalFunctional> &functionals);

  private:
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
      /** z b of a load that is constant. */
      double of_constant_load = 0.;
    };

    /** Make the matrices, unless that has been done. */
    void
    prepare();

    /** The time until which what is prescribed goes on as at @p time; @p time
     * itself if that is not known. */
    double
    steady_from(const double time) const;

    /** The change of the load over the step that has led to @p time, over its
     * size; zero at the start. */
    NodalVector
    load_rate(const double time, const double tau) const;

    /** The drive at @p time with this rate of the load; one of last_drives if
     * it is that. */
    std::shared_ptr<const Drive>
    make_drive(const double time, const NodalVector &load_rate);

    /** The velocities that a state says in the jump basis: those that are known
     * and slip rates, and zero else. */
    NodalVector
    velocities_of_faults(const SystemState<dim> &state) const;

    /** Set all to zero that is known or free. */
    void
    restrict_to_eliminated(NodalVector &w) const;

    /** Add to @p w what the eliminated components do in equilibrium with it
     * under the forces @p load. */
    void
    balance(NodalVector &w, const NodalVector &load);

    /** The forces of bodies that have been balanced, or their rates. */
    Forces
    forces_of(const NodalVector &w, const NodalVector &load) const;

    Influence
    influence(const NodalFunctional &functional);

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;
    const bool                         with_pressures;

    const CondensedEntries<n_components> entries;
    /** Positions of the entries of this process whose forces matter although
     * their jumps are known: those that are prescribed, and with pressures the
     * normal ones. */
    std::vector<unsigned int> known_entries;
    /** Numbers among these of the ones that are prescribed, and node and
     * direction of each. */
    std::vector<unsigned int>                          prescribed_entries;
    std::vector<std::pair<unsigned int, unsigned int>> prescribed_places;
    /** Node and direction of each free entry of all processes. */
    std::vector<std::pair<unsigned int, unsigned int>> places;
    /** The number among these of the first one of this process. */
    unsigned int first_place = 0;

    std::unique_ptr<SchurComplement<n_components>> condensed;
    /** The rate of all contact pressures for a rate of one of each free entry
     * of this process, one after the other. */
    std::vector<double> pressures_of_slip;
    /** Of the functionals of body_values(). */
    std::vector<Influence> influences;
    /** The drives at both ends of the last step, and the time until which they
     * stay as they are. */
    std::pair<std::shared_ptr<const Drive>, std::shared_ptr<const Drive>>
           last_drives;
    double steady_until = std::numeric_limits<double>::lowest();
  };
} // namespace StickSlip

#endif
