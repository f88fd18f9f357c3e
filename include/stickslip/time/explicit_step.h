// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_explicit_step_h
#define stickslip_time_explicit_step_h

#include <stickslip/faults/fault_functional.h>
#include <stickslip/faults/following_stress.h>
#include <stickslip/time/quasistatic_bodies.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * A time step of faults between elastic bodies without mass, by the explicit
   * Runge-Kutta method of Dormand and Prince (1980) of fifth order.
   *
   * Bodies follow the slip at once and are not looked at, see
   * QuasistaticBodies: forces and pressures are carried from step to step. At
   * given forces, state and normal stress each node has its own slip rate, by
   * friction and radiation damping. So slip and state obey ordinary
   * differential equations, and a stage is a product with a dense matrix.
   *
   * Prescribed motion and loads are linear in time within a step. Processes
   * have the friction of their own nodes.
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
     * step has not converged if that is above the @p tolerance, or no number.
     */
    StepResult<dim>
    take(const SystemState<dim> &from,
         const double            tau,
         const double            tolerance,
         double                 &error);

    /** The bodies that the faults move, for those who want to see them. */
    QuasistaticBodies<dim, n_components> &
    moved_bodies()
    {
      return bodies;
    }

  private:
    using Slip   = typename QuasistaticBodies<dim, n_components>::Slip;
    using Forces = typename QuasistaticBodies<dim, n_components>::Forces;
    using Drive  = typename QuasistaticBodies<dim, n_components>::Drive;

    /** Rates at one of the times within a step: slip rates on the free entries
     * of all processes, and of all nodes. */
    struct Stage
    {
      std::vector<double> rates;
      Slip                slip_rate;
      std::vector<double> state_rate;
      Forces              forces;
    };

    /** Set slip rates, from those given as a guess, and rates of the state;
     * false if forces, state or normal stress are no numbers. */
    bool
    find_rates(Stage                     &stage,
               const std::vector<double> &alpha,
               const std::vector<double> &force,
               const std::vector<double> &normal_stress);

    /** Set the rates of the forces at the @p part of a step that is over. */
    void
    set_force_rates(Stage        &stage,
                    const double  part,
                    const Forces &drive,
                    const Forces &drive_end);

    /** The end of a step with these stages and forces, but for its bodies. */
    void
    set_end(SystemState<dim>       &to,
            const SystemState<dim> &from,
            const Drive            &drive,
            const Drive            &drive_end,
            const Forces           &end) const;

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;
    const FollowingStress<dim>         following;

    QuasistaticBodies<dim, n_components>         bodies;
    std::unique_ptr<FaultFriction<n_components>> friction;
  };
} // namespace StickSlip

#endif
