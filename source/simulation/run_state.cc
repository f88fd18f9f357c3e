// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/run_state.h>

#include <algorithm>

namespace StickSlip
{
  void
  RunCounts::add(const double step_size, const StepCounts &of_step)
  {
    smallest_step =
      accepted == 0 ? step_size : std::min(smallest_step, step_size);
    largest_step = std::max(largest_step, step_size);
    work += of_step;
    ++accepted;
  }
} // namespace StickSlip
