// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_cadence_h
#define stickslip_output_output_cadence_h

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
   * Decides after which steps something is written: often while the slip rate
   * changes fast, rarely while nothing happens.
   */
  class OutputCadence
  {
  public:
    /**
     * Write when the slip rate has changed by @p slip_rate_factor up or down
     * since the last time, or would have made the fault slip by @p
     * slip_interval since then (m; zero: never for this reason), but not before
     * @p shortest_interval has passed, and in any case after @p
     * longest_interval; both in s.
     */
    OutputCadence(const double slip_rate_factor,
                  const double slip_interval,
                  const double shortest_interval,
                  const double longest_interval);

    /**
     * True if it is time to write, at the largest @p slip_rate of any fault in
     * m/s. The first time always.
     */
    bool
    is_due(const double time, const double slip_rate) const;

    /**
     * Take note of something written at this time and slip rate.
     */
    void
    note_written(const double time, const double slip_rate);

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
    resume(const CadenceState &state);

  private:
    double slip_rate_factor;
    double slip_interval;
    double shortest_interval;
    double longest_interval;

    CadenceState last;
  };
} // namespace StickSlip

#endif
