// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_contact_implicit_h
#define stickslip_time_contact_implicit_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/time/newmark.h>

namespace StickSlip
{
  /**
   * Newmark's method with the contact of faults that open taken implicitly
   * (Kane, Repetto, Ortiz and Marsden 1999): forces at the start of a step are
   * those without what the sides of faults do to each other along the normal,
   *
   *   M (v1 - v0) / tau = (G0 + G1 + R) / 2,   G = f - C v - K u - friction,
   *
   * and the reaction R is that of the gap at the end. Newmark's method with a
   * bound on the gap takes it as R0 + R1, and gains energy at impacts; here
   * contact never adds any. Velocities after impacts: see stop_impacts().
   *
   * Forces at the end are those of this balance, which the next step begins
   * with: what is left of the rate problem's residual is not lost, and comes
   * back with the other sign. At the start, and with a new contact mapping,
   * they come from displacement, velocity and friction. The acceleration of the
   * result is the mean over the step, and for output only.
   */
  template <int dim, int n_components = dim>
  class ContactImplicit : public Newmark<dim, n_components>
  {
  public:
    /** All must live longer. */
    ContactImplicit(const FaultNodes<dim> &faults, const NodeLaws &laws)
      : faults(faults)
      , laws(laws)
    {}

    NodalVector
    right_hand_side(SpatialProblem<dim, n_components> &problem,
                    const SystemState<dim>            &from,
                    const double                       tau) const override;

    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const override;

    void
    set_end_force(SystemState<dim>                  &to,
                  const SystemState<dim>            &from,
                  const double                       tau,
                  SpatialProblem<dim, n_components> &problem,
                  const NodalVector                 &w,
                  const NodalVector                 &w_stopped,
                  const NodalVector                 &reaction) const override;

    /** The forces of a rate problem are the sum of those at both ends. */
    GapPath
    gap_path(const double tau, const double) const override
    {
      return {tau / 2., tau / 2., 2.};
    }

    /** Means over this step and the one before, extrapolated. */
    double
    end_pressure(const double mean,
                 const double mean_before,
                 const double tau,
                 const double last) const override
    {
      return mean + (mean - mean_before) * tau / (tau + last);
    }

  protected:
    /** Forces, not an acceleration, come from the step before. */
    NodalVector
    known_acceleration(const SystemState<dim> &from,
                       const double            tau) const override;

  private:
    /** G0. */
    NodalVector
    start_force(SpatialProblem<dim, n_components> &problem,
                const SystemState<dim>            &from) const;

    const FaultNodes<dim> &faults;
    const NodeLaws        &laws;
  };
} // namespace StickSlip

#endif
