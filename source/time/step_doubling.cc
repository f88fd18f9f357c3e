// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/step_doubling.h>

namespace StickSlip
{
  template <int dim>
  std::vector<StepResult<dim>>
  StepDoubling<dim>::advance(const SystemState<dim> &state)
  {
    double                         tau = std::min(this->proposed,
                          this->limit(state.time, 2. * this->proposed) / 2.);
    std::optional<StepResult<dim>> large;
    while (true)
      {
        StepResult<dim> first, second;
        std::string     reason;
        if (!large)
          large = this->step.take(state, 2. * tau);
        if (large->converged)
          first = this->step.take(state, tau);
        if (first.converged)
          second = this->step.take(first.state, tau);
        if (second.converged)
          {
            std::vector<double> difference = second.state.alpha;
            for (unsigned int k = 0; k < difference.size(); ++k)
              difference[k] -= large->state.alpha[k];
            if (this->faults.l2_norm(difference) <=
                this->parameters.doubling_threshold)
              {
                this->proposed =
                  std::min(2. * tau, this->parameters.largest_step);
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
        this->reject(state.time, tau, reason);
      }
  }



  template class StepDoubling<2>;
  template class StepDoubling<3>;
} // namespace StickSlip
