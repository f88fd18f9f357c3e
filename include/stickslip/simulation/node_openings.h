// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_node_openings_h
#define stickslip_simulation_node_openings_h

#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/unilateral_contact.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /** Freedom of each slave node along the normal; empty where no fault of the
   * scene may open. @p space as it is without displacement. Throws InputError
   * where a field has no value. Collective. */
  template <int dim, int n_components = dim>
  std::vector<NodeOpening>
  make_node_openings(const SceneParameters<dim>            &scene,
                     const ContactSpace<dim, n_components> &space);

  /** The parts of the faults that may open, one entry a fault, none at all
   * where nothing may. The scene must outlive them. */
  template <int dim>
  std::vector<OpeningParts<dim>>
  make_opening_parts(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
