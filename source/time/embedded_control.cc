// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/embedded_control.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  EmbeddedControl<dim>::EmbeddedControl(RateStateStep<dim>    &step,
                                        const FaultNodes<dim> &faults,
                                        const TimeParameters  &parameters,
                                        BoundaryValues<dim>   &loads)
    : StepSizeController<dim>(step, faults, parameters, loads)
    , history(faults, parameters.inertia)
  {}



  template <int dim>
  std::vector<StepResult<dim>>
  EmbeddedControl<dim>::advance(const SystemState<dim> &state)
  {
    const double tolerance = this->parameters.tolerance;
    if (history.is_empty())
      history.add(history.record(state));

    while (true)
      {
        const double          tau = this->limit(state.time, this->proposed);
        const Prediction<dim> prediction = history.predict(state, tau);
        StepResult<dim>       result = this->step.take(state, tau, &prediction);
        if (!result.converged)
          {
            this->proposed = this->on_grid(tau / 2.);
            just_rejected  = true;
            this->reject(state.time, this->proposed, result.failure);
            continue;
          }

        typename StepHistory<dim>::Record now = history.record(result.state);
        last_error                            = history.estimate_error(now);
        double factor =
          0.8 * std::cbrt(tolerance / std::max(last_error, 1e-3 * tolerance));
        factor = std::clamp(factor, 0.2, just_rejected ? 1. : 2.);
        if (!(last_error <= tolerance))
          {
            // Not std::min(factor, 0.5): the factor may be no number.
            this->proposed = this->on_grid((factor < 0.5 ? factor : 0.5) * tau);
            just_rejected  = true;
            this->reject(state.time,
                         this->proposed,
                         "the estimated error stays above Time/Tolerance");
            continue;
          }
        this->largest_error = std::max(this->largest_error, last_error);
        // A step cut short by the end of the ramp or of the run says nothing
        // against the size that was proposed.
        if (tau >= this->proposed || factor < 1.)
          this->proposed = this->on_grid(factor * tau);
        just_rejected = false;
        history.add(std::move(now));

        std::vector<StepResult<dim>> accepted;
        accepted.push_back(std::move(result));
        return accepted;
      }
  }



  template <int dim>
  double
  EmbeddedControl<dim>::estimated_error() const
  {
    return last_error;
  }



  template class EmbeddedControl<2>;
  template class EmbeddedControl<3>;
} // namespace StickSlip
