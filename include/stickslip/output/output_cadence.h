// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_cadence_h
#define stickslip_output_output_cadence_h

#include <stickslip/base/automatic_number.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  /**
   * Memory of the last time that something was written.
   */
  struct CadenceState
  {
    bool   has_written = false;
    double time        = 0;
    double slip_rate   = 0;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &has_written &time &slip_rate;
    }
  };

  /**
   * Cadence of output.
   */
  struct CadenceParameters
  {
    /** Change of the slip rate, up or down, since the last time. */
    double slip_rate_factor;
    /** Slip since the last time, from the slip rate, m; zero: not for this
     * reason. */
    AutomaticNumber slip_interval;
    /** Shortest and longest time since the last time, s. */
    double          shortest_interval;
    AutomaticNumber longest_interval;
  };

  /**
   * Decides after which steps something is written: often while the slip rate
   * changes fast, rarely while nothing happens. That is when the slip rate has
   * changed by a factor, or would have made the fault slip far enough, but not
   * before the shortest interval has passed, and in any case after the longest
   * one.
   */
  class OutputCadence
  {
  public:
    explicit OutputCadence(const CadenceParameters &parameters)
      : parameters(parameters)
    {}

    /**
     * True if it is time to write, at the largest @p slip_rate of any fault in
     * m/s. The first time always.
     */
    bool
    is_due(const double time, const double slip_rate) const
    {
      if (!last.has_written)
        return true;

      // Times are sums of steps: an interval of ten steps of 0.1 must not last
      // eleven. After centuries the first bound would be steps of an event.
      const double passed   = time - last.time;
      const double rounding = std::min(1e-12 * std::abs(time), 1e-6 * passed);
      const double interval = passed + rounding;
      if (interval >= parameters.longest_interval)
        return true;
      if (interval < parameters.shortest_interval)
        return false;
      if (parameters.slip_interval > 0. &&
          slip_rate * interval >= parameters.slip_interval)
        return true;
      if (slip_rate == last.slip_rate)
        return false;
      return slip_rate >= parameters.slip_rate_factor * last.slip_rate ||
             slip_rate * parameters.slip_rate_factor <= last.slip_rate;
    }

    /**
     * Take note of something written at this time and slip rate.
     */
    void
    note_written(const double time, const double slip_rate)
    {
      last = {true, time, slip_rate};
    }

    /**
     * Memory of the last time that something was written.
     */
    const CadenceState &
    state() const
    {
      return last;
    }

    /**
     * Go on from another cadence's state.
     */
    void
    resume(const CadenceState &state)
    {
      last = state;
    }

  private:
    CadenceParameters parameters;
    CadenceState      last;
  };
} // namespace StickSlip

#endif
