// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_kept_tractions_h
#define stickslip_simulation_kept_tractions_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/lumped_mass.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

#include <vector>

namespace StickSlip
{
  /**
   * Tractions on faults while the contact mapping is built anew. A slave node
   * has other partners then, on which the same traction is another force: the
   * bodies, which have not moved, would be out of balance, and slip rates jump
   * by what the next step makes of it. A PartnerForce makes up for that.
   *
   * A mapping is that of the place in the middle of its interval. With D, what
   * the forces of the same tractions change by from one mapping to the next,
   * partners that go on are those with -D/2 in place of the mapping at the end
   * of the interval, if intervals are alike, and with D/2 at its start.
   */
  template <int dim, int n_components = dim>
  class KeptTractions
  {
  public:
    /** Tractions of @p state with the contact mapping of @p problem and @p
     * faults; both must live longer. @p lumped_mass: the mass of the time
     * steps, null where it is that of the problem. Collective. */
    KeptTractions(SpatialProblem<dim, n_components>   &problem,
                  const FaultNodes<dim>               &faults,
                  const NodeLaws                      &laws,
                  const SystemState<dim>              &state,
                  const LumpedMass<dim, n_components> *lumped_mass);

    /** The force from the time of @p state on, which has been carried over to
     * the mapping that there is now. Nodes that were off contact begin without
     * a traction. @p part: the way from the middle of the new interval to its
     * end, over that from the middle of the last one; @p rate: the inverse of
     * the length of the new interval, 1/s. Collective. */
    PartnerForce
    force(const SystemState<dim>              &state,
          const LumpedMass<dim, n_components> *lumped_mass,
          const double                         part,
          const double                         rate) const;

  private:
    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;

    /** The traction at each owned slave node in contact, slave relative to
     * master along the axes of the node, and zero elsewhere, Pa. */
    std::vector<Tensor<1, n_components>> tractions;

    /** Velocity and acceleration with the mapping before, m/s, m/s^2. */
    NodalVector velocity, acceleration;

    /** Forces on the nodes, N: of the tractions, and the PartnerForce that
     * there was, empty if there was none. */
    NodalVector of_tractions, of_partners;
  };
} // namespace StickSlip

#endif
