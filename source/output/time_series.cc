// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/time_series.h>

#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::string
    titles(const std::vector<FaultSnapshot<dim>> &faults)
    {
      std::string result =
        "step,time,step_size,rate_state_iterations,tnnmg_iterations,"
        "multigrid_cycles";
      for (const FaultSnapshot<dim> &fault : faults)
        {
          const auto add = [&](const std::string &column) {
            result += ',' + fault.name + '.' + column;
          };
          for (const char *column : {"max_slip_rate",
                                     "mean_slip_rate",
                                     "min_slip_rate",
                                     "mean_slip",
                                     "mean_state",
                                     "mean_shear_traction"})
            add(column);
          if (fault.may_open() || !std::isnan(fault.largest_gap))
            add("largest_gap");
          if (fault.may_open())
            add("open_area");
        }
      return result;
    }
  } // namespace



  template <int dim>
  TimeSeries<dim>::TimeSeries(const std::string                     &file_name,
                              const std::vector<FaultSnapshot<dim>> &faults)
    : file(file_name)
    , n_faults(faults.size())
  {
    file << titles(faults);
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
         << step.multigrid_cycles;
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
    file.end_row();
  }



  template class TimeSeries<2>;
  template class TimeSeries<3>;
} // namespace StickSlip
