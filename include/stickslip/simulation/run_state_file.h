// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_run_state_file_h
#define stickslip_simulation_run_state_file_h

#include <stickslip/mesh/mesh_level.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/run_state.h>

#include <string>

namespace StickSlip
{
  /**
   * Write the state of a run to a binary file, all of it or nothing. Nodal
   * vectors are written body after body in the order of the nodes of their
   * finest meshes @p level, so that they may be read on another number of
   * processes. The entries of the scene are kept with it, and a checksum. For
   * the same program on the same kind of machine. Throws InputError if the file
   * cannot be written. Collective.
   */
  template <int dim, int n_components = dim>
  void
  write_run_state(const std::string                 &file_name,
                  const RunState<dim, n_components> &state,
                  const MeshLevel<dim>              &level,
                  const SceneEntries                &entries = {});

  /**
   * The entries of the scene in such a file. Throws InputError if it is not of
   * this kind, of another version or damaged.
   */
  SceneEntries
  run_state_entries(const std::string &file_name);

  /**
   * Read it again. Throws InputError if the file is not of this kind, if it is
   * damaged or if it belongs to other meshes. Collective.
   */
  template <int dim, int n_components = dim>
  RunState<dim, n_components>
  read_run_state(const std::string &file_name, const MeshLevel<dim> &level);
} // namespace StickSlip

#endif
