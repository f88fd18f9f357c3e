// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_rate_state_step_h
#define stickslip_time_rate_state_step_h

#include <stickslip/faults/following_stress.h>
#include <stickslip/time/backward_differences.h>
#include <stickslip/time/generalised_alpha.h>
#include <stickslip/time/newmark.h>
#include <stickslip/time/time_parameters.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

namespace StickSlip
{
  /**
   * Where the iteration of a step starts.
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
   * One time step: the rate problem, a convex minimisation for the velocity at
   * fixed state, coupled with the state problem, an update of the state at
   * fixed slip rate.
   *
   * The nested iteration solves the rate problem, updates the state and starts
   * again. The interleaved one updates the state after every single iteration
   * of the rate solver and stops when both have settled. Where normal stresses
   * follow the contact pressure, they are updated together with the state.
   *
   * A step never changes the state that it starts from; what does not
   * converge is reported, not used.
   */
  template <int dim>
  class RateStateStep
  {
  public:
    RateStateStep(SpatialProblem<dim>        &problem,
                  FaultNodes<dim>            &fault_nodes,
                  const TimeParameters       &time_parameters,
                  const TNNMGParameters      &tnnmg_parameters,
                  const FollowingStress<dim> &following_stress = {});

    /** To be called after the contact mapping has been rebuilt. */
    void
    reinit();

    /** A step of size @p tau from @p from, begun at @p prediction, if any. */
    StepResult<dim>
    take(const SystemState<dim> &from,
         const double            tau,
         const Prediction<dim>  *prediction = nullptr);

    /** The length of the longest ramp of what is prescribed, s. */
    double
    longest_ramp() const;

    /** Work of all steps so far, those that failed included. */
    const StepCounts &
    total_counts() const;

    /** Number of steps taken, those that failed included. */
    unsigned long
    n_steps() const;

  private:
    /** Solve the rate problem at the present state, or, where rate and state
     * are interleaved, improve its solution by one iteration more than the one
     * @p before, if any. Throws SingularMatrix. */
    SolveSummary
    improve(const NodalVector      &rhs,
            NodalVector            &w,
            const IterationSummary *before);

    /** How displacements follow from velocities. */
    enum class Formula
    {
      newmark,
      generalised_alpha,
      backward_differences
    };

    static Formula
    choose_formula(const TimeParameters &parameters);

    /** Coefficients of mass, damping and stiffness in the operator. */
    std::vector<double>
    operator_coefficients(const SystemState<dim> &from, const double tau) const;

    /** The right hand side of the rate problem. */
    NodalVector
    right_hand_side(const SystemState<dim> &from, const double tau) const;

    /** The contact pressure of a solution of the rate problem, Pa. */
    std::vector<double>
    contact_pressure(const NodalVector &rhs, const NodalVector &w) const;

    /** Displacement, slip, and accelerations or mean rates of @p to, of which
     * velocity and slip rates are known. */
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const;

    /** The state at the end of the step if the slip rates are those of w. */
    std::vector<double>
    update_state(const SystemState<dim> &from,
                 const NodalVector      &w,
                 const double            tau) const;

    SpatialProblem<dim>                  &problem;
    FaultNodes<dim>                      &faults;
    const TimeParameters                 &time_parameters;
    const TNNMGParameters                &tnnmg_parameters;
    const FollowingStress<dim>            following_stress;
    const GeneralisedAlpha                generalised_alpha;
    const Formula                         formula;
    std::unique_ptr<NonsmoothSolver<dim>> solver;
    StepCounts                            totals;
    unsigned long                         steps = 0;
  };
} // namespace StickSlip

#endif
