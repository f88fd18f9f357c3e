// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/output/fault_statistics.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  FaultStatistics
  fault_statistics(const FaultSnapshot<dim> &fault)
  {
    const unsigned int n_nodes = fault.points.size();
    AssertDimension(fault.weights.size(), n_nodes);
    AssertDimension(fault.slip.size(), n_nodes);
    AssertDimension(fault.slip_rate.size(), n_nodes);
    AssertDimension(fault.shear_traction.size(), n_nodes);
    AssertDimension(fault.state.size(), n_nodes);

    FaultStatistics statistics;
    double          total_weight = 0;
    double          slip_rate = 0, slip = 0, state = 0, shear_traction = 0;
    for (unsigned int p = 0; p < n_nodes; ++p)
      {
        const double weight = fault.weights[p];
        if (!(weight > 0))
          continue;
        // Open sides pass each other without slipping.
        const bool   is_open  = fault.may_open() && fault.gap[p] > 0;
        const double rate     = is_open ? 0 : magnitude(fault.slip_rate[p]);
        const bool   is_first = (total_weight == 0);

        if (is_first || rate > statistics.max_slip_rate)
          {
            statistics.max_slip_rate = rate;
            statistics.fastest_node  = p;
          }
        statistics.min_slip_rate =
          is_first ? rate : std::min(statistics.min_slip_rate, rate);

        total_weight += weight;
        slip_rate += weight * rate;
        slip += weight * fault.slip[p][0];
        state += weight * fault.state[p];
        shear_traction += weight * fault.shear_traction[p][0];
      }

    if (total_weight > 0)
      {
        statistics.mean_slip_rate      = slip_rate / total_weight;
        statistics.mean_slip           = slip / total_weight;
        statistics.mean_state          = state / total_weight;
        statistics.mean_shear_traction = shear_traction / total_weight;
      }
    return statistics;
  }



  template <int dim>
  OpeningStatistics
  opening_statistics(const FaultSnapshot<dim> &fault)
  {
    AssertDimension(fault.gap.size(), fault.points.size());
    OpeningStatistics statistics;
    for (unsigned int p = 0; p < fault.gap.size(); ++p)
      if (fault.weights[p] > 0 && fault.gap[p] > 0)
        {
          statistics.open_area += fault.weights[p];
          if (fault.gap[p] > statistics.largest_gap)
            {
              statistics.largest_gap = fault.gap[p];
              statistics.widest_node = p;
            }
        }
    return statistics;
  }



  template decltype(fault_statistics<2>)   fault_statistics<2>;
  template decltype(fault_statistics<3>)   fault_statistics<3>;
  template decltype(opening_statistics<2>) opening_statistics<2>;
  template decltype(opening_statistics<3>) opening_statistics<3>;
} // namespace StickSlip
