// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/embedded_control.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    /** Size of the next step over that of one that uses this part of the error
     * allowed. */
    double
    growth(const double part_of_allowed, const bool just_rejected)
    {
      const double factor = 0.8 / std::cbrt(std::max(part_of_allowed, 1e-3));
      return std::clamp(factor, 0.2, just_rejected ? 1. : 2.);
    }



    /** The end of a step before impacts, which its past knows nothing of. */
    template <int dim, int n_components>
    PastState<dim>
    before_impacts(const StepHistory<dim, n_components> &history,
                   const StepResult<dim>                &step)
    {
      if (step.slip_rate_before_impacts.empty())
        return history.record(step.state, step.step_size);
      SystemState<dim> state = step.state;
      state.slip_rate        = step.slip_rate_before_impacts;
      return history.record(state, step.step_size);
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<StepResult<dim>>
  EmbeddedControl<dim, n_components>::accepted_steps(
    const SystemState<dim> &state,
    StepMemory<dim>        &memory)
  {
    StepHistory<dim, n_components> history = this->history(memory, state);
    const auto part_of_allowed             = [&](const StepError &error) {
      return error.part_of(this->parameters.tolerance,
                           this->parameters.body_tolerance);
    };
    // The error of waves in a step grows with the square of its size.
    const auto blind_step = [&]() {
      return std::sqrt(this->parameters.body_tolerance) * history.wave_time();
    };
    const double largest =
      history.sees_bodies() ?
        memory.proposed :
        this->on_grid(std::min(memory.proposed, blind_step()));
    // Time until sides come together, s; zero where no step is to end there.
    double contact = 0.;
    while (true)
      {
        const double tau =
          this->limit(memory,
                      state.time,
                      contact > 0. ? contact :
                                     std::min(memory.proposed, largest));
        StepResult<dim> result = attempt(memory, history, state, tau);
        double          factor = 0.5;
        std::string     reason = result.failure;
        if (result.converged)
          {
            PastState<dim> now = before_impacts(history, result);
            memory.last_error  = history.estimate_error(now);
            const double part  = part_of_allowed(memory.last_error);
            factor             = growth(part, memory.just_rejected);
            const bool lands   = !result.slip_rate_before_impacts.empty();
            if (part <= 1. && (contact > 0. || !lands || tau <= blind_step()))
              {
                memory.largest_error =
                  memory.largest_error.larger(memory.last_error);
                // A step cut short by the end of the ramp or of the run says
                // nothing against the size that was proposed.
                if (tau >= memory.proposed || factor < 1.)
                  memory.proposed = this->on_grid(factor * tau);
                memory.just_rejected = false;
                // Rates that have jumped begin anew, and short steps to the
                // moment of contact tell nothing of longer ones.
                bool begins_anew = contact > 0.;
                if (!result.slip_rate_before_impacts.empty())
                  {
                    now = history.record(result.state, tau);
                    begins_anew =
                      begins_anew ||
                      part_of_allowed(history.estimate_error(now)) > 1.;
                  }
                if (begins_anew)
                  history.restart(std::move(now));
                else
                  history.add(std::move(now));
                std::vector<StepResult<dim>> accepted;
                accepted.push_back(std::move(result));
                return accepted;
              }
            reason  = memory.last_error.faults > this->parameters.tolerance ?
                        "the estimated error stays above Time/Tolerance" :
                        "the estimated error of the bodies stays above "
                        "Time/Body tolerance";
            contact = result.slip_rate_before_impacts.empty() ?
                        0. :
                        this->time_of_contact(state, result).value_or(0.);
          }
        else
          contact = 0.;
        // A step that ends with an impact is as smooth as others.
        if (contact == 0.)
          {
            // Not std::min(factor, 0.5): the factor may be no number.
            memory.proposed =
              this->on_grid((factor < 0.5 ? factor : 0.5) * tau);
            memory.just_rejected = true;
          }
        this->reject(memory, state.time, memory.proposed, reason);
      }
  }



  template <int dim, int n_components>
  StepResult<dim>
  EmbeddedControl<dim, n_components>::attempt(
    StepMemory<dim>                      &memory,
    const StepHistory<dim, n_components> &history,
    const SystemState<dim>               &state,
    const double                          tau)
  {
    const Prediction<dim> prediction = history.predict(state, tau);
    return this->take(memory, state, tau, &prediction);
  }



  template class EmbeddedControl<2>;
  template class EmbeddedControl<3>;
  template class EmbeddedControl<2, 1>;
} // namespace StickSlip
