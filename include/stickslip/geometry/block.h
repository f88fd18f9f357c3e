// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_block_h
#define stickslip_geometry_block_h

#include <stickslip/geometry/fault_cutting.h>

#include <array>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * A quadrilateral body given by its corners, in three dimensions extruded
   * along y. Its sides are named like those of a brick, and may be polylines in
   * place of straight lines.
   *
   * Points of a polyline are vertices of the coarse cells, and cells are spread
   * over its pieces by their lengths, so that both sides of a fault have the
   * same shape however many cells they have. On a side that is smooth, vertices
   * between the points are on the curve through these (SmoothOutline). Inside,
   * vertices are where the bilinearly blended map of Coons has them, see S. A.
   * Coons, "Surfaces for computer-aided design of space forms", MIT, 1967.
   */
  template <int dim>
  struct Block
  {
    /** Name of the body. */
    std::string name;

    /** Coordinates along the first and the last axis, m, counter-clockwise:
     * where the left side meets the bottom, the bottom the right side, the
     * right side the top, and the top the left side. */
    std::array<Point<2>, 4> corners;

    /** Points between the corners of the left, right, bottom and top side, m,
     * from left to right or from bottom to top. */
    std::array<std::vector<Point<2>>, 4> polylines;

    /** True for the left, right, bottom and top side if a smooth curve goes
     * through its points, and not straight lines. */
    std::array<bool, 4> is_smooth = {};

    /** In three dimensions the lower and the upper end along y, m. */
    std::array<double, 2> along_y = {};

    /** Coarse cells along each axis. */
    std::array<unsigned int, dim> cells;

    /** The subsection of the entries, for messages. */
    std::string section;
  };

  /**
   * The cells of blocks, whose nodes are not joined, and all of their sides.
   * Throws InputError if a block has less than four corners, is not convex at
   * one of them, has its corners in clockwise order, a polyline of more pieces
   * than cells, or cells that are inverted.
   */
  template <int dim>
  GroupedCells<dim>
  cells_of_blocks(const std::vector<Block<dim>> &blocks);

  /** Let the sides of blocks at a fault be smooth. */
  template <int dim>
  void
  smoothen(std::vector<Block<dim>> &blocks, const MeshFault &fault);

  /** Tell the bodies cut from cells_of_blocks() the points of their sides. */
  template <int dim>
  void
  note_outlines(const std::vector<Block<dim>> &blocks, CutMesh<dim> &mesh);
} // namespace StickSlip

#endif
