// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_cell_partition_h
#define stickslip_mesh_cell_partition_h

#include <stickslip/geometry/fault_topology.h>
#include <stickslip/mesh/body_mesh.h>

namespace StickSlip
{
  /**
   * The process that owns each active cell of each body: [body][active cell
   * index]. About as many cells for each of @p n_parts processes, with few
   * neighbours in different parts, and the cells that face each other across a
   * fault in the reference configuration in the same one where possible. Lines
   * of flat cells (cell_lines.h) are whole if no part then has more than 1.3
   * times the mean, or 1.5 times below 1,000 cells for each part. For
   * powers of two, parts of neighbouring numbers are neighbours in space. Parts
   * in excess of the number of cells own nothing. Where cells stand for finer
   * ones, @p n_finest are their numbers for each cell of each body.
   *
   * The result depends on the arguments alone, so that each process finds the
   * same without messages.
   */
  template <int dim>
  std::vector<std::vector<unsigned int>>
  partition_cells(const BodyMeshes<dim>                        &bodies,
                  const FaultTopology                          &topology,
                  const unsigned int                            n_parts,
                  const std::vector<std::vector<unsigned int>> &n_finest = {});

  /**
   * The owner of every vertex of a body's mesh, by vertex index of the
   * triangulation: the least owner of the active cells that have it as a
   * vertex; numbers::invalid_unsigned_int for vertices that no active cell
   * has. @p cell_owners by active cell index.
   */
  template <int dim>
  std::vector<unsigned int>
  vertex_owners(const BodyMesh<dim>             &body,
                const std::vector<unsigned int> &cell_owners);

  /**
   * Owners of the vertices of a coarser mesh of the body: the owners of the
   * vertices of the finer one at the same places, or near to them if the meshes
   * are not nested.
   */
  template <int dim>
  std::vector<unsigned int>
  inherited_vertex_owners(const BodyMesh<dim>             &coarse,
                          const BodyMesh<dim>             &fine,
                          const std::vector<unsigned int> &fine_owners);
} // namespace StickSlip

#endif
