// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_fault_cutting_h
#define stickslip_geometry_fault_cutting_h

#include <stickslip/geometry/body_cells.h>
#include <stickslip/geometry/fault_topology.h>
#include <stickslip/geometry/grouped_cells.h>
#include <stickslip/geometry/mesh_fault.h>

#include <set>
#include <vector>

namespace StickSlip
{
  /** The bodies of mesh files, open at their faults. */
  template <int dim>
  struct CutMesh
  {
    /** A place where a fault ends inside a body: both sides have the same
     * vertex there. */
    struct Tip
    {
      unsigned int fault;
      Point<dim>   position;
    };

    /** A place where more than two parts of bodies meet that can slip. */
    struct Junction
    {
      unsigned int n_parts;
      Point<dim>   position;

      /** Faults with a face at the junction. */
      std::set<unsigned int> faults;
    };

    std::vector<BodyCells<dim>> bodies;
    FaultTopology               topology;
    std::vector<Tip>            tips;
    std::vector<Junction>       junctions;

    /** Number of faces in the groups of faults that cannot slip, since all
     * their vertices are tips. They are no part of the faults. */
    unsigned int n_closed_faces = 0;
  };

  /**
   * Cut meshes open along faults: bodies are what their groups of cells say,
   * vertices are doubled where the cells at them are not joined otherwise.
   *
   * Throws InputError, always naming the group, if
   * - a boundary face has no named group or is in two,
   * - faces of a group are not faces of cells,
   * - faces of a fault do not have a cell on both sides, or those of a side
   *   have,
   * - bodies are joined where no fault is, or touch there with doubled nodes,
   * - there is no such group or body,
   * - or as orient_fault(), check_sides_touch() and FaultTopology do.
   */
  template <int dim>
  CutMesh<dim>
  cut_at_faults(GroupedCells<dim> mesh, const std::vector<MeshFault> &faults);
} // namespace StickSlip

#endif
