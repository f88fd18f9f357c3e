// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_rate_state_step_h
#define stickslip_time_rate_state_step_h

#include <stickslip/faults/fault_functional.h>
#include <stickslip/faults/following_stress.h>
#include <stickslip/problem/unilateral_contact.h>
#include <stickslip/time/step_contact.h>
#include <stickslip/time/stress_iteration.h>
#include <stickslip/time/time_parameters.h>
#include <stickslip/time/time_scheme.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

namespace StickSlip
{
  /**
   * Start of the iteration of a step.
   */
  template <int dim>
  struct Prediction
  {
    NodalVector         velocity;
    std::vector<double> alpha;
    /** Pa, empty where no normal stress follows it. */
    std::vector<double> contact_pressure;
  };

  /**
   * One time step: the fixed point of rate and state. The rate problem is a
   * convex minimisation for the velocity at fixed state, the state problem an
   * update of the state at fixed slip rate.
   *
   * The nested iteration solves the rate problem, updates the state and starts
   * again. The interleaved one updates the state after every single iteration
   * of the rate solver and stops when both have settled. Where normal stresses
   * follow the contact pressure, they are updated together with the state.
   *
   * A step is a new value: nothing changes that another step depends on. A
   * step that does not converge is reported, not used.
   */
  template <int dim, int n_components = dim>
  class RateStateStep
  {
  public:
    /** Steps with one contact mapping; the next one needs a new object. All but
     * @p following and @p contact must live longer. */
    RateStateStep(SpatialProblem<dim, n_components> &problem,
                  const FaultNodes<dim>             &faults,
                  const NodeLaws                    &laws,
                  const TimeParameters              &time_parameters,
                  const TNNMGParameters             &tnnmg_parameters,
                  const FollowingStress<dim>        &following = {},
                  const UnilateralContact<dim>      &contact   = {});

    /** A step of size @p tau from @p from, begun at @p prediction, if any. */
    StepResult<dim>
    take(const SystemState<dim> &from,
         const double            tau,
         const Prediction<dim>  *prediction = nullptr);

    /** Linearisations that the solver of the rate problem keeps from step to
     * step. */
    std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const
    {
      return solver->kept_linearisations();
    }

    /** Take them over from another object for the same problem. Collective. */
    void
    recall(const std::vector<KeptLinearisation<n_components>> &kept);

    const FaultNodes<dim> &
    faults() const
    {
      return fault_nodes;
    }

    const NodeLaws &
    laws() const
    {
      return node_laws;
    }

    SpatialProblem<dim, n_components> &
    spatial_problem() const
    {
      return problem;
    }

    const FollowingStress<dim> &
    following_stress() const
    {
      return following;
    }

    const TimeScheme<dim, n_components> &
    scheme() const
    {
      return *time_scheme;
    }

    /** The length of the longest ramp of what is prescribed, s. */
    double
    longest_ramp() const
    {
      return problem.longest_ramp();
    }

  private:
    /** Time, state, normal stress, contact pressure and velocity with which the
     * iteration starts, the last one with what is prescribed at its sides. */
    SystemState<dim>
    predict(const SystemState<dim>               &from,
            const double                          tau,
            const Prediction<dim>                *prediction,
            const StepContact<dim, n_components> &contact) const;

    /** The velocity in the jump basis, with the jumps that are known. */
    NodalVector
    unknowns(const SystemState<dim> &to) const;

    /** Solve the rate problem at state and normal stress of @p to; where rate
     * and state are interleaved, improve its solution by one iteration more
     * than those @p before. Throws SingularMatrix. */
    SolveSummary
    solve_rate(const SystemState<dim> &to,
               const NodalVector      &rhs,
               NodalVector            &w,
               const SolveSummary     &before);

    /** Set the state of @p to to that at the end of the step if the slip rates
     * are those of @p w; returns its change in the fault_norm(). */
    double
    update_state(SystemState<dim>                     &to,
                 const SystemState<dim>               &from,
                 const NodalVector                    &w,
                 const double                          tau,
                 const StepContact<dim, n_components> &contact) const;

    /** Let contact pressure and normal stress of @p to follow, if they do;
     * returns its relative change in the fault_norm(). @p stress: what
     * the iteration has seen of it. */
    double
    follow_pressure(SystemState<dim>                     &to,
                    const NodalVector                    &rhs,
                    NodalVector                          &w,
                    const StepContact<dim, n_components> &contact,
                    StressIteration                      &stress);

    /** True if rate, state and normal stress have settled, of which the latter
     * two have changed by that much, and by @p change_before together in the
     * iteration before. Throws StepFailure if they never will. */
    bool
    have_settled(const SolveSummary &rate,
                 const double        of_state,
                 const double        of_stress,
                 const double        change_before,
                 const unsigned int  n_iterations) const;

    /** Everything of @p to that follows from the solution. Throws StepFailure
     * if it is not a number. */
    void
    complete(SystemState<dim>                     &to,
             const SystemState<dim>               &from,
             const double                          tau,
             const NodalVector                    &rhs,
             NodalVector                          &w,
             const StepContact<dim, n_components> &contact);

    /** Complete the velocities that single iterations leave alone. */
    void
    finish_rate(const NodalVector &rhs, NodalVector &w);

    bool
    is_nested() const
    {
      return time_parameters.rate_state_method == RateStateMethod::nested;
    }

    SpatialProblem<dim, n_components>                   &problem;
    const FaultNodes<dim>                               &fault_nodes;
    const NodeLaws                                      &node_laws;
    const TimeParameters                                &time_parameters;
    const TNNMGParameters                               &tnnmg_parameters;
    const FollowingStress<dim>                           following;
    const UnilateralContact<dim>                         unilateral;
    const std::unique_ptr<TimeScheme<dim, n_components>> time_scheme;
    /** Instruments of the iteration: of no meaning between steps. */
    std::unique_ptr<FaultFriction<n_components>>   friction;
    std::unique_ptr<NonsmoothSolver<n_components>> solver;
  };
} // namespace StickSlip

#endif
