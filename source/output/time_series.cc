// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/time_series.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  TableColumns
  TimeSeries<dim>::columns(const std::vector<FaultSnapshot<dim>> &faults)
  {
    TableColumns result = {
      {"step", "", "number of accepted steps so far"},
      {"time", "s", "at the end of the step"},
      {"step_size", "s", "length of the step"},
      {"rate_state_iterations",
       "",
       "alternations of rate problem and state in the step"},
      {"tnnmg_iterations", "", "iterations of all rate problems of the step"},
      {"multigrid_cycles", "", "multigrid cycles of these"},
      {"fault_error", "", "estimated error of the step on the faults"},
      {"body_error", "", "estimated error of the velocity of the bodies"}};
    const std::string mean = "mean over the area of contact of ";
    for (const FaultSnapshot<dim> &fault : faults)
      {
        const auto add = [&](const std::string &title,
                             const std::string &unit,
                             const std::string &meaning) {
          result.push_back({fault.name + '.' + title, unit, meaning});
        };
        add("max_slip_rate",
            "m/s",
            "magnitude of the slip rate at the fastest node");
        add("mean_slip_rate", "m/s", mean + "the magnitude of the slip rate");
        add("min_slip_rate",
            "m/s",
            "magnitude of the slip rate at the slowest node");
        add("mean_slip", "m", mean + "the first component of the slip");
        add("mean_state", "s", mean + "the state theta");
        add("mean_shear_traction",
            "Pa",
            mean + "the first component of the shear traction");
        if (fault.may_open())
          add("largest_gap", "m", "largest gap of any node");
        else if (!std::isnan(fault.largest_gap))
          add("largest_gap", "m", "largest gap between the sides so far");
        if (fault.may_open())
          add("open_area", dim == 2 ? "m" : "m^2", "area of the open nodes");
      }
    return result;
  }



  template <int dim>
  TimeSeries<dim>::TimeSeries(const std::string                     &file_name,
                              const std::vector<FaultSnapshot<dim>> &faults)
    : file(file_name)
    , n_faults(faults.size())
  {
    file << header_of(columns(faults));
    file.end_row();
  }



  template <int dim>
  TimeSeries<dim>::TimeSeries(const std::string                     &file_name,
                              const std::vector<FaultSnapshot<dim>> &faults,
                              const FileState                       &earlier)
    : file(file_name, earlier)
    , n_faults(faults.size())
  {}



  template <int dim>
  void
  TimeSeries<dim>::add(const StepRecord                      &step,
                       const std::vector<FaultSnapshot<dim>> &faults)
  {
    AssertDimension(faults.size(), n_faults);

    file << step.step << ',' << step.time << ',' << step.step_size << ','
         << step.rate_state_iterations << ',' << step.tnnmg_iterations << ','
         << step.multigrid_cycles << ',' << step.fault_error << ','
         << step.body_error;
    for (const FaultSnapshot<dim> &fault : faults)
      {
        const FaultStatistics statistics = fault_statistics(fault);
        file << ',' << statistics.max_slip_rate << ','
             << statistics.mean_slip_rate << ',' << statistics.min_slip_rate
             << ',' << statistics.mean_slip << ',' << statistics.mean_state
             << ',' << statistics.mean_shear_traction;
        if (fault.may_open())
          {
            const OpeningStatistics opening = opening_statistics(fault);
            file << ',' << opening.largest_gap << ',' << opening.open_area;
          }
        else if (!std::isnan(fault.largest_gap))
          file << ',' << fault.largest_gap;
      }
    file.end_waiting_row();
  }



  template class TimeSeries<2>;
  template class TimeSeries<3>;
} // namespace StickSlip
