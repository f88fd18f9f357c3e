// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/time_resolution.h>
#include <stickslip/time/central_differences_control.h>
#include <stickslip/time/embedded_control.h>
#include <stickslip/time/explicit_control.h>
#include <stickslip/time/step_doubling.h>
#include <stickslip/time/step_size_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace StickSlip
{
  template <int dim, int n_components>
  FunctionalValues
  StepSizeController<dim, n_components>::body_values(
    const SystemState<dim>             &state,
    const std::vector<NodalFunctional> &functionals)
  {
    FunctionalValues result;
    for (const NodalFunctional &functional : functionals)
      {
        result.of_displacement.push_back(
          part_of_value(functional, state.displacement));
        result.of_velocity.push_back(part_of_value(functional, state.velocity));
      }
    const MPI_Comm communicator = state.displacement.get_mpi_communicator();
    for (std::vector<double> *values :
         {&result.of_displacement, &result.of_velocity})
      Utilities::MPI::sum(*values, communicator, *values);
    return result;
  }



  template <int dim, int n_components>
  std::vector<StepResult<dim>>
  StepSizeController<dim, n_components>::advance(const SystemState<dim> &state,
                                                 StepMemory<dim>        &memory)
  {
    if (memory.proposed == 0.)
      memory.proposed = parameters.control == StepSizeControl::constant ?
                          static_cast<double>(parameters.largest_step) :
                          on_grid(parameters.initial_step);
    return accepted_steps(state, memory);
  }



  namespace
  {
    /** Sides that come together this soon after the start of a step, or before
     * its end, over its size, are no reason to split it. */
    constexpr double least_part = 0.02;
  } // namespace



  template <int dim, int n_components>
  std::optional<double>
  StepSizeController<dim, n_components>::time_of_contact(
    const SystemState<dim> &from,
    const StepResult<dim>  &step_taken) const
  {
    const SystemState<dim> &to       = step_taken.state;
    const double            tau      = step_taken.step_size;
    double                  earliest = tau;
    for (unsigned int k = 0; k < to.gap.size(); ++k)
      if (from.gap[k] > 0. && to.gap[k] == 0. && from.opening_rate[k] < 0.)
        earliest = std::min(earliest, -from.gap[k] / from.opening_rate[k]);
    if (earliest <= time_resolution(to.time) || earliest >= (1. - 1e-6) * tau)
      return {};
    return earliest;
  }



  template <int dim, int n_components>
  StepResult<dim>
  StepSizeController<dim, n_components>::take(
    StepMemory<dim>        &memory,
    const SystemState<dim> &from,
    const double            tau,
    const Prediction<dim>  *prediction) const
  {
    const auto count = [&](const StepResult<dim> &result) {
      ++memory.n_solved;
      memory.work += result.counts;
    };
    StepResult<dim> result = step.take(from, tau, prediction);
    count(result);
    const ContactEnergy &energy = result.contact_energy;
    if (!result.converged ||
        energy.lost <= parameters.impact_tolerance * energy.kinetic)
      return result;

    const std::optional<double> before = time_of_contact(from, result);
    if (!before || *before < least_part * tau ||
        *before > (1. - least_part) * tau)
      return result;
    StepResult<dim> first = step.take(from, *before);
    count(first);
    if (!first.converged || first.contact_energy.lost >= energy.lost)
      return result;
    StepResult<dim> second = step.take(first.state, tau - *before);
    count(second);
    if (!second.converged ||
        first.contact_energy.lost + second.contact_energy.lost >= energy.lost)
      return result;
    second.step_size  = tau;
    second.state.time = result.state.time;
    second.counts += first.counts;
    second.before_contact =
      std::make_shared<const StepResult<dim>>(std::move(first));
    return second;
  }



  template <int dim, int n_components>
  StepHistory<dim, n_components>
  StepSizeController<dim, n_components>::history(
    StepMemory<dim>        &memory,
    const SystemState<dim> &state) const
  {
    using Problem                          = SpatialProblem<dim, n_components>;
    const Problem                 &problem = step.spatial_problem();
    StepHistory<dim, n_components> result(step.faults(),
                                          step.laws(),
                                          step.scheme(),
                                          problem.has(Problem::mass) ?
                                            &problem.nodal_masses() :
                                            nullptr,
                                          memory.past);
    if (memory.past.empty())
      result.add(result.record(state, 0.));
    return result;
  }



  template <int dim, int n_components>
  double
  StepSizeController<dim, n_components>::on_grid(const double tau) const
  {
    // Sizes that were computed as a grid size must not fall to the next.
    const double halvings = std::ceil(std::log2(longest_step() / tau) - 1e-9);
    return longest_step() * std::exp2(-std::max(0., halvings));
  }



  template <int dim, int n_components>
  double
  StepSizeController<dim, n_components>::limit(StepMemory<dim> &memory,
                                               const double     time,
                                               const double     tau) const
  {
    const double longest_ramp = step.longest_ramp();
    double       limited      = tau;
    const double end          = next_end(time);
    const double remaining    = end - time;
    if (time < longest_ramp && parameters.control != StepSizeControl::constant)
      limited =
        std::min(limited, on_grid(parameters.ramp_fraction * longest_ramp));
    else if (parameters.control != StepSizeControl::constant)
      while (limited / 2. >= parameters.initial_step &&
             loads.loading_error(time, limited, memory.largest_loads) >
               parameters.loading_tolerance)
        limited = on_grid(limited / 2.);
    if (limited >= remaining * (1. - 1e-12))
      limited = remaining;
    // Two steps of the same size, rather than a long and a short one.
    else if (end < parameters.end_time && 2. * limited > remaining)
      limited = remaining / 2.;
    return limited;
  }



  template <int dim, int n_components>
  double
  StepSizeController<dim, n_components>::next_end(const double time) const
  {
    if (parameters.control != StepSizeControl::constant)
      for (const double end : parameters.step_ends)
        if (end - time > 1e-12 * parameters.end_time &&
            end < parameters.end_time)
          return end;
    return parameters.end_time;
  }



  template <int dim, int n_components>
  void
  StepSizeController<dim, n_components>::reject(StepMemory<dim> &memory,
                                                const double     time,
                                                const double     next_step_size,
                                                const std::string &reason) const
  {
    ++memory.n_rejected;
    if (next_step_size < parameters.smallest_step)
      {
        std::ostringstream message;
        message.precision(9);
        message << "At t = " << time << " s no time step down to the smallest "
                << "one allowed, Time/Smallest step = "
                << parameters.smallest_step << " s, can be taken: " << reason
                << ".";
        throw StepSizeTooSmall(message.str());
      }
    if (must_stop && must_stop())
      throw StepInterrupted();
  }



  namespace
  {
    /**
     * Steps of the same size, halved only where one cannot be solved. Their
     * error is estimated, but nothing follows from it.
     */
    template <int dim, int n_components>
    class ConstantStep : public StepSizeController<dim, n_components>
    {
    public:
      using StepSizeController<dim, n_components>::StepSizeController;

    protected:
      std::vector<StepResult<dim>>
      accepted_steps(const SystemState<dim> &state,
                     StepMemory<dim>        &memory) override
      {
        StepHistory<dim, n_components> history = this->history(memory, state);
        double tau = this->limit(memory, state.time, memory.proposed);
        while (true)
          {
            StepResult<dim> result = this->take(memory, state, tau);
            if (result.converged)
              {
                PastState<dim> now = history.record(result.state, tau);
                memory.last_error  = history.estimate_error(now);
                memory.largest_error =
                  memory.largest_error.larger(memory.last_error);
                history.add(std::move(now));
                std::vector<StepResult<dim>> accepted;
                accepted.push_back(std::move(result));
                return accepted;
              }
            this->reject(memory, state.time, tau / 2., result.failure);
            tau /= 2.;
          }
      }
    };
  } // namespace



  template <int dim, int n_components>
  std::unique_ptr<StepSizeController<dim, n_components>>
  make_step_size_controller(RateStateStep<dim, n_components>  &step,
                            const TimeParameters              &parameters,
                            BoundaryValues<dim, n_components> &loads)
  {
    switch (parameters.control)
      {
        case StepSizeControl::embedded:
          return std::make_unique<EmbeddedControl<dim, n_components>>(
            step, parameters, loads);
        case StepSizeControl::step_doubling:
          return std::make_unique<StepDoubling<dim, n_components>>(step,
                                                                   parameters,
                                                                   loads);
        case StepSizeControl::constant:
          return std::make_unique<ConstantStep<dim, n_components>>(step,
                                                                   parameters,
                                                                   loads);
        case StepSizeControl::central_differences:
          return std::make_unique<CentralDifferencesControl<dim, n_components>>(
            step, parameters, loads);
        case StepSizeControl::runge_kutta:
          return std::make_unique<ExplicitControl<dim, n_components>>(
            step, parameters, loads);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }



  template class StepSizeController<2>;
  template class StepSizeController<3>;
  template class StepSizeController<2, 1>;
  template decltype(make_step_size_controller<2>) make_step_size_controller<2>;
  template decltype(make_step_size_controller<3>) make_step_size_controller<3>;
  template decltype(make_step_size_controller<2, 1>)
    make_step_size_controller<2, 1>;
} // namespace StickSlip
