// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_following_stress_h
#define stickslip_faults_following_stress_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/faults/node_opening.h>

#include <vector>

namespace StickSlip
{
  /**
   * The normal stress of faults on which it follows the contact pressure p,
   *
   *   sigma_n(t) = max(0, p(t) + offset),   offset = sigma_n(0) - p(0),
   *
   * at each slave node, and at nodes that may open. All others keep what they
   * have.
   */
  template <int dim>
  class FollowingStress
  {
  public:
    /** Nothing follows. */
    FollowingStress() = default;

    /** @p faults_that_follow: one entry a fault; @p offset: at each slave node,
     * Pa, of no meaning if no fault follows; @p openings: of each slave node,
     * or empty if none may open. */
    FollowingStress(const std::vector<bool>        &faults_that_follow,
                    const FaultNodes<dim>          &faults,
                    const std::vector<double>      &offset,
                    const std::vector<NodeOpening> &openings = {});

    /** True if the stress of any fault follows. */
    bool
    is_needed() const
    {
      return !follows.empty();
    }

    /** The normal stress that belongs to a contact pressure, Pa; @p before:
     * one that is kept where nothing follows. */
    std::vector<double>
    normal_stress(const std::vector<double> &before,
                  const std::vector<double> &contact_pressure) const;

    /** The number of nodes in contact that are under tension. */
    unsigned int
    n_in_tension(const FaultNodes<dim>     &faults,
                 const NodeLaws            &laws,
                 const std::vector<double> &contact_pressure) const;

  private:
    std::vector<bool>   follows;
    std::vector<double> offset;
  };

  /**
   * The change from one normal stress to the next at each slave node over the
   * mean on its fault and over the law's rate_scale(), if that has one: about
   * that of ln V if the traction stays as it is and mu is one.
   */
  template <int dim>
  std::vector<double>
  relative_stress_change(const FaultNodes<dim>     &faults,
                         const NodeLaws            &laws,
                         const std::vector<double> &before,
                         const std::vector<double> &now);
} // namespace StickSlip

#endif
