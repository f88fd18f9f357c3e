// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_contact_change_h
#define stickslip_simulation_contact_change_h

#include <stickslip/faults/background_stress.h>
#include <stickslip/faults/fault_nodes.h>
#include <stickslip/mortar/contact_parameters.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /** Distance, m, that a node of each fault may slide until the faults are
   * coupled anew: its fraction of the smallest face of any fault. */
  template <int dim>
  std::vector<double>
  sliding_distances(const JumpBasis<dim>    &basis,
                    const ContactParameters &parameters);

  /** True if a node has slid farther between two slips, m, than these
   * @p distances, one a fault, allow. */
  template <int dim>
  bool
  has_slid(const FaultNodes<dim>                 &faults,
           const std::vector<Tensor<1, dim - 1>> &slip,
           const std::vector<Tensor<1, dim - 1>> &since,
           const std::vector<double>             &distances);

  /** The slip of each node until one of them has slid by its distance if slip
   * rates stay as they are, m; empty where no fault bends. */
  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  expected_slip(const JumpBasis<dim>                  &basis,
                const FaultNodes<dim>                 &faults,
                const std::vector<Tensor<1, dim - 1>> &slip_rate,
                const std::vector<double>             &distances);

  /** The normal stress of the background stress at all slave nodes along their
   * normals, Pa; empty where there is none, or no fault bends. */
  template <int dim>
  std::vector<double>
  background_normal_stress(const BackgroundStress<dim> &background,
                           const JumpBasis<dim>        &basis);

  /** True if the sides of any node are apart. */
  template <int dim>
  bool
  is_any_open(const SystemState<dim> &state);

  /** Distance of the sides along the normal at each slave node after a
   * displacement, m, with the present contact mapping: the mean over the dual
   * function, which is not zero where sides bend that touch. Collective. */
  template <int dim, int n_components = dim>
  std::vector<double>
  side_distances(const ContactSpace<dim, n_components> &space,
                 const NodalVector                     &displacement);

  /** side_distances() of a state; empty where nothing is open or no fault
   * bends: gaps do not change with the mapping then. */
  template <int dim, int n_components = dim>
  std::vector<double>
  distances_of_gaps(const ContactSpace<dim, n_components> &space,
                    const SystemState<dim>                &state);

  /**
   * Carry a state over to a new contact mapping, that of @p space and
   * @p now. Where sides touch, slip rates belong to the nodes of the fault and
   * stay, along axes that may have turned; the velocity of the slave side
   * follows from them and from the new partners. Where they are apart,
   * velocities stay, and with them their energy. Nodes that come into contact
   * get the jump of the velocities as they are, and the gap of their nearest
   * neighbour. Sides that touch keep doing so; gaps of others change by as much
   * as their distances_of_gaps() from those with the mapping before.
   * Collective.
   */
  template <int dim, int n_components = dim>
  void
  change_contact(SystemState<dim>                      &state,
                 const ContactSpace<dim, n_components> &space,
                 const FaultNodes<dim>                 &before,
                 const FaultNodes<dim>                 &now,
                 const std::vector<double>             &distances_before = {});
} // namespace StickSlip

#endif
