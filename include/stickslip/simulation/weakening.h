// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_weakening_h
#define stickslip_simulation_weakening_h

#include <stickslip/simulation/simulation.h>

#include <cmath>
#include <limits>
#include <vector>

namespace StickSlip
{
  /** Abilities of the part of a fault with b > a. */
  struct Weakening
  {
    /** One entry for each slave node of all faults. */
    std::vector<bool> nodes;

    /** Mean over its area, Pa/m, and what the bodies have against its slip,
     * Pa/m. */
    double critical_stiffness = 0., stiffness = 0.;

    /** The least ones of all nodes, m. */
    double nucleation_length = std::numeric_limits<double>::infinity(),
           process_zone      = std::numeric_limits<double>::infinity();

    bool
    is_there() const
    {
      return std::isfinite(process_zone);
    }

    double
    stiffness_ratio() const
    {
      return stiffness / critical_stiffness;
    }
  };



  /** Abilities of the part of a fault with b > a at the start of a run, in
   * the state after Simulation::set_up(). Changes the combination of matrices
   * of the problem. Collective. */
  template <int dim, int n_components>
  Weakening
  find_weakening(const SceneParameters<dim>    &scene,
                 Simulation<dim, n_components> &simulation,
                 const unsigned int             f);
} // namespace StickSlip

#endif
