// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_embedded_control_h
#define stickslip_time_embedded_control_h

#include <stickslip/time/step_size_control.h>

namespace StickSlip
{
  /**
   * Step size control by an error estimate from the history, at one solve a
   * step. The next size is 0.8 (tolerance / error)^(1/3) times the last,
   * between a fifth and twice, and does not grow right after a rejection.
   */
  template <int dim, int n_components = dim>
  class EmbeddedControl : public StepSizeController<dim, n_components>
  {
  public:
    using StepSizeController<dim, n_components>::StepSizeController;

  protected:
    std::vector<StepResult<dim>>
    accepted_steps(const SystemState<dim> &state,
                   StepMemory<dim>        &memory) override;

    /** A step of size @p tau from the last state of @p history, counted. */
    virtual StepResult<dim>
    attempt(StepMemory<dim>                      &memory,
            const StepHistory<dim, n_components> &history,
            const SystemState<dim>               &state,
            const double                          tau);
  };
} // namespace StickSlip

#endif
