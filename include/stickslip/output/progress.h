// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_progress_h
#define stickslip_output_progress_h

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Progress of a run for the user: percent done, simulated time, step size,
   * largest slip rate and estimated time left. Events take most of the steps:
   * those that are left are estimated as if they came as often until the end as
   * in the later half of the events so far, since what a run begins with
   * is no measure for what follows. Before two events have ended, all that is
   * known is that it takes at least the steps for each second that there have
   * been so far. On a terminal one line is rewritten, at most once a second;
   * elsewhere plain lines follow each other, at most one in ten seconds.
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
     * Report the accepted step of number @p step, from one, and how many events
     * have ended so far; prints if enough time has passed.
     */
    void
    update(const unsigned int step,
           const double       time,
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
    time_left() const;

    /** A number of steps, and the time after them. */
    struct Moment
    {
      double steps = 0;
      double time  = 0;
    };

    /** Steps until the end at the pace of those between two moments. */
    double
    steps_left(const Moment &from, const Moment &to) const
    {
      return (to.steps - from.steps) / (to.time - from.time) *
             (end_time - to.time);
    }

    std::ostream           &out;
    bool                    is_terminal;
    double                  end_time;
    std::function<double()> clock;

    double start_of_run;
    double last_print;

    bool   has_report  = false;
    bool   is_printed  = false;
    bool   has_started = false;
    Moment now;
    double step_size = 0;
    double slip_rate = 0;

    /** Steps before this run, which may go on with another one. */
    double n_earlier_steps = 0;

    /** Number of events so far, and ends of those of this run. */
    unsigned int        n_events = 0;
    std::vector<Moment> ends;
    std::size_t         last_length = 0;
  };

  /**
   * A duration in a form for people: 42 s, 3:05, 2:10:00.
   */
  std::string
  duration(const double seconds);
} // namespace StickSlip

#endif
