// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/magnitude.h>
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



    template <int dim>
    std::vector<std::vector<double>>
    rigidities_of(const std::vector<FaultLayout<dim>> &shapes)
    {
      std::vector<std::vector<double>> result;
      for (const FaultLayout<dim> &shape : shapes)
        result.push_back(shape.rigidity);
      return result;
    }
  } // namespace



  template <int dim>
  EventCatalogue<dim>::EventCatalogue(
    const std::string                   &file_name,
    const std::vector<std::string>      &fault_names,
    const std::vector<FaultLayout<dim>> &shapes,
    const double                         start_slip_rate,
    const double                         end_fraction)
    : Catalogue<dim, EventMemory>(file_name, fault_names.size())
    , positions(shapes)
    , rigidities(rigidities_of(shapes))
    , start_slip_rate(start_slip_rate)
    , end_slip_rate(end_fraction * start_slip_rate)
  {
    Assert(start_slip_rate > 0 && end_fraction > 0 && end_fraction <= 1,
           ExcMessage("Events need a threshold."));
    AssertDimension(fault_names.size(), shapes.size());
    for (unsigned int i = 0; i < fault_names.size(); ++i)
      this->memory.faults[i].name = fault_names[i];
    this->write_header();
  }



  template <int dim>
  TableColumns
  EventCatalogue<dim>::columns() const
  {
    const std::string area   = (dim == 2) ? "m" : "m^2";
    TableColumns      result = {
           {"fault", "", "name of the fault"},
           {"start",
            "s",
            "time at which the mean slip rate rises above Event start slip rate, "
                 "interpolated between steps"},
           {"peak_time", "s", "time of the largest mean slip rate"},
           {"end",
            "s",
            "time at which the mean slip rate falls below Event end fraction of "
                 "that, interpolated; nan if it had not by the end of the run"},
           {"peak_mean_slip_rate",
            "m/s",
            "largest mean over the area of contact of the magnitude of the slip "
                 "rate"},
           {"peak_slip_rate", "m/s", "largest slip rate of any node"},
           {"mean_slip",
            "m",
            "growth from start to end of the mean over the area of contact of the "
                 "first component of the slip"}};
    for (const TableColumn &column : positions.columns(
           "nucleation",
           "the fastest node when the largest slip rate last rose above the "
           "threshold before the event"))
      result.push_back(column);
    result.push_back({"moment",
                      dim == 2 ? "N" : "N m",
                      std::string("integral over the area of contact of the "
                                  "rigidity times the slip from start to end, "
                                  "in magnitude") +
                        (dim == 2 ? "; for 1 m of the third dimension" : "")});
    result.push_back(
      {"peak_moment_rate",
       dim == 2 ? "N/s" : "N m/s",
       "largest integral over the area of contact of the rigidity times the "
       "magnitude of the slip rate, after a step of the event"});
    result.push_back({"stress_drop",
                      "Pa",
                      "mean fall of the shear traction from start to end, "
                      "weighted by the slip"});
    result.push_back(
      {"ruptured_area",
       area,
       "area of the nodes that were faster than Event start slip "
       "rate after a step of the event"});
    if (dim == 3)
      result.push_back(
        {"magnitude", "", "moment magnitude, (log10(moment) - 9.1) / 1.5"});
    return result;
  }



  template <int dim>
  void
  EventCatalogue<dim>::take_in(const unsigned int        fault,
                               const double              time,
                               const FaultSnapshot<dim> &snapshot)
  {
    EventMemory           &record = this->memory.faults[fault];
    const FaultStatistics &past   = record.statistics;
    const FaultStatistics  now    = fault_statistics(snapshot);
    const FaultMotion      motion(snapshot);

    // The value a crossing of the given level has, by the part of the step.
    const auto interpolate =
      [&](const double level, const double before, const double after) {
        if (!record.has_past)
          return after;
        const double part =
          crossing(past.mean_slip_rate, now.mean_slip_rate, level);
        return before + part * (after - before);
      };
    const auto motion_at = [&](const double level) {
      return record.has_past ? FaultMotion(record.motion,
                                           motion,
                                           crossing(past.mean_slip_rate,
                                                    now.mean_slip_rate,
                                                    level)) :
                               motion;
    };

    const bool was_fast =
      record.has_past && past.max_slip_rate > start_slip_rate;
    if (now.max_slip_rate > start_slip_rate && !was_fast)
      record.nucleation = positions.at(fault, now.fastest_node);

    if (!record.is_open && now.mean_slip_rate > start_slip_rate)
      {
        record.is_open     = true;
        record.entry       = SlipEvent();
        record.entry.fault = record.name;
        record.entry.start = interpolate(start_slip_rate, record.time, time);
        record.start_slip =
          interpolate(start_slip_rate, past.mean_slip, now.mean_slip);
        record.entry.nucleation = record.nucleation;
        record.start_motion     = motion_at(start_slip_rate);
        record.has_ruptured.assign(snapshot.points.size(), 0);
      }

    if (record.is_open)
      {
        SlipEvent &event = record.entry;
        for (unsigned int k = 0; k < record.has_ruptured.size(); ++k)
          if (magnitude(snapshot.slip_rate[k]) > start_slip_rate)
            record.has_ruptured[k] = 1;
        const bool ends = now.mean_slip_rate < end_slip_rate;
        event.source    = EventSource(record.start_motion,
                                   ends ? motion_at(end_slip_rate) : motion,
                                   snapshot.weights,
                                   rigidities[fault],
                                   record.has_ruptured);
        event.mean_slip = now.mean_slip - record.start_slip;
        event.peak_slip_rate =
          std::max(event.peak_slip_rate, now.max_slip_rate);
        // Not a number at first.
        const double rate = moment_rate(snapshot, rigidities[fault]);
        if (!(rate <= event.peak_moment_rate))
          event.peak_moment_rate = rate;
        if (now.mean_slip_rate > event.peak_mean_slip_rate)
          {
            event.peak_mean_slip_rate = now.mean_slip_rate;
            event.peak_time           = time;
          }
        if (ends)
          {
            event.end = interpolate(end_slip_rate, record.time, time);
            event.mean_slip =
              interpolate(end_slip_rate, past.mean_slip, now.mean_slip) -
              record.start_slip;
            this->end(record);
          }
      }

    record.has_past   = true;
    record.time       = time;
    record.statistics = now;
    record.motion     = motion;
  }



  template <int dim>
  void
  EventCatalogue<dim>::fill_row(TableFile &row, const SlipEvent &event) const
  {
    row << event.fault << ',' << event.start << ',' << event.peak_time << ','
        << event.end << ',' << event.peak_mean_slip_rate << ','
        << event.peak_slip_rate << ',' << event.mean_slip;
    for (const double coordinate : event.nucleation)
      row << ',' << coordinate;
    row << ',' << event.source.moment << ',' << event.peak_moment_rate << ','
        << event.source.stress_drop << ',' << event.source.ruptured_area;
    if (dim == 3)
      row << ',' << event.source.magnitude();
  }



  template class EventCatalogue<2>;
  template class EventCatalogue<3>;
} // namespace StickSlip
