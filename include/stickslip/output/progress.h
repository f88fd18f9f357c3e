// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_progress_h
#define stickslip_output_progress_h

#include <functional>
#include <iosfwd>
#include <string>

namespace StickSlip
{
  /**
   * Progress of a run for the user: percent done, simulated time, step size,
   * largest slip rate and estimated time left. Events take most of the steps:
   * the time left is estimated from the time up to the end of the last one,
   * as if events came as often until the end; before there is one, all that is
   * known is that it takes at least what steps have taken so far. On a terminal
   * one line is rewritten, at most once a second; elsewhere plain lines follow
   * each other, at most one in ten seconds.
   */
  class Progress
  {
  public:
    /**
     * @p clock gives the wall time in s; by default that of the machine.
     */
    Progress(std::ostream                 &out,
             const bool                    is_terminal,
             const double                  end_time,
             const std::function<double()> clock = wall_clock);

    /**
     * Report an accepted step, and how many events have ended so far; prints if
     * enough time has passed.
     */
    void
    update(const double       time,
           const double       step_size,
           const double       slip_rate,
           const unsigned int n_events = 0);

    /**
     * Print the last report if it has not been, and end the line.
     */
    void
    finish();

  private:
    static double
    wall_clock();

    void
    print();

    /** The estimate in words, empty where there is none. */
    std::string
    time_left(const double now) const;

    std::ostream           &out;
    bool                    is_terminal;
    double                  end_time;
    std::function<double()> clock;

    double start_of_run;
    double last_print;

    bool   has_report  = false;
    bool   is_printed  = false;
    double time        = 0;
    double step_size   = 0;
    double slip_rate   = 0;
    double start_time  = 0;
    bool   has_started = false;

    /** Events before this run, and with them; simulated and wall time when the
     * last one had ended. */
    unsigned int n_earlier_events = 0, n_events = 0;
    double       time_of_event = 0, clock_at_event = 0;
    std::size_t  last_length = 0;
  };

  /**
   * A duration in a form for people: 42 s, 3:05, 2:10:00.
   */
  std::string
  duration(const double seconds);
} // namespace StickSlip

#endif
