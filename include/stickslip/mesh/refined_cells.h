// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_refined_cells_h
#define stickslip_mesh_refined_cells_h

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <set>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** The cells of a mesh that have children: its coarse cells and these are
   * all that there is to know of how it is refined. */
  template <int dim>
  std::set<CellId>
  refined_cells(const Triangulation<dim> &mesh);

  /** Refine the flagged cells of a mesh, and what has to be refined for them:
   * neighbours differ by one refinement at most, and where sides are joined,
   * cells across the joint do not differ, so that a node on one side has an
   * image on the other. */
  template <int dim>
  void
  refine_flagged(Triangulation<dim> &mesh);

  /** Refine the cells of a list and what has to be refined for them, since
   * neighbours differ by one refinement at most. Cells that are not there are
   * none of the list. */
  template <int dim>
  void
  refine_listed(const std::set<CellId> &list, Triangulation<dim> &mesh);

  /** A table of the refined cells of all bodies, a line for each: the name of
   * the body and the cell as deal.II writes it. */
  std::string
  table_of_refined_cells(const std::vector<std::string>      &body_names,
                         const std::vector<std::set<CellId>> &cells);

  /** Read the file of a table_of_refined_cells() of bodies in any order. Throws
   * InputError that names the file and the line. */
  std::vector<std::set<CellId>>
  read_refined_cells(const std::string              &file_name,
                     const std::vector<std::string> &body_names);
} // namespace StickSlip

#endif
