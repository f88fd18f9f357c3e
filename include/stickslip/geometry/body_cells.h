// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_body_cells_h
#define stickslip_geometry_body_cells_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** The cells of a body before any refinement, and its named sides: all of its
   * boundary. */
  template <int dim>
  struct BodyCells
  {
    /** Positions, m. */
    std::vector<Point<dim>> vertices;

    /** Cells of positive volume, all of one shape. */
    std::vector<CellData<dim>> cells;

    /** All boundary faces and their indicators. */
    SubCellData boundary;

    /** Names of the sides by boundary indicator. */
    std::map<types::boundary_id, std::string> side_names;

    /** The points by which the sides of a block are given, ends included, along
     * the first and the last axis, m, by boundary indicator; all other vertices
     * there only divide what is between them. Empty for mesh files. */
    std::map<types::boundary_id, std::vector<Point<2>>> outlines;

    /** Positions of the vertices of the faces on one side, m. */
    std::vector<Point<dim>>
    vertices_on(const types::boundary_id side) const;

    /** The mesh of these cells. Throws an exception of deal.II's if they cannot
     * be one. */
    std::shared_ptr<Triangulation<dim>>
    triangulation() const;
  };
} // namespace StickSlip

#endif
