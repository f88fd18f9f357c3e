// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/fault_norm.h>
#include <stickslip/time/step_doubling.h>

namespace StickSlip
{
  namespace
  {
    /** The value of the linear function through two states a time @p span from
     * each other, a time @p beyond the second one. */
    template <int dim>
    Prediction<dim>
    on_line_through(const SystemState<dim> &a,
                    const SystemState<dim> &b,
                    const double            span,
                    const double            beyond)
    {
      const double    s = beyond / span;
      Prediction<dim> result;
      result.velocity = b.velocity;
      result.velocity.sadd(1. + s, -s, a.velocity);
      const auto extrapolate = [s](std::vector<double>       &values,
                                   const std::vector<double> &before) {
        for (unsigned int k = 0; k < values.size(); ++k)
          values[k] += s * (values[k] - before[k]);
      };
      result.alpha            = b.alpha;
      result.contact_pressure = b.contact_pressure;
      extrapolate(result.alpha, a.alpha);
      extrapolate(result.contact_pressure, a.contact_pressure);
      return result;
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<StepResult<dim>>
  StepDoubling<dim, n_components>::accepted_steps(const SystemState<dim> &state,
                                                  StepMemory<dim> &memory)
  {
    // A step that begins on the line through two states, at its end.
    const auto take_along = [&](const SystemState<dim> &a,
                                const SystemState<dim> &b,
                                const double            span,
                                const double            beyond,
                                const SystemState<dim> &from,
                                const double            tau) {
      const Prediction<dim> prediction = on_line_through(a, b, span, beyond);
      return this->take(memory, from, tau, &prediction);
    };

    double tau =
      std::min(memory.proposed,
               this->limit(memory, state.time, 2. * memory.proposed) / 2.);
    std::optional<StepResult<dim>> large;
    while (true)
      {
        StepResult<dim> first, second;
        std::string     reason;
        if (!large)
          large = memory.before ? take_along(*memory.before,
                                             state,
                                             memory.since_before,
                                             2. * tau,
                                             state,
                                             2. * tau) :
                                  this->take(memory, state, 2. * tau);
        if (large->converged)
          first = take_along(state, large->state, 2. * tau, -tau, state, tau);
        if (first.converged)
          second =
            take_along(state, large->state, 2. * tau, 0., first.state, tau);
        if (second.converged)
          {
            std::vector<double> alpha_difference = second.state.alpha;
            for (unsigned int k = 0; k < alpha_difference.size(); ++k)
              alpha_difference[k] -= large->state.alpha[k];
            const double difference = fault_norm(this->step.faults(),
                                                 this->step.laws(),
                                                 alpha_difference);
            const double threshold  = this->parameters.doubling_threshold;
            if (difference <= threshold)
              {
                memory.proposed = this->on_grid(tau);
                if (growth * difference <= threshold)
                  memory.proposed =
                    std::min<double>(2. * tau, this->parameters.largest_step);
                memory.before       = state;
                memory.since_before = 2. * tau;
                std::vector<StepResult<dim>> accepted;
                accepted.push_back(std::move(first));
                accepted.push_back(std::move(second));
                return accepted;
              }
            reason = "the states of one large and two small steps differ by "
                     "more than Time/Doubling threshold";
          }
        else
          reason = !large->converged ? large->failure :
                   !first.converged  ? first.failure :
                                       second.failure;
        if (first.converged)
          large = std::move(first);
        else
          large.reset();
        tau /= 2.;
        this->reject(memory, state.time, tau, reason);
      }
  }



  template class StepDoubling<2>;
  template class StepDoubling<3>;
  template class StepDoubling<2, 1>;
} // namespace StickSlip
