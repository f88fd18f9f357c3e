// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_slip_rate_series_h
#define stickslip_tests_slip_rate_series_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace StickSlip::Tests
{
  /** A slip rate over time. */
  struct SlipRateSeries
  {
    std::vector<double> time, slip_rate;

    /** Between the values, ln V is linear. */
    double
    at(const double t) const
    {
      const std::size_t k =
        std::lower_bound(time.begin(), time.end(), t) - time.begin();
      const double x = (t - time[k - 1]) / (time[k] - time[k - 1]);
      return std::exp((1. - x) * std::log(slip_rate[k - 1]) +
                      x * std::log(slip_rate[k]));
    }

    /** Times at which the slip rate rises over twice the loading rate, from
     * below half of it. */
    std::vector<double>
    events(const double loading_rate) const
    {
      std::vector<double> result;
      bool                armed = true;
      for (std::size_t k = 1; k < time.size(); ++k)
        if (armed && slip_rate[k] > 2. * loading_rate)
          {
            const double before = std::log(slip_rate[k - 1]),
                         after  = std::log(slip_rate[k]);
            result.push_back(time[k - 1] +
                             (time[k] - time[k - 1]) *
                               (std::log(2. * loading_rate) - before) /
                               (after - before));
            armed = false;
          }
        else if (slip_rate[k] < 0.5 * loading_rate)
          armed = true;
      return result;
    }

    double
    peak() const
    {
      return *std::max_element(slip_rate.begin(), slip_rate.end());
    }
  };
} // namespace StickSlip::Tests

#endif
