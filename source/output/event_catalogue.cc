// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/event_catalogue.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    // Part of a step that has passed when the slip rate reaches a level between
    // the slip rates at its ends.
    double
    crossing(const double before, const double after, const double level)
    {
      // A fault at rest has no logarithm.
      const double smallest = std::numeric_limits<double>::min();
      const double from     = std::log(std::max(before, smallest));
      const double to       = std::log(std::max(after, smallest));
      if (from == to)
        return 1.;
      return std::clamp((std::log(level) - from) / (to - from), 0., 1.);
    }

  } // namespace



  template <int dim>
  EventCatalogue<dim>::EventCatalogue(
    const std::string                   &file_name,
    const std::vector<std::string>      &fault_names,
    const std::vector<FaultLayout<dim>> &shapes,
    const double                         start_slip_rate,
    const double                         end_fraction)
    : positions(shapes)
    , file(file_name)
    , start_slip_rate(start_slip_rate)
    , end_slip_rate(end_fraction * start_slip_rate)
  {
    Assert(start_slip_rate > 0 && end_fraction > 0 && end_fraction <= 1,
           ExcMessage("Events need a threshold."));
    AssertDimension(fault_names.size(), shapes.size());
    memory.faults.resize(fault_names.size());
    for (unsigned int i = 0; i < fault_names.size(); ++i)
      memory.faults[i].name = fault_names[i];
    file << "fault,start,peak_time,end,peak_mean_slip_rate,peak_slip_rate,"
            "mean_slip" +
              positions.titles("nucleation");
    file.end_row();
  }



  template <int dim>
  void
  EventCatalogue<dim>::add(const double                           time,
                           const std::vector<FaultSnapshot<dim>> &faults)
  {
    AssertDimension(faults.size(), memory.faults.size());
    for (unsigned int i = 0; i < memory.faults.size(); ++i)
      add(i, time, fault_statistics(faults[i]));
  }



  template <int dim>
  void
  EventCatalogue<dim>::add(const unsigned int     fault,
                           const double           time,
                           const FaultStatistics &now)
  {
    EventState::Fault     &record = memory.faults[fault];
    const FaultStatistics &past   = record.statistics;

    // The value a crossing of the given level has, by the part of the step.
    const auto interpolate =
      [&](const double level, const double before, const double after) {
        if (!record.has_past)
          return after;
        const double part =
          crossing(past.mean_slip_rate, now.mean_slip_rate, level);
        return before + part * (after - before);
      };

    const bool was_fast =
      record.has_past && past.max_slip_rate > start_slip_rate;
    if (now.max_slip_rate > start_slip_rate && !was_fast)
      record.nucleation = positions.at(fault, now.fastest_node);

    if (!record.is_open && now.mean_slip_rate > start_slip_rate)
      {
        record.is_open     = true;
        record.event       = SlipEvent();
        record.event.fault = record.name;
        record.event.start = interpolate(start_slip_rate, record.time, time);
        record.start_slip =
          interpolate(start_slip_rate, past.mean_slip, now.mean_slip);
        record.event.nucleation = record.nucleation;
      }

    if (record.is_open)
      {
        SlipEvent &event = record.event;
        event.mean_slip  = now.mean_slip - record.start_slip;
        event.peak_slip_rate =
          std::max(event.peak_slip_rate, now.max_slip_rate);
        if (now.mean_slip_rate > event.peak_mean_slip_rate)
          {
            event.peak_mean_slip_rate = now.mean_slip_rate;
            event.peak_time           = time;
          }
        if (now.mean_slip_rate < end_slip_rate)
          {
            event.end = interpolate(end_slip_rate, record.time, time);
            event.mean_slip =
              interpolate(end_slip_rate, past.mean_slip, now.mean_slip) -
              record.start_slip;
            record.is_open = false;
            write(event);
          }
      }

    record.has_past   = true;
    record.time       = time;
    record.statistics = now;
  }



  template <int dim>
  void
  EventCatalogue<dim>::finish()
  {
    for (EventState::Fault &record : memory.faults)
      if (record.is_open)
        {
          record.is_open = false;
          write(record.event);
        }
  }



  template <int dim>
  void
  EventCatalogue<dim>::resume(const EventState &state)
  {
    AssertDimension(state.faults.size(), memory.faults.size());
    memory.faults = state.faults;
    for (const SlipEvent &event : state.written)
      write(event);
  }



  template <int dim>
  void
  EventCatalogue<dim>::write(const SlipEvent &event)
  {
    memory.written.push_back(event);
    file << event.fault << ',' << event.start << ',' << event.peak_time << ','
         << event.end << ',' << event.peak_mean_slip_rate << ','
         << event.peak_slip_rate << ',' << event.mean_slip;
    for (const double coordinate : event.nucleation)
      file << ',' << coordinate;
    file.end_row();
  }



  template class EventCatalogue<2>;
  template class EventCatalogue<3>;
} // namespace StickSlip
