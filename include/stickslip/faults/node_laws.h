// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_node_laws_h
#define stickslip_faults_node_laws_h

#include <stickslip/friction/friction_law.h>
#include <stickslip/friction/state_evolution.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The friction of a fault, or of nodes of it that have the same parameters.
   */
  struct FaultLaw
  {
    std::shared_ptr<const FrictionLaw> friction;
    /** Evolution of the state; null without a state. */
    std::shared_ptr<const StateLaw> state_law;
    /** Characteristic slip L, m: of the state, and the measure of an error of
     * the slip. */
    double characteristic_slip = 0;
    /** True if the state stays as it is where the sides do not touch, instead
     * of evolving as at rest. */
    bool is_frozen_open = false;
    /** True where the slip rate is known, so that friction has no say. */
    bool is_prescribed = false;
    /** Impedance of shear waves, Pa s/m: the harmonic mean of those of both
     * sides; infinity where both are rigid, zero where it is not needed. */
    double shear_impedance = 0;
    /** Radiation damping eta, Pa s/m: a traction eta V against the slip. */
    double radiation_damping = 0;
  };

  /**
   * The friction of all slave nodes, in the order of FaultNodes.
   */
  struct NodeLaws
  {
    /** Laws that occur. */
    std::vector<FaultLaw> laws;
    /** Position in laws of the law of each slave node. */
    std::vector<unsigned int> of_node;

    /** The law of the k-th slave node. */
    const FaultLaw &
    operator[](const unsigned int k) const
    {
      return laws[of_node[k]];
    }
  };
} // namespace StickSlip

#endif
