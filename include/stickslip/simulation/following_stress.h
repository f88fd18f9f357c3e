// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_following_stress_h
#define stickslip_simulation_following_stress_h

#include <stickslip/simulation/scene_parameters.h>
#include <stickslip/time/fault_nodes.h>

#include <vector>

namespace StickSlip
{
  /**
   * The normal stress of faults on which it follows the contact pressure p,
   *
   *   sigma_n(t) = max(0, sigma_n(0) + p(t) - p(0)),
   *
   * at each slave node. All others keep what they have.
   */
  template <int dim>
  class FollowingStress
  {
  public:
    /** @p initial_pressure: at each slave node, Pa, or empty where nothing
     * follows. */
    FollowingStress(const std::vector<FaultParameters> &parameters,
                    const FaultNodes<dim>              &faults,
                    const std::vector<double>          &initial_pressure);

    /** Set the normal stress that belongs to a contact pressure, Pa. */
    void
    update(FaultNodes<dim>           &faults,
           const std::vector<double> &contact_pressure);

    /** The largest number of nodes in contact that were under tension at the
     * same time. */
    unsigned int
    largest_number_in_tension() const;

  private:
    std::vector<bool> follows;
    /** sigma_n(0) - p(0), Pa. */
    std::vector<double> difference;
    unsigned int        largest_tension = 0;
  };
} // namespace StickSlip

#endif
