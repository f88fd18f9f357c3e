// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_explicit_control_h
#define stickslip_time_explicit_control_h

#include <stickslip/time/explicit_step.h>
#include <stickslip/time/step_size_control.h>

namespace StickSlip
{
  /**
   * Explicit steps, with the error that they tell. The next size is 0.9
   * (tolerance / error)^(1/5) times the last, between a fifth and five times,
   * and does not grow right after a rejection; sizes are on no grid.
   */
  template <int dim, int n_components = dim>
  class ExplicitControl : public StepSizeController<dim, n_components>
  {
  public:
    /** For the arguments see StepSizeController. Throws InputError if bodies
     * have mass or viscosity. */
    ExplicitControl(RateStateStep<dim, n_components>  &step,
                    const TimeParameters              &parameters,
                    BoundaryValues<dim, n_components> &loads);

    void
    complete(SystemState<dim> &state) override
    {
      explicit_step.moved_bodies().complete(state);
    }

    FunctionalValues
    body_values(const SystemState<dim>             &state,
                const std::vector<NodalFunctional> &functionals) override
    {
      return explicit_step.moved_bodies().body_values(state, functionals);
    }

  protected:
    std::vector<StepResult<dim>>
    accepted_steps(const SystemState<dim> &state,
                   StepMemory<dim>        &memory) override;

  private:
    ExplicitStep<dim, n_components> explicit_step;
  };
} // namespace StickSlip

#endif
