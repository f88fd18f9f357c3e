// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_doubling_h
#define stickslip_time_step_doubling_h

#include <stickslip/time/step_size_control.h>

namespace StickSlip
{
  /**
   * The published step size control (Pipping, Sander and Kornhuber 2015): one
   * step of 2 tau is compared with two of tau. If their states differ by more
   * than the threshold in the fault_norm(), tau is halved, else the two steps
   * are accepted. The first small step of a rejected attempt serves as the
   * large step of the next one.
   *
   * The published rule then doubles tau always, and half of all attempts fail.
   * Here tau is doubled only if the difference of a step twice as long, which
   * grows fourfold as the local error of a first order method does, would
   * still be below the threshold. The iterations for the large step start from
   * the line through the last two states, those for the small ones from the
   * line to the large one's result.
   */
  template <int dim, int n_components = dim>
  class StepDoubling : public StepSizeController<dim, n_components>
  {
  public:
    using StepSizeController<dim, n_components>::StepSizeController;

  protected:
    std::vector<StepResult<dim>>
    accepted_steps(const SystemState<dim> &state,
                   StepMemory<dim>        &memory) override;

  private:
    /** Growth of the difference when tau is doubled. */
    static constexpr double growth = 4.;
  };
} // namespace StickSlip

#endif
