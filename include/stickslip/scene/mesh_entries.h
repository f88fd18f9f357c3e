// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_mesh_entries_h
#define stickslip_scene_mesh_entries_h

#include <stickslip/geometry/fault_cutting.h>

#include <array>
#include <string>
#include <vector>

namespace StickSlip
{
  /** Entries of a parameter file for bodies that are in mesh files. */
  struct MeshEntries
  {
    struct OfFault
    {
      /** Group of its faces; empty: named like the fault. */
      std::string group;

      /** Bodies or their sides, see parse_between(); empty: found in the mesh.
       */
      std::string between;

      /** See Fault::may_be_apart. */
      bool may_be_apart = false;

      /** Direction of the first component of slip, see Fault::strike. */
      std::array<double, 3> strike = {{0., 0., 0.}};
    };

    /** Names of files, separated by commas; empty: bodies are bricks. */
    std::string files;

    /** Names of the files of each coarser mesh, finest first, separated by
     * commas; several of one mesh are joined by plus signs. */
    std::string coarser_files;

    /** Unit of length in the files, m. */
    double length_unit = 1.;

    /** Entries of all faults in their order. */
    std::vector<OfFault> faults;
  };

  /**
   * Take apart the two sides of a fault, 'footwall, hanging_wall' or, as groups
   * at the boundaries of bodies, 'lower top, left bottom + right bottom'.
   * Throws InputError saying what the text must be.
   */
  std::array<std::vector<MeshFault::Side>, 2>
  parse_between(const std::string &text);

  /** The meshes of the bodies, cut open at the faults. Throws InputError. */
  template <int dim>
  CutMesh<dim>
  read_meshes(const MeshEntries              &entries,
              const std::vector<std::string> &body_names,
              const std::vector<std::string> &fault_names);
} // namespace StickSlip

#endif
