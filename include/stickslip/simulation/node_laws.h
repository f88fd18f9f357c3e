// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_node_laws_h
#define stickslip_simulation_node_laws_h

#include <stickslip/faults/node_laws.h>
#include <stickslip/faults/prescribed_slip.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * The friction laws of all slave nodes, fault after fault. Nodes of a fault
   * with the same parameters share one. With the radiation damping of plane
   * shear waves into both bodies (Rice 1993), as they are at the node, if the
   * scene is quasi-dynamic.
   */
  template <int dim>
  NodeLaws
  make_node_laws(const SceneParameters<dim> &scene,
                 const JumpBasis<dim>       &basis);

  /**
   * The slip rates that are known, one entry a fault, see SpatialProblem: empty
   * for faults without welded parts and prescribed slip rates. The scene must
   * live longer.
   */
  template <int dim>
  std::vector<SlipRates<dim>>
  make_slip_rates(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
