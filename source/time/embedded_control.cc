// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/embedded_control.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    /** Size of the next step over that of one with this error. */
    double
    growth(const double error, const double tolerance, const bool just_rejected)
    {
      const double factor =
        0.8 * std::cbrt(tolerance / std::max(error, 1e-3 * tolerance));
      return std::clamp(factor, 0.2, just_rejected ? 1. : 2.);
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<StepResult<dim>>
  EmbeddedControl<dim, n_components>::accepted_steps(
    const SystemState<dim> &state,
    StepMemory<dim>        &memory)
  {
    StepHistory<dim, n_components> history = this->history(memory, state);
    while (true)
      {
        const double tau = this->limit(memory, state.time, memory.proposed);
        const Prediction<dim> prediction = history.predict(state, tau);
        StepResult<dim> result = this->take(memory, state, tau, &prediction);
        double          factor = 0.5;
        std::string     reason = result.failure;
        if (result.converged)
          {
            const double   tolerance = this->parameters.tolerance;
            PastState<dim> now       = history.record(result.state, tau);
            memory.last_error        = history.estimate_error(now);
            factor = growth(memory.last_error, tolerance, memory.just_rejected);
            if (memory.last_error <= tolerance)
              {
                memory.largest_error =
                  std::max(memory.largest_error, memory.last_error);
                // A step cut short by the end of the ramp or of the run says
                // nothing against the size that was proposed.
                if (tau >= memory.proposed || factor < 1.)
                  memory.proposed = this->on_grid(factor * tau);
                memory.just_rejected = false;
                history.add(std::move(now));
                std::vector<StepResult<dim>> accepted;
                accepted.push_back(std::move(result));
                return accepted;
              }
            reason = "the estimated error stays above Time/Tolerance";
          }
        // Not std::min(factor, 0.5): the factor may be no number.
        memory.proposed = this->on_grid((factor < 0.5 ? factor : 0.5) * tau);
        memory.just_rejected = true;
        this->reject(memory, state.time, memory.proposed, reason);
      }
  }



  template class EmbeddedControl<2>;
  template class EmbeddedControl<3>;
  template class EmbeddedControl<2, 1>;
} // namespace StickSlip
