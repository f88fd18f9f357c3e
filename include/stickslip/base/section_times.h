// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_section_times_h
#define stickslip_base_section_times_h

#include <chrono>
#include <map>
#include <string>

namespace StickSlip
{
  /**
   * Wall times of the sections of a program. Unlike dealii::TimerOutput it asks
   * for no processor time, which takes system calls: a run enters three
   * sections in each of its steps.
   */
  class SectionTimes
  {
  public:
    /** One pass of a section, from here to the end of the block. */
    class Scope
    {
    public:
      Scope(SectionTimes &times, const std::string &section)
        : seconds(times.of_sections[section])
        , start(Clock::now())
      {}

      Scope(const Scope &) = delete;

      Scope &
      operator=(const Scope &) = delete;

      ~Scope()
      {
        seconds += std::chrono::duration<double>(Clock::now() - start).count();
      }

    private:
      using Clock = std::chrono::steady_clock;

      double                 &seconds;
      const Clock::time_point start;
    };

    /** The time in each section entered so far, s, by name. */
    const std::map<std::string, double> &
    seconds() const
    {
      return of_sections;
    }

  private:
    std::map<std::string, double> of_sections;
  };
} // namespace StickSlip

#endif
