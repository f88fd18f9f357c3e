// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_divided_meshes_h
#define stickslip_mesh_divided_meshes_h

#include <stickslip/mesh/coarsening.h>

#include <cstddef>
#include <vector>

namespace StickSlip
{
  /** The meshes whose cells are divided between the processes: the finest ones,
   * or those of units if that leaves @p least_cells in all. */
  template <int dim>
  struct DividedMeshes
  {
    DividedMeshes(const std::vector<CoarseBody<dim>> &coarse_bodies,
                  const FaultTopology                &topology,
                  const std::size_t                   least_cells);

    BodyMeshes<dim> meshes;

    /** Steps of refinement to the finest mesh of each body, and how many of
     * them are beyond the mesh above. */
    std::vector<RefinementSteps> steps;
    std::vector<unsigned int>    depths;

    /** Number of finest cells that each cell stands for. */
    std::vector<std::vector<unsigned int>> n_finest;
  };
} // namespace StickSlip

#endif
