// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/vertices_on_sides.h>

namespace StickSlip
{
  template <int dim>
  std::vector<bool>
  vertices_on_sides(const Triangulation<dim>           &mesh,
                    const std::set<types::boundary_id> &sides)
  {
    std::vector<bool> is_on_side(mesh.n_vertices(), false);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
            for (const auto v : face->vertex_indices())
              is_on_side[face->vertex_index(v)] = true;
    return is_on_side;
  }



  template decltype(vertices_on_sides<2>) vertices_on_sides<2>;
  template decltype(vertices_on_sides<3>) vertices_on_sides<3>;
} // namespace StickSlip
