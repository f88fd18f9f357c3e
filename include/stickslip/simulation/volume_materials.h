// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_volume_materials_h
#define stickslip_simulation_volume_materials_h

#include <stickslip/mesh/mesh_level.h>
#include <stickslip/output/volume_writer.h>
#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /** The materials of all bodies for stresses in the volume output, with what
   * varies in any of them as fields to look at. @p level: the finest one, which
   * must outlive what is returned. */
  template <int dim>
  std::vector<VolumeMaterial<dim>>
  volume_materials(const SceneParameters<dim> &scene,
                   const MeshLevel<dim>       &level);
} // namespace StickSlip

#endif
