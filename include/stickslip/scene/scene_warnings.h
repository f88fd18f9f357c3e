// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_warnings_h
#define stickslip_scene_scene_warnings_h

#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Sentences on what can be run, and is hardly meant: regions
   * that hit no node, tables that say nothing of their fault, sides that are
   * held near to a fault in a half-space, two velocities for one corner, cells
   * that multigrid does not like, nearly incompressible bodies with full
   * volumetric strain, and more steps or output than anyone waits for.
   */
  template <int dim>
  std::vector<std::string>
  scene_warnings(const SceneParameters<dim> &scene, const MeshEstimate &meshes);

  /**
   * The fewest steps, records of the faults and sets of VTU files that the
   * limits of a scene allow.
   */
  struct FewestOutputs
  {
    double steps, fault_records, volume_sets;

    FewestOutputs(const TimeParameters &time, const OutputParameters &output);
  };
} // namespace StickSlip

#endif
