// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_coarser_mesh_files_h
#define stickslip_scene_coarser_mesh_files_h

#include <stickslip/scene/mesh_entries.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /** The coarser meshes of the same bodies, finest first, with the same
   * indicators of sides as @p mesh. Throws InputError, see match_to_finer(). */
  template <int dim>
  std::vector<std::shared_ptr<const CutMesh<dim>>>
  read_coarser_meshes(const MeshEntries              &entries,
                      const std::vector<std::string> &body_names,
                      const std::vector<std::string> &fault_names,
                      const CutMesh<dim>             &mesh);
} // namespace StickSlip

#endif
