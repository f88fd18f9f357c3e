// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/progress.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace StickSlip
{
  namespace
  {
    // Wall time in s between two lines.
    constexpr double terminal_interval = 1;
    constexpr double file_interval     = 10;

    // Least time between the ends of two events that count by themselves, over
    // the time so far: one rupture may be an event of several faults.
    constexpr double least_distance = 0.01;
  } // namespace



  Progress::Progress(std::ostream                 &out,
                     const bool                    is_terminal,
                     const double                  end_time,
                     const std::function<double()> clock)
    : out(out)
    , is_terminal(is_terminal)
    , end_time(end_time)
    , clock(clock)
    , start_of_run(this->clock())
    , last_print(start_of_run)
  {}



  void
  Progress::update(const unsigned int step,
                   const double       time,
                   const double       new_step_size,
                   const double       new_slip_rate,
                   const unsigned int new_n_events)
  {
    now = {static_cast<double>(step), time};
    if (!has_started)
      {
        n_earlier_steps = step - 1.;
        n_events        = new_n_events;
        has_started     = true;
      }
    if (new_n_events > n_events)
      {
        n_events = new_n_events;
        if (ends.empty() || time - ends.back().time >= least_distance * time)
          ends.push_back(now);
      }
    step_size  = new_step_size;
    slip_rate  = new_slip_rate;
    is_printed = false;
    has_report = true;

    if (clock() - last_print >=
        (is_terminal ? terminal_interval : file_interval))
      print();
  }



  void
  Progress::finish()
  {
    if (has_report && !is_printed)
      print();
    if (is_terminal && has_report)
      out << '\n';
    out << std::flush;
    has_report = false;
  }



  double
  Progress::wall_clock()
  {
    return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }



  void
  Progress::print()
  {
    last_print = clock();
    is_printed = true;
    const double done =
      end_time > 0. ? std::clamp(now.time / end_time, 0., 1.) : 1.;

    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << std::setw(5) << 100. * done
         << " %  t = " << std::setprecision(4) << now.time
         << " s  step = " << std::scientific << std::setprecision(1)
         << step_size << " s  largest slip rate = " << std::setprecision(2)
         << slip_rate << " m/s";
    line << time_left();

    std::string text = line.str();
    if (is_terminal)
      {
        // Blanks wipe out the rest of a longer line before.
        const std::size_t length = text.size();
        if (length < last_length)
          text.append(last_length - length, ' ');
        last_length = length;
        out << '\r' << text << std::flush;
      }
    else
      out << text << '\n' << std::flush;
  }



  std::string
  Progress::time_left() const
  {
    if (now.time <= 0. || now.time >= end_time)
      return "";
    const double time_of_step =
      (last_print - start_of_run) / (now.steps - n_earlier_steps);
    if (ends.size() < 2)
      return "  time left at least " +
             duration(time_of_step * steps_left(Moment(), now));
    // Steps since the last event are part of the next one; more of them than in
    // those before set the pace.
    const Moment &first = ends[(ends.size() - 1) / 2], &last = ends.back();
    return "  time left " +
           duration(time_of_step *
                    std::max(steps_left(first, last) - (now.steps - last.steps),
                             steps_left(first, now)));
  }



  std::string
  duration(const double seconds)
  {
    const long long total = std::llround(std::min(seconds, 1e9));
    const long long hours = total / 3600, minutes = total / 60 % 60;

    std::ostringstream text;
    text << std::setfill('0');
    if (hours > 0)
      text << hours << ':' << std::setw(2) << minutes << ':' << std::setw(2)
           << total % 60;
    else if (minutes > 0)
      text << minutes << ':' << std::setw(2) << total % 60;
    else
      text << total << " s";
    return text.str();
  }
} // namespace StickSlip
