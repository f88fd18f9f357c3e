// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_cell_lines_h
#define stickslip_mesh_cell_lines_h

#include <stickslip/mesh/body_mesh.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  /** Two active cells of a mesh, by their indices. */
  using CellPair = std::pair<unsigned int, unsigned int>;

  /** Each two cells that share a face, or part of one, once, the one with the
   * smaller face or number first. If only @p in_lines, those of them across
   * whose face nodes couple so strongly that they are relaxed together: cells
   * that are flat along one axis, which that face is across. */
  template <int dim>
  std::vector<CellPair>
  neighbouring_cells(const BodyMesh<dim> &body, const bool in_lines);

  /** Return if nodes couple so strongly across this face of an active cell that
   * they are relaxed together: if the cell is flat along the axis that the face
   * is across. */
  template <int dim>
  bool
  is_across_line(const typename Triangulation<dim>::active_cell_iterator &cell,
                 const unsigned int                                       face);

  /** Return if any of these cells is so flat along an axis, and those that they
   * are refined into. */
  template <int dim>
  bool
  has_lines(const Triangulation<dim> &cells);

  /**
   * Numbers for @p n things, in ascending order of the first of each number,
   * equal for those in the same piece of a line. Things in lines are joined by
   * these @p pairs; of a line with more than @p longest things as many
   * pieces of about equal length are made as needed.
   */
  std::vector<unsigned int>
  pieces_of_lines(const unsigned int           n,
                  const std::vector<CellPair> &pairs,
                  const unsigned int           longest);
} // namespace StickSlip

#endif
