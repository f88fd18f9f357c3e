// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/opening_catalogue.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Diagonal of the box around the nodes of a fault, m. */
    template <int dim>
    double
    extent(const FaultLayout<dim> &shape)
    {
      const BoundingBox<dim> box(shape.surface.points);
      return box.get_boundary_points().first.distance(
        box.get_boundary_points().second);
    }
  } // namespace



  template <int dim>
  OpeningCatalogue<dim>::OpeningCatalogue(
    const std::string                   &file_name,
    const std::vector<FaultLayout<dim>> &shapes,
    const double                         threshold)
    : Catalogue<dim, OpeningMemory>(file_name, shapes.size())
    , positions(shapes)
  {
    this->write_header();
    for (const FaultLayout<dim> &shape : shapes)
      thresholds.push_back(threshold > 0 ? threshold :
                                           default_threshold * extent(shape));
  }



  template <int dim>
  TableColumns
  OpeningCatalogue<dim>::columns() const
  {
    TableColumns result = {
      {"fault", "", "name of the fault"},
      {"opens",
       "s",
       "time at which the largest gap rises above Opening threshold, "
       "interpolated between steps"},
      {"peak_time", "s", "time of the largest gap"},
      {"closes",
       "s",
       "time at which the largest gap falls below half of that, interpolated; "
       "nan if it had not by the end of the run"},
      {"largest_gap", "m", "largest gap of any node"},
      {"largest_open_area",
       dim == 2 ? "m" : "m^2",
       "largest area of open nodes after a step of the opening"}};
    const auto add = [&](const std::string &name, const std::string &what) {
      for (const TableColumn &column : positions.columns(name, what))
        result.push_back(column);
    };
    add("begins", "the node with the largest gap when the opening begins");
    add("widest", "the node with the largest gap of all");
    return result;
  }



  template <int dim>
  void
  OpeningCatalogue<dim>::take_in(const unsigned int        number,
                                 const double              time,
                                 const FaultSnapshot<dim> &fault)
  {
    if (!fault.may_open())
      return;
    const OpeningStatistics now   = opening_statistics(fault);
    const double            opens = thresholds[number], closes = opens / 2;
    OpeningMemory          &record  = this->memory.faults[number];
    Opening                &opening = record.entry;

    // The time at which the largest gap reached a level during the step.
    const auto time_of = [&](const double level) {
      const double change = now.largest_gap - record.largest_gap;
      const double part   = (level - record.largest_gap) / change;
      return record.time + std::clamp(part, 0., 1.) * (time - record.time);
    };

    if (!record.is_open && now.largest_gap > opens)
      {
        record.is_open    = true;
        opening           = Opening();
        opening.fault     = fault.name;
        opening.opens     = record.has_past ? time_of(opens) : time;
        opening.begins_at = positions.at(number, now.widest_node);
      }

    if (record.is_open)
      {
        opening.largest_open_area =
          std::max(opening.largest_open_area, now.open_area);
        if (now.largest_gap > opening.largest_gap)
          {
            opening.largest_gap = now.largest_gap;
            opening.peak_time   = time;
            opening.widest_at   = positions.at(number, now.widest_node);
          }
        if (now.largest_gap < closes)
          {
            opening.closes = time_of(closes);
            this->end(record);
          }
      }

    record.has_past    = true;
    record.time        = time;
    record.largest_gap = now.largest_gap;
  }



  template <int dim>
  void
  OpeningCatalogue<dim>::fill_row(TableFile &row, const Opening &opening) const
  {
    row << opening.fault << ',' << opening.opens << ',' << opening.peak_time
        << ',' << opening.closes << ',' << opening.largest_gap << ','
        << opening.largest_open_area;
    for (const auto *position : {&opening.begins_at, &opening.widest_at})
      for (const double coordinate : *position)
        row << ',' << coordinate;
  }



  template class OpeningCatalogue<2>;
  template class OpeningCatalogue<3>;
} // namespace StickSlip
