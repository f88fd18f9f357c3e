// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/faults/contact_pressure.h>
#include <stickslip/problem/rigid_body_modes.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/rate_state_step.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <cmath>
#include <iostream>

namespace StickSlip
{
  template <int dim>
  RateStateStep<dim>::RateStateStep(
    SpatialProblem<dim>        &problem,
    FaultNodes<dim>            &fault_nodes,
    const TimeParameters       &time_parameters,
    const TNNMGParameters      &tnnmg_parameters,
    const FollowingStress<dim> &following_stress)
    : problem(problem)
    , faults(fault_nodes)
    , time_parameters(time_parameters)
    , tnnmg_parameters(tnnmg_parameters)
    , following_stress(following_stress)
    , generalised_alpha(time_parameters.spectral_radius)
    , formula(choose_formula(time_parameters))
  {
    reinit();
  }



  template <int dim>
  void
  RateStateStep<dim>::reinit()
  {
    // The old one may refer to levels that are gone.
    solver.reset();
    if (time_parameters.rate_solver == RateSolver::condensed_newton)
      solver = std::make_unique<CondensedSolver<dim>>(problem.hierarchy(),
                                                      tnnmg_parameters);
    else if (tnnmg_parameters.linear_correction == LinearCorrectionType::amg)
      solver = std::make_unique<TNNMGSolver<dim>>(problem.hierarchy(),
                                                  tnnmg_parameters,
                                                  rigid_body_modes(problem));
    else
      solver = std::make_unique<TNNMGSolver<dim>>(problem.hierarchy(),
                                                  tnnmg_parameters);
  }



  template <int dim>
  typename RateStateStep<dim>::Formula
  RateStateStep<dim>::choose_formula(const TimeParameters &parameters)
  {
    if (parameters.inertia != Inertia::dynamic)
      return Formula::backward_differences;
    return parameters.scheme == TimeScheme::newmark ?
             Formula::newmark :
             Formula::generalised_alpha;
  }



  template <int dim>
  std::vector<double>
  RateStateStep<dim>::operator_coefficients(const SystemState<dim> &from,
                                            const double            tau) const
  {
    switch (formula)
      {
        case Formula::newmark:
          return Newmark::operator_coefficients(tau);
        case Formula::generalised_alpha:
          return generalised_alpha.operator_coefficients(tau);
        case Formula::backward_differences:
          return BackwardDifferences::operator_coefficients(from, tau);
      }
    AssertThrow(false, ExcInternalError());
    return {};
  }



  template <int dim>
  NodalVector
  RateStateStep<dim>::right_hand_side(const SystemState<dim> &from,
                                      const double            tau) const
  {
    switch (formula)
      {
        case Formula::newmark:
          return Newmark::right_hand_side(problem, from, tau);
        case Formula::generalised_alpha:
          return generalised_alpha.right_hand_side(problem, from, tau);
        case Formula::backward_differences:
          return BackwardDifferences::right_hand_side(problem, from, tau);
      }
    AssertThrow(false, ExcInternalError());
    return {};
  }



  template <int dim>
  void
  RateStateStep<dim>::complete(SystemState<dim>       &to,
                               const SystemState<dim> &from,
                               const double            tau) const
  {
    if (formula == Formula::backward_differences)
      {
        BackwardDifferences::complete(to, from, tau);
        return;
      }
    if (formula == Formula::newmark)
      Newmark::complete(to, from, tau);
    else
      generalised_alpha.complete(to, from, tau);
    to.slip = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau / 2. * (from.slip_rate[k] + to.slip_rate[k]);
  }



  template <int dim>
  std::vector<double>
  RateStateStep<dim>::update_state(const SystemState<dim> &from,
                                   const NodalVector      &w,
                                   const double            tau) const
  {
    const std::vector<Tensor<1, dim - 1>> slip_rate =
      faults.tangential_jumps(w);
    std::vector<double> alpha = from.alpha;
    for (unsigned int k = 0; k < alpha.size(); ++k)
      {
        const FaultLaw &law = faults.law(k);
        if (!law.state_law)
          continue;
        const double V =
          time_parameters.state_update == StateUpdate::exponential ?
            0.5 * (magnitude(from.slip_rate[k]) + magnitude(slip_rate[k])) :
            magnitude(slip_rate[k]);
        alpha[k] = law.state_law->updated(time_parameters.state_update,
                                          from.alpha[k],
                                          V,
                                          law.characteristic_slip,
                                          tau);
      }
    return alpha;
  }



  template <int dim>
  std::vector<double>
  RateStateStep<dim>::contact_pressure(const NodalVector &rhs,
                                       const NodalVector &w) const
  {
    NodalVector reaction = problem.make_vector();
    problem.hierarchy().matrix().residual(reaction, rhs, w);
    reaction *= -1.;
    return contact_pressures(problem.jump_basis(),
                             problem.hierarchy().finest().nodes,
                             reaction);
  }



  template <int dim>
  SolveSummary
  RateStateStep<dim>::improve(const NodalVector      &rhs,
                              NodalVector            &w,
                              const IterationSummary *before)
  {
    if (time_parameters.rate_state_method == RateStateMethod::nested)
      return solver->solve(faults.friction(), rhs, w);
    SolveSummary summary;
    summary.iterations.push_back(solver->iterate(faults.friction(), rhs, w));
    summary.converged =
      solver->has_converged(summary.iterations.back(), before);
    return summary;
  }



  template <int dim>
  StepResult<dim>
  RateStateStep<dim>::take(const SystemState<dim> &from,
                           const double            tau,
                           const Prediction<dim>  *prediction)
  {
    StepResult<dim> result;
    result.step_size          = tau;
    SystemState<dim> &to      = result.state;
    StepCounts       &counts  = result.counts;
    to.time                   = from.time + tau;
    to.alpha                  = prediction ? prediction->alpha : from.alpha;
    const NodalVector rhs     = right_hand_side(from, tau);
    const bool        follows = following_stress.is_needed();
    if (follows)
      {
        to.contact_pressure =
          prediction ? prediction->contact_pressure : from.contact_pressure;
        following_stress.apply(faults, to.contact_pressure);
      }

    // The unknown starts from the prediction, with what is prescribed.
    to.velocity = prediction ? prediction->velocity : from.velocity;
    problem.boundary_values().set_velocities(to.time, to.velocity);
    NodalVector w = problem.make_vector();
    problem.to_jumps(w, to.velocity);
    problem.set_known_jumps(to.time, w);

    problem.combine(operator_coefficients(from, tau));
    try
      {
        solver->start(rhs, w);
      }
    catch (const SingularMatrix &error)
      {
        result.failure = error.what();
      }
    const bool nested =
      (time_parameters.rate_state_method == RateStateMethod::nested);
    SolveSummary rate;
    while (!result.converged && result.failure.empty())
      {
        faults.set_state(to.alpha);
        try
          {
            IterationSummary before;
            const bool       is_first = rate.iterations.empty();
            if (!is_first)
              before = rate.iterations.back();
            rate = improve(rhs, w, is_first ? nullptr : &before);
          }
        catch (const SingularMatrix &error)
          {
            result.failure = error.what();
            break;
          }
        if (nested && !rate.converged)
          result.failure = "the rate problem was not solved within " +
                           std::to_string(rate.iterations.size()) +
                           " iterations";
        if (tnnmg_parameters.print_iterations &&
            Utilities::MPI::this_mpi_process(w.get_mpi_communicator()) == 0)
          std::cout << rate;
        ++counts.rate_state_iterations;
        counts.tnnmg_iterations += rate.iterations.size();
        counts.multigrid_cycles += rate.n_cycles();

        std::vector<double> alpha  = update_state(from, w, tau);
        std::vector<double> change = alpha;
        for (unsigned int k = 0; k < change.size(); ++k)
          change[k] -= to.alpha[k];
        to.alpha          = std::move(alpha);
        double difference = faults.l2_norm(change);
        if (follows)
          {
            // The reaction is that of complete velocities.
            if (!nested)
              solver->finish(rhs, w);
            to.contact_pressure = contact_pressure(rhs, w);
            difference          = std::hypot(difference,
                                    faults.l2_norm(following_stress.apply(
                                      faults, to.contact_pressure)));
          }
        if (!std::isfinite(difference) ||
            !std::isfinite(rate.iterations.back().correction_norm))
          result.failure = "the solution is not a number";
        else if (result.failure.empty())
          {
            result.converged =
              rate.converged &&
              difference <= time_parameters.rate_state_tolerance;
            if (!result.converged &&
                counts.rate_state_iterations >=
                  time_parameters.max_rate_state_iterations)
              result.failure = "rate and state did not settle within " +
                               std::to_string(counts.rate_state_iterations) +
                               " iterations";
          }
      }
    totals += counts;
    ++steps;
    if (!result.converged)
      return result;

    // Where the normal stress follows, that has been done.
    if (!nested && !follows)
      solver->finish(rhs, w);
    if (!follows && !from.contact_pressure.empty())
      to.contact_pressure = contact_pressure(rhs, w);
    problem.to_nodal(to.velocity, w);
    to.slip_rate = faults.tangential_jumps(w);
    to.balancing_traction =
      balancing_tractions(faults, to, problem.hierarchy().matrix(), rhs, w);
    complete(to, from, tau);
    if (!std::isfinite(to.velocity.l2_norm() + to.displacement.l2_norm()))
      {
        result.converged = false;
        result.failure   = "the solution is not a number";
      }
    return result;
  }



  template <int dim>
  double
  RateStateStep<dim>::longest_ramp() const
  {
    return problem.longest_ramp();
  }



  template <int dim>
  const StepCounts &
  RateStateStep<dim>::total_counts() const
  {
    return totals;
  }



  template <int dim>
  unsigned long
  RateStateStep<dim>::n_steps() const
  {
    return steps;
  }



  template class RateStateStep<2>;
  template class RateStateStep<3>;
} // namespace StickSlip
