// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/following_stress.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  FollowingStress<dim>::FollowingStress(
    const std::vector<bool>        &faults_that_follow,
    const FaultNodes<dim>          &faults,
    const std::vector<double>      &offset,
    const std::vector<NodeOpening> &openings)
    : offset(offset)
  {
    if (openings.empty() &&
        std::find(faults_that_follow.begin(), faults_that_follow.end(), true) ==
          faults_that_follow.end())
      return;
    AssertDimension(offset.size(), faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      follows.push_back(faults_that_follow[faults.fault(k)] ||
                        (!openings.empty() && openings[k].may_open));
  }



  template <int dim>
  std::vector<double>
  FollowingStress<dim>::normal_stress(
    const std::vector<double> &before,
    const std::vector<double> &contact_pressure) const
  {
    AssertDimension(contact_pressure.size(), follows.size());
    std::vector<double> now = before;
    for (unsigned int k = 0; k < now.size(); ++k)
      if (follows[k])
        now[k] = std::max(contact_pressure[k] + offset[k], 0.);
    return now;
  }



  template <int dim>
  unsigned int
  FollowingStress<dim>::n_in_tension(
    const FaultNodes<dim>     &faults,
    const NodeLaws            &laws,
    const std::vector<double> &contact_pressure) const
  {
    unsigned int n = 0;
    for (unsigned int k = 0; k < follows.size(); ++k)
      if (follows[k] && contact_pressure[k] + offset[k] < 0. &&
          faults.in_contact(k) && !laws[k].is_prescribed)
        ++n;
    return n;
  }



  template <int dim>
  std::vector<double>
  relative_stress_change(const FaultNodes<dim>     &faults,
                         const NodeLaws            &laws,
                         const std::vector<double> &before,
                         const std::vector<double> &now)
  {
    const std::vector<double> over_mean = faults.over_mean(now);
    std::vector<double>       change(now.size());
    for (unsigned int k = 0; k < now.size(); ++k)
      if (now[k] != before[k] && faults.in_contact(k))
        {
          const double mean  = over_mean[k] > 0. ? now[k] / over_mean[k] :
                                                   std::max(now[k], before[k]);
          const double scale = laws[k].friction->rate_scale();
          change[k]          = (now[k] - before[k]) / mean;
          if (scale > 0.)
            change[k] /= scale;
        }
    return change;
  }



  template class FollowingStress<2>;
  template class FollowingStress<3>;
  template decltype(relative_stress_change<2>) relative_stress_change<2>;
  template decltype(relative_stress_change<3>) relative_stress_change<3>;
} // namespace StickSlip
