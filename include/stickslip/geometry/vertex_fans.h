// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_vertex_fans_h
#define stickslip_geometry_vertex_fans_h

#include <stickslip/geometry/cell_faces.h>

#include <map>
#include <utility>

namespace StickSlip
{
  /**
   * The fans of cells at the vertices of faces that are to be cut open: at each
   * vertex, cells that are joined by faces that are not cut belong to the same
   * fan. Each fan gets a copy of the vertex of its own; the edge of a cut is
   * where there is one fan, and cuts meet where there are more than two.
   */
  template <int dim>
  class VertexFans
  {
  public:
    /** @p is_cut: for each face of the cells. */
    VertexFans(const GroupedCells<dim> &mesh,
               const CellFaces<dim>    &faces,
               const std::vector<bool> &is_cut);

    /** The number of the fan to which a cell belongs at one of its vertices;
     * zero at vertices of no cut. */
    unsigned int
    fan(const unsigned int cell, const unsigned int vertex) const;

    /** The number of fans at a vertex; one at vertices of no cut. */
    unsigned int
    n_fans(const unsigned int vertex) const;

  private:
    /** Fans but the first by vertex and cell, and numbers of fans but one. */
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> fans;
    std::map<unsigned int, unsigned int>                          number;
  };
} // namespace StickSlip

#endif
