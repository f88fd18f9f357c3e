// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/output_cadence.h>

#include <cmath>

namespace StickSlip
{
  OutputCadence::OutputCadence(const double slip_rate_factor,
                               const double slip_interval,
                               const double shortest_interval,
                               const double longest_interval)
    : slip_rate_factor(slip_rate_factor)
    , slip_interval(slip_interval)
    , shortest_interval(shortest_interval)
    , longest_interval(longest_interval)
  {}



  bool
  OutputCadence::is_due(const double time, const double slip_rate) const
  {
    if (!last.has_written)
      return true;

    // Times are sums of steps: an interval of ten steps of 0.1 must not last
    // eleven.
    const double rounding = 1e-12 * std::abs(time);
    const double interval = time - last.time + rounding;
    if (interval >= longest_interval)
      return true;
    if (interval < shortest_interval)
      return false;
    if (slip_interval > 0. && slip_rate * interval >= slip_interval)
      return true;
    if (slip_rate == last.slip_rate)
      return false;
    return slip_rate >= slip_rate_factor * last.slip_rate ||
           slip_rate * slip_rate_factor <= last.slip_rate;
  }



  void
  OutputCadence::note_written(const double time, const double slip_rate)
  {
    last = {true, time, slip_rate};
  }



  void
  OutputCadence::resume(const CadenceState &state)
  {
    last = state;
  }
} // namespace StickSlip
