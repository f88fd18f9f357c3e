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
  Progress::update(const double       new_time,
                   const double       new_step_size,
                   const double       new_slip_rate,
                   const unsigned int new_n_events)
  {
    if (!has_started)
      {
        // A run may begin later than at zero.
        start_time       = new_time - new_step_size;
        n_earlier_events = n_events = new_n_events;
        has_started                 = true;
      }
    if (new_n_events > n_events)
      {
        n_events       = new_n_events;
        time_of_event  = new_time;
        clock_at_event = clock();
      }
    time       = new_time;
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
    last_print                   = clock();
    is_printed                   = true;
    const double duration_of_run = end_time - start_time;
    const double done =
      duration_of_run > 0 ?
        std::clamp((time - start_time) / duration_of_run, 0., 1.) :
        1.;

    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << std::setw(5) << 100. * done
         << " %  t = " << std::setprecision(4) << time
         << " s  step = " << std::scientific << std::setprecision(1)
         << step_size << " s  largest slip rate = " << std::setprecision(2)
         << slip_rate << " m/s";
    line << time_left(last_print);

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
  Progress::time_left(const double now) const
  {
    if (time <= start_time || time >= end_time)
      return "";
    const auto at_pace = [this](const double wall, const double simulated) {
      return simulated > 0. ? wall / simulated * (end_time - time) : 0.;
    };
    if (n_events == n_earlier_events)
      return "  time left at least " +
             duration(at_pace(now - start_of_run, time - start_time));
    // The present cycle is under way: its time does not come again, but what
    // is left takes the pace of it at least.
    const double until_end = (clock_at_event - start_of_run) /
                             (time_of_event - start_time) *
                             (end_time - time_of_event);
    return "  time left " +
           duration(
             std::max(until_end - (now - clock_at_event),
                      at_pace(now - clock_at_event, time - time_of_event)));
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
