// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_space_summary_h
#define stickslip_simulation_space_summary_h

#include <stickslip/output/run_summary.h>
#include <stickslip/problem/spatial_problem.h>

namespace StickSlip
{
  /**
   * Vertices, cells, and the smallest and largest cell diameter of the finest
   * mesh of each body and of all, and the number of levels.
   */
  template <int dim>
  void
  summarise_meshes(RunSummary                     &summary,
                   const MeshHierarchy<dim>       &meshes,
                   const std::vector<std::string> &body_names);

  /**
   * Unknowns, and the nodes, slave side and contact area of each fault.
   */
  template <int dim>
  void
  summarise_problem(RunSummary                     &summary,
                    const SpatialProblem<dim>      &problem,
                    const std::vector<std::string> &body_names,
                    const std::vector<std::string> &fault_names);
} // namespace StickSlip

#endif
