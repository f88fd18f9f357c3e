// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/following_stress.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  FollowingStress<dim>::FollowingStress(
    const std::vector<FaultParameters> &parameters,
    const FaultNodes<dim>              &faults,
    const std::vector<double>          &initial_pressure)
  {
    if (initial_pressure.empty())
      return;
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        follows.push_back(parameters[faults.fault(k)].normal_stress_follows);
        difference.push_back(faults.normal_stress()[k] - initial_pressure[k]);
      }
  }



  template <int dim>
  void
  FollowingStress<dim>::update(FaultNodes<dim>           &faults,
                               const std::vector<double> &contact_pressure)
  {
    if (follows.empty())
      return;
    AssertDimension(contact_pressure.size(), follows.size());
    std::vector<double> stress     = faults.normal_stress();
    unsigned int        in_tension = 0;
    for (unsigned int k = 0; k < stress.size(); ++k)
      if (follows[k])
        {
          const double sigma = contact_pressure[k] + difference[k];
          if (sigma < 0. && faults.in_contact(k) &&
              !faults.law(k).is_prescribed)
            ++in_tension;
          stress[k] = std::max(sigma, 0.);
        }
    faults.set_normal_stress(stress);
    largest_tension = std::max(largest_tension, in_tension);
  }



  template <int dim>
  unsigned int
  FollowingStress<dim>::largest_number_in_tension() const
  {
    return largest_tension;
  }



  template class FollowingStress<2>;
  template class FollowingStress<3>;
} // namespace StickSlip
