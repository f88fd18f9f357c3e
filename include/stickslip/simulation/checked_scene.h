// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_checked_scene_h
#define stickslip_simulation_checked_scene_h

#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /** The scene itself, if it runs on that many processes; throws InputError if
   * not. */
  template <int dim>
  const SceneParameters<dim> &
  checked_scene(const SceneParameters<dim> &scene,
                const MPI_Comm             &communicator);

  /** The materials of the bodies of a scene. Throws InputError if they make no
   * sense on the finest meshes. Collective. */
  template <int dim>
  std::vector<MaterialFields>
  checked_materials(const SceneParameters<dim> &scene,
                    const MeshHierarchy<dim>   &meshes,
                    const MPI_Comm             &communicator);
} // namespace StickSlip

#endif
