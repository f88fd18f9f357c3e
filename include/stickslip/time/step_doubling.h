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
   * than the threshold in L2(fault), tau is halved, else the two steps are
   * accepted and tau is doubled. The first small step of a rejected attempt
   * serves as the large step of the next one.
   */
  template <int dim>
  class StepDoubling : public StepSizeController<dim>
  {
  public:
    using StepSizeController<dim>::StepSizeController;

    std::vector<StepResult<dim>>
    advance(const SystemState<dim> &state) override;
  };
} // namespace StickSlip

#endif
