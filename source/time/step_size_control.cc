// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/embedded_control.h>
#include <stickslip/time/step_doubling.h>
#include <stickslip/time/step_history.h>
#include <stickslip/time/step_size_control.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace StickSlip
{
  template <int dim>
  StepSizeController<dim>::StepSizeController(RateStateStep<dim>    &step,
                                              const FaultNodes<dim> &faults,
                                              const TimeParameters  &parameters,
                                              BoundaryValues<dim>   &loads)
    : step(step)
    , faults(faults)
    , parameters(parameters)
    , loads(loads)
    , longest_ramp(step.longest_ramp())
  {
    proposed = parameters.control == StepSizeControl::constant ?
                 parameters.largest_step :
                 on_grid(parameters.initial_step);
  }



  template <int dim>
  bool
  StepSizeController<dim>::is_finished(const double time) const
  {
    return parameters.end_time - time <= 1e-12 * parameters.end_time;
  }



  template <int dim>
  unsigned int
  StepSizeController<dim>::n_rejected() const
  {
    return rejections;
  }



  template <int dim>
  double
  StepSizeController<dim>::largest_estimated_error() const
  {
    return largest_error;
  }



  template <int dim>
  double
  StepSizeController<dim>::on_grid(const double tau) const
  {
    // Sizes that were computed as a grid size must not fall to the next.
    const double halvings =
      std::ceil(std::log2(parameters.largest_step / tau) - 1e-9);
    return parameters.largest_step * std::exp2(-std::max(0., halvings));
  }



  template <int dim>
  double
  StepSizeController<dim>::limit(const double time, const double tau) const
  {
    double       limited   = tau;
    const double remaining = parameters.end_time - time;
    if (time < longest_ramp && parameters.control != StepSizeControl::constant)
      limited =
        std::min(limited, on_grid(parameters.ramp_fraction * longest_ramp));
    else if (parameters.control != StepSizeControl::constant)
      while (limited / 2. >= parameters.initial_step &&
             loads.loading_error(time, limited) > parameters.loading_tolerance)
        limited = on_grid(limited / 2.);
    if (limited >= remaining * (1. - 1e-12))
      limited = remaining;
    return limited;
  }



  template <int dim>
  void
  StepSizeController<dim>::reject(const double       time,
                                  const double       next_step_size,
                                  const std::string &reason)
  {
    ++rejections;
    if (next_step_size < parameters.smallest_step)
      {
        std::ostringstream message;
        message.precision(9);
        message << "At t = " << time << " s no time step down to the smallest "
                << "one allowed, Time/Smallest step = "
                << parameters.smallest_step << " s, can be taken: " << reason
                << ".";
        if (parameters.inertia == Inertia::quasi_static)
          message
            << " With Time/Inertia = quasi-static slip rates can grow without "
               "bound where a fault becomes unstable; with quasi-dynamic and "
               "dynamic they do not.";
        throw StepSizeTooSmall(message.str());
      }
  }



  namespace
  {
    /**
     * Steps of the same size, halved only where one cannot be solved. Their
     * error is estimated, but nothing follows from it.
     */
    template <int dim>
    class ConstantStep : public StepSizeController<dim>
    {
    public:
      ConstantStep(RateStateStep<dim>    &step,
                   const FaultNodes<dim> &faults,
                   const TimeParameters  &parameters,
                   BoundaryValues<dim>   &loads)
        : StepSizeController<dim>(step, faults, parameters, loads)
        , history(faults, parameters.inertia)
      {}

      std::vector<StepResult<dim>>
      advance(const SystemState<dim> &state) override
      {
        if (history.is_empty())
          history.add(history.record(state));
        double tau = this->limit(state.time, this->proposed);
        while (true)
          {
            StepResult<dim> result = this->step.take(state, tau);
            if (result.converged)
              {
                typename StepHistory<dim>::Record now =
                  history.record(result.state);
                this->largest_error =
                  std::max(this->largest_error, history.estimate_error(now));
                history.add(std::move(now));
                std::vector<StepResult<dim>> accepted;
                accepted.push_back(std::move(result));
                return accepted;
              }
            this->reject(state.time, tau / 2., result.failure);
            tau /= 2.;
          }
      }

    private:
      StepHistory<dim> history;
    };
  } // namespace



  template <int dim>
  std::unique_ptr<StepSizeController<dim>>
  make_step_size_controller(RateStateStep<dim>    &step,
                            const FaultNodes<dim> &faults,
                            const TimeParameters  &parameters,
                            BoundaryValues<dim>   &loads)
  {
    switch (parameters.control)
      {
        case StepSizeControl::embedded:
          return std::make_unique<EmbeddedControl<dim>>(step,
                                                        faults,
                                                        parameters,
                                                        loads);
        case StepSizeControl::step_doubling:
          return std::make_unique<StepDoubling<dim>>(step,
                                                     faults,
                                                     parameters,
                                                     loads);
        case StepSizeControl::constant:
          return std::make_unique<ConstantStep<dim>>(step,
                                                     faults,
                                                     parameters,
                                                     loads);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }



#define STICKSLIP_INSTANTIATE(dim)                        \
  template class StepSizeController<dim>;                 \
  template std::unique_ptr<StepSizeController<dim>>       \
  make_step_size_controller<dim>(RateStateStep<dim> &,    \
                                 const FaultNodes<dim> &, \
                                 const TimeParameters &,  \
                                 BoundaryValues<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
