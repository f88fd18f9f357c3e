// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_control.h>

#include <stickslip/algebra/local_products.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/faults/fault_norm.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/backward_differences.h>
#include <stickslip/time/contact_implicit.h>
#include <stickslip/time/newmark.h>
#include <stickslip/time/rate_state_step.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace StickSlip
{
  namespace
  {
    /** Reason why a step cannot be used; the same on all processes. */
    struct StepFailure : public std::runtime_error
    {
      using std::runtime_error::runtime_error;
    };



    template <int dim, int n_components>
    std::unique_ptr<TimeScheme<dim, n_components>>
    make_time_scheme(const Inertia                 inertia,
                     const FaultNodes<dim>        &faults,
                     const NodeLaws               &laws,
                     const UnilateralContact<dim> &contact)
    {
      if (inertia != Inertia::dynamic)
        return std::make_unique<BackwardDifferences<dim, n_components>>();
      if (contact.is_needed())
        return std::make_unique<ContactImplicit<dim, n_components>>(faults,
                                                                    laws);
      return std::make_unique<Newmark<dim, n_components>>();
    }



    template <int dim, int n_components>
    std::unique_ptr<NonsmoothSolver<n_components>>
    make_rate_solver(SpatialProblem<dim, n_components> &problem,
                     const RateSolver                   method,
                     const TNNMGParameters             &parameters)
    {
      Assert(method != RateSolver::automatic,
             ExcMessage("Somebody has to choose the solver."));
      if (method == RateSolver::condensed_newton)
        try
          {
            return std::make_unique<CondensedSolver<n_components>>(
              problem.operators(), parameters);
          }
        catch (const AgreedFailure &failure)
          {
            throw AgreedFailure(failure.what() +
                                std::string(" Choose another one as "
                                            "'Time/Rate solver'."));
          }
      return std::make_unique<TNNMGSolver<n_components>>(problem.hierarchy(),
                                                         parameters);
    }



    /** All changes to come if @p change goes on shrinking as it has shrunk
     * since the one @p before, and no less than the last one. A change that
     * does not shrink is rounding where it is below a tolerance. */
    double
    remaining_change(const double change, const double before)
    {
      const double factor = change / before;
      return factor > 0.5 && factor < 1. ? change * factor / (1. - factor) :
                                           change;
    }
  } // namespace



  template <int dim, int n_components>
  RateStateStep<dim, n_components>::RateStateStep(
    SpatialProblem<dim, n_components> &problem,
    const FaultNodes<dim>             &faults,
    const NodeLaws                    &laws,
    const TimeParameters              &time_parameters,
    const TNNMGParameters             &tnnmg_parameters,
    const FollowingStress<dim>        &following,
    const UnilateralContact<dim>      &contact)
    : problem(problem)
    , fault_nodes(faults)
    , node_laws(laws)
    , time_parameters(time_parameters)
    , tnnmg_parameters(tnnmg_parameters)
    , following(following)
    , unilateral(contact)
    , time_scheme(make_time_scheme<dim, n_components>(time_parameters.inertia,
                                                      faults,
                                                      laws,
                                                      contact))
    , friction(make_fault_friction<dim, n_components>(faults,
                                                      laws,
                                                      std::vector<double>(
                                                        faults.size())))
    , solver(make_rate_solver(problem,
                              time_parameters.rate_solver,
                              tnnmg_parameters))
  {
    if (!contact.is_needed())
      return;
    std::vector<int> signs;
    for (const unsigned int k : faults.owned_contact())
      signs.push_back(
        contact.may_open(k) ? (faults.opening_sign(k) > 0. ? 1 : -1) : 0);
    friction->set_opening(signs);
  }



  template <int dim, int n_components>
  StepResult<dim>
  RateStateStep<dim, n_components>::take(const SystemState<dim> &from,
                                         const double            tau,
                                         const Prediction<dim>  *prediction)
  {
    StepResult<dim> result;
    result.step_size         = tau;
    SystemState<dim> &to     = result.state;
    StepCounts       &counts = result.counts;
    try
      {
        NodalVector rhs = time_scheme->right_hand_side(problem, from, tau);
        StepContact<dim, n_components> contact(problem,
                                               fault_nodes,
                                               node_laws,
                                               unilateral,
                                               *time_scheme,
                                               time_parameters.inertia,
                                               from,
                                               tau);
        contact.start(rhs, *friction);
        to            = predict(from, tau, prediction, contact);
        NodalVector w = unknowns(to);
        problem.combine(
          time_scheme->operator_coefficients(tau, from.last_step));
        solver->start(rhs, w);

        SolveSummary    rate;
        StressIteration stress(fault_nodes.weights());
        double          change  = std::numeric_limits<double>::infinity();
        bool            settled = false;
        while (!settled)
          {
            rate = solve_rate(to, rhs, w, rate);
            ++counts.rate_state_iterations;
            counts.tnnmg_iterations += rate.iterations.size();
            counts.multigrid_cycles += rate.n_cycles();
            contact.find_touching(w);
            const double of_state = update_state(to, from, w, tau, contact);
            const double of_stress =
              follow_pressure(to, rhs, w, contact, stress);
            settled = have_settled(
              rate, of_state, of_stress, change, counts.rate_state_iterations);
            change = std::hypot(of_state, of_stress);
          }
        complete(to, from, tau, rhs, w, contact);
        contact.complete(result, rhs, w);
        result.converged = true;
      }
    catch (const SingularMatrix &error)
      {
        result.failure = error.what();
      }
    catch (const StepFailure &error)
      {
        result.failure = error.what();
      }
    catch (const SolverControl::NoConvergence &)
      {
        result.failure = "the velocities after an impact were not found";
      }
    return result;
  }



  template <int dim, int n_components>
  void
  RateStateStep<dim, n_components>::recall(
    const std::vector<KeptLinearisation<n_components>> &kept)
  {
    for (const KeptLinearisation<n_components> &linearisation : kept)
      if (!linearisation.coefficients.empty())
        {
          problem.operators().combine(linearisation.coefficients);
          solver->recall(linearisation);
        }
  }



  template <int dim, int n_components>
  SystemState<dim>
  RateStateStep<dim, n_components>::predict(
    const SystemState<dim>               &from,
    const double                          tau,
    const Prediction<dim>                *prediction,
    const StepContact<dim, n_components> &contact) const
  {
    SystemState<dim> to;
    to.time          = from.time + tau;
    to.alpha         = prediction ? prediction->alpha : from.alpha;
    to.normal_stress = from.normal_stress;
    if (following.is_needed())
      {
        to.contact_pressure =
          prediction ? prediction->contact_pressure : from.contact_pressure;
        to.normal_stress =
          following.normal_stress(from.normal_stress,
                                  contact.end_pressure(to.contact_pressure));
      }
    // Swapped in: to assign to a vector without a partition takes a message.
    NodalVector(prediction ? prediction->velocity : from.velocity)
      .swap(to.velocity);
    problem.boundary_values().set_velocities(to.time, to.velocity);
    return to;
  }



  template <int dim, int n_components>
  NodalVector
  RateStateStep<dim, n_components>::unknowns(const SystemState<dim> &to) const
  {
    NodalVector w = problem.make_vector();
    problem.to_jumps(w, to.velocity);
    problem.set_known_jumps(to.time, w);
    if (unilateral.is_needed())
      project(*friction, friction->nodes(), w);
    return w;
  }



  template <int dim, int n_components>
  SolveSummary
  RateStateStep<dim, n_components>::solve_rate(const SystemState<dim> &to,
                                               const NodalVector      &rhs,
                                               NodalVector            &w,
                                               const SolveSummary     &before)
  {
    friction->set_normal_stresses(
      fault_nodes.at_owned_contact(to.normal_stress));
    friction->set_state(fault_nodes.at_owned_contact(to.alpha));

    SolveSummary rate;
    if (is_nested())
      rate = solver->solve(*friction, rhs, w);
    else
      {
        rate.iterations.push_back(solver->iterate(*friction, rhs, w));
        rate.converged = solver->has_converged(rate.iterations.back(),
                                               before.iterations.empty() ?
                                                 nullptr :
                                                 &before.iterations.back());
      }
    if (tnnmg_parameters.print_iterations &&
        Utilities::MPI::this_mpi_process(w.get_mpi_communicator()) == 0)
      std::cout << rate;
    return rate;
  }



  template <int dim, int n_components>
  double
  RateStateStep<dim, n_components>::update_state(
    SystemState<dim>                     &to,
    const SystemState<dim>               &from,
    const NodalVector                    &w,
    const double                          tau,
    const StepContact<dim, n_components> &contact) const
  {
    std::vector<Tensor<1, dim - 1>> slip_rate = fault_nodes.tangential_jumps(w),
                                    slip_rate_before = from.slip_rate;
    const std::vector<bool> is_frozen =
      contact.stop_rubbing(slip_rate_before, slip_rate);
    std::vector<double> change(to.alpha.size());
    for (unsigned int k = 0; k < to.alpha.size(); ++k)
      {
        const FaultLaw &law   = node_laws[k];
        double          alpha = from.alpha[k];
        if (law.state_law && (is_frozen.empty() || !is_frozen[k]))
          {
            const double V =
              time_parameters.state_update == StateUpdate::exponential ?
                0.5 *
                  (magnitude(slip_rate_before[k]) + magnitude(slip_rate[k])) :
                magnitude(slip_rate[k]);
            alpha = law.state_law->updated(time_parameters.state_update,
                                           from.alpha[k],
                                           V,
                                           law.characteristic_slip,
                                           tau);
          }
        change[k]   = alpha - to.alpha[k];
        to.alpha[k] = alpha;
      }
    return fault_norm(fault_nodes, node_laws, change);
  }



  template <int dim, int n_components>
  double
  RateStateStep<dim, n_components>::follow_pressure(
    SystemState<dim>                     &to,
    const NodalVector                    &rhs,
    NodalVector                          &w,
    const StepContact<dim, n_components> &contact,
    StressIteration                      &stress)
  {
    if (!following.is_needed())
      return 0.;
    // The reaction is that of complete velocities.
    finish_rate(rhs, w);
    to.contact_pressure              = contact.pressure(rhs, w);
    const std::vector<double> before = to.normal_stress;
    to.normal_stress =
      following.normal_stress(before,
                              contact.end_pressure(to.contact_pressure));
    if (!unilateral.is_needed())
      return fault_norm(fault_nodes,
                        node_laws,
                        relative_stress_change(
                          fault_nodes, node_laws, before, to.normal_stress));

    // Changes that rounding makes alone are none: bodies that hardly anything
    // holds would follow them.
    const std::vector<double> rounding = contact.pressure_rounding(w);
    for (unsigned int k = 0; k < before.size(); ++k)
      if (std::abs(to.normal_stress[k] - before[k]) <= rounding[k])
        to.normal_stress[k] = before[k];
    const double change = fault_norm(
      fault_nodes,
      node_laws,
      relative_stress_change(fault_nodes, node_laws, before, to.normal_stress));
    to.normal_stress = stress.next(before, to.normal_stress, change);
    return change;
  }



  template <int dim, int n_components>
  bool
  RateStateStep<dim, n_components>::have_settled(
    const SolveSummary &rate,
    const double        of_state,
    const double        of_stress,
    const double        change_before,
    const unsigned int  n_iterations) const
  {
    const double change    = std::hypot(of_state, of_stress),
                 remaining = remaining_change(change, change_before);
    if (!std::isfinite(change) ||
        !std::isfinite(rate.iterations.back().correction_norm))
      throw StepFailure("the solution is not a number");
    if (is_nested() && !rate.converged)
      throw StepFailure("the rate problem was not solved within " +
                        std::to_string(rate.iterations.size()) + " iterations");
    if (rate.converged && remaining <= time_parameters.rate_state_tolerance)
      return true;
    if (n_iterations >= time_parameters.max_rate_state_iterations)
      {
        const std::string within = " did not settle within " +
                                   std::to_string(n_iterations) + " iterations";
        if (unilateral.is_needed() && !rate.converged &&
            change <= time_parameters.rate_state_tolerance)
          throw StepFailure(
            "velocities" + within +
            ", which may need more 'TNNMG/Cycles per correction' for a body "
            "that hardly anything but friction holds");
        if (unilateral.is_needed() && of_stress >= of_state)
          throw StepFailure(
            "friction and the normal stress of the contact" + within +
            ", and may have no solution that does where a body leans from the "
            "normal of a fault by less than the angle of friction");
        throw StepFailure("rate and state" + within);
      }
    return false;
  }



  template <int dim, int n_components>
  void
  RateStateStep<dim, n_components>::complete(
    SystemState<dim>                     &to,
    const SystemState<dim>               &from,
    const double                          tau,
    const NodalVector                    &rhs,
    NodalVector                          &w,
    const StepContact<dim, n_components> &contact)
  {
    if (!following.is_needed())
      {
        finish_rate(rhs, w);
        if (!from.contact_pressure.empty())
          to.contact_pressure = contact.pressure(rhs, w);
      }
    problem.to_nodal(to.velocity, w);
    to.slip_rate          = fault_nodes.tangential_jumps(w);
    to.balancing_traction = balancing_tractions(
      fault_nodes, node_laws, to, problem.operators().matrix(), rhs, w);
    time_scheme->complete(to, from, tau);
    const auto squares =
      sums<2>({{local_product(to.velocity, to.velocity),
                local_product(to.displacement, to.displacement)}},
              to.velocity.get_mpi_communicator());
    if (!std::isfinite(squares[0] + squares[1]))
      throw StepFailure("the solution is not a number");
  }



  template <int dim, int n_components>
  void
  RateStateStep<dim, n_components>::finish_rate(const NodalVector &rhs,
                                                NodalVector       &w)
  {
    // A whole solve has done so.
    if (!is_nested())
      solver->finish(rhs, w);
  }



  template class RateStateStep<2>;
  template class RateStateStep<3>;
  template class RateStateStep<2, 1>;
} // namespace StickSlip
