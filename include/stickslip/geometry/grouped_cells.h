// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_grouped_cells_h
#define stickslip_geometry_grouped_cells_h

#include <stickslip/geometry/gmsh_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The cells and named faces of mesh files, as cells of bodies: physical
   * groups of volumes (in two dimensions, of surfaces) are bodies, those of the
   * dimension below name faces. Nodes of several files are not joined.
   */
  template <int dim>
  struct GroupedCells
  {
    struct Cell
    {
      /** Vertices in deal.II's order: all cells have a positive volume. */
      std::array<unsigned int, (1u << dim)> vertices;
      unsigned int                          n_vertices;
      unsigned int                          body;
    };

    struct Face
    {
      std::array<unsigned int, (1u << (dim - 1))> vertices;
      unsigned int                                n_vertices;

      /** Place in the array of names. */
      unsigned int group;
    };

    std::vector<std::string> body_names;

    /** Names of the groups of faces, those of equal names in several files
     * being one. */
    std::vector<std::string> group_names;

    /** Positions of all nodes, m, those without a cell included. */
    std::vector<Point<dim>> points;
    std::vector<Cell>       cells;
    std::vector<Face>       faces;

    GroupedCells() = default;

    /**
     * Throws InputError if cells or faces of the files have no named group, a
     * body has no cells or cells of different shapes, a group has no elements,
     * a cell is inverted or degenerate, or the files are of another dimension.
     */
    GroupedCells(const std::vector<GmshFile>    &files,
                 const std::vector<std::string> &body_names);

    /** The centre of a cell or a face: the mean of its vertices. */
    template <typename CellOrFace>
    Point<dim>
    centre(const CellOrFace &object) const
    {
      Point<dim> result;
      for (unsigned int v = 0; v < object.n_vertices; ++v)
        result += points[object.vertices[v]] / object.n_vertices;
      return result;
    }
  };

  /** A position in words, for messages: "(1, 2)". */
  template <int dim>
  std::string
  position_text(const Point<dim> &point);
} // namespace StickSlip

#endif
