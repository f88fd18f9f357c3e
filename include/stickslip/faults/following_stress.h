// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_following_stress_h
#define stickslip_faults_following_stress_h

#include <stickslip/faults/fault_nodes.h>

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
    /** Nothing follows. */
    FollowingStress() = default;

    /** @p faults_that_follow: one entry a fault; @p faults: with the normal
     * stress of the start; @p initial_pressure: at each slave node, Pa. */
    FollowingStress(const std::vector<bool>   &faults_that_follow,
                    const FaultNodes<dim>     &faults,
                    const std::vector<double> &initial_pressure);

    /** Whether there is anything that follows. */
    bool
    is_needed() const;

    /** Set the normal stress that belongs to a contact pressure, Pa. Returns
     * the change at each slave node over the mean on its fault and over the
     * law's rate_scale(), if that has one: about that of ln V if the traction
     * stays as it is and mu is one. */
    std::vector<double>
    apply(FaultNodes<dim>           &faults,
          const std::vector<double> &contact_pressure) const;

    /** The number of nodes in contact that are under tension. */
    unsigned int
    n_in_tension(const FaultNodes<dim>     &faults,
                 const std::vector<double> &contact_pressure) const;

  private:
    std::vector<bool> follows;
    /** sigma_n(0) - p(0), Pa. */
    std::vector<double> difference;
  };
} // namespace StickSlip

#endif
