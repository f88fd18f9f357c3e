// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/following_stress.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  FollowingStress<dim>::FollowingStress(
    const std::vector<bool>   &faults_that_follow,
    const FaultNodes<dim>     &faults,
    const std::vector<double> &initial_pressure)
  {
    AssertDimension(initial_pressure.size(), faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        follows.push_back(faults_that_follow[faults.fault(k)]);
        difference.push_back(faults.normal_stress()[k] - initial_pressure[k]);
      }
  }



  template <int dim>
  bool
  FollowingStress<dim>::is_needed() const
  {
    return !follows.empty();
  }



  template <int dim>
  std::vector<double>
  FollowingStress<dim>::apply(FaultNodes<dim>           &faults,
                              const std::vector<double> &contact_pressure) const
  {
    AssertDimension(contact_pressure.size(), follows.size());
    const std::vector<double> before = faults.normal_stress();
    std::vector<double>       now    = before;
    for (unsigned int k = 0; k < now.size(); ++k)
      if (follows[k])
        now[k] = std::max(contact_pressure[k] + difference[k], 0.);
    faults.set_normal_stress(now);

    std::vector<double> change(now.size());
    for (unsigned int k = 0; k < now.size(); ++k)
      if (now[k] != before[k] && faults.in_contact(k))
        {
          const double mean  = faults.relative_normal_stress()[k] > 0. ?
                                 now[k] / faults.relative_normal_stress()[k] :
                                 std::max(now[k], before[k]);
          const double scale = faults.law(k).friction->rate_scale();
          change[k]          = (now[k] - before[k]) / mean;
          if (scale > 0.)
            change[k] /= scale;
        }
    return change;
  }



  template <int dim>
  unsigned int
  FollowingStress<dim>::n_in_tension(
    const FaultNodes<dim>     &faults,
    const std::vector<double> &contact_pressure) const
  {
    unsigned int n = 0;
    for (unsigned int k = 0; k < follows.size(); ++k)
      if (follows[k] && contact_pressure[k] + difference[k] < 0. &&
          faults.in_contact(k) && !faults.law(k).is_prescribed)
        ++n;
    return n;
  }



  template class FollowingStress<2>;
  template class FollowingStress<3>;
} // namespace StickSlip
