// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_contact_h
#define stickslip_time_step_contact_h

#include <stickslip/faults/fault_functional.h>
#include <stickslip/problem/unilateral_contact.h>
#include <stickslip/time/time_parameters.h>
#include <stickslip/time/time_scheme.h>

namespace StickSlip
{
  /**
   * Contact in one time step: its pressure, and, where sides may open and
   * close, the bounds of the opening rates, which nodes touch, and what the
   * step ends with. Faults that cannot open have the pressure only.
   */
  template <int dim, int n_components = dim>
  class StepContact
  {
  public:
    /** Contact in a step of size @p tau from @p from. All that is referred to
     * must live as long. */
    StepContact(SpatialProblem<dim, n_components>   &problem,
                const FaultNodes<dim>               &faults,
                const NodeLaws                      &laws,
                const UnilateralContact<dim>        &unilateral,
                const TimeScheme<dim, n_components> &scheme,
                const Inertia                        inertia,
                const SystemState<dim>              &from,
                const double                         tau);

    /** Add what contact does to the right hand side of the rate problem, and
     * set the bounds of @p friction. */
    void
    start(NodalVector &rhs, FaultFriction<n_components> &friction) const;

    /** Find the nodes that touch with the velocities of an iterate. Before
     * that, those touch that did at the beginning of the step. */
    void
    find_touching(const NodalVector &w);

    /** Set to zero the slip rates of open sides, which do not rub however fast
     * they pass each other, at the beginning of the step and at its end.
     * Returns for which nodes the state stays meanwhile, empty if none opens.
     */
    std::vector<bool>
    stop_rubbing(std::vector<Tensor<1, dim - 1>> &slip_rate_before,
                 std::vector<Tensor<1, dim - 1>> &slip_rate) const;

    /** The contact pressure of a solution of the rate problem, Pa. */
    std::vector<double>
    pressure(const NodalVector &rhs, const NodalVector &w) const;

    /** The contact pressure at the end of the step from that of its rate
     * problem, Pa. */
    std::vector<double>
    end_pressure(std::vector<double> pressure) const;

    /** Changes of the contact pressure of a solution that rounding may make at
     * each slave node, Pa: its terms are large in short steps, and cancel. */
    std::vector<double>
    pressure_rounding(const NodalVector &w) const;

    /** Set gaps, bonds and, after impacts, velocities of the state of
     * @p result, where sides may open, and what contact takes; @p w: velocities
     * of the rate problem. Throws SolverControl::NoConvergence if those after
     * impacts are not found. */
    void
    complete(StepResult<dim>   &result,
             const NodalVector &rhs,
             NodalVector       &w) const;

  private:
    /** Stop what has collided, and let the time scheme know the forces of
     * contact. */
    void
    complete_impacts(StepResult<dim>         &result,
                     const NodalVector       &rhs,
                     const std::vector<bool> &touching_at_end,
                     NodalVector             &w) const;

    SpatialProblem<dim, n_components>   &problem;
    const FaultNodes<dim>               &fault_nodes;
    const NodeLaws                      &node_laws;
    const UnilateralContact<dim>        &unilateral;
    const TimeScheme<dim, n_components> &time_scheme;
    const bool                           is_dynamic;
    const SystemState<dim>              &from;
    const double                         tau;

    /** Empty where nothing may open. */
    GapPath             path;
    std::vector<double> bounds;
    std::vector<bool>   touching;
  };
} // namespace StickSlip

#endif
