// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/geometry/body_cells.h>

#include <set>

namespace StickSlip
{
  template <int dim>
  std::vector<Point<dim>>
  BodyCells<dim>::vertices_on(const types::boundary_id side) const
  {
    std::set<unsigned int> on_side;
    const auto             collect = [&](const auto &faces) {
      for (const auto &face : faces)
        if (face.boundary_id == side)
          on_side.insert(face.vertices.begin(), face.vertices.end());
    };
    collect(boundary.boundary_lines);
    collect(boundary.boundary_quads);
    std::vector<Point<dim>> result;
    for (const unsigned int v : on_side)
      result.push_back(vertices[v]);
    return result;
  }



  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  BodyCells<dim>::triangulation() const
  {
    Assert(!cells.empty(), ExcMessage("A body has no cells."));
    std::vector<CellData<dim>> ordered = cells;
    if (cells[0].vertices.size() == GeometryInfo<dim>::vertices_per_cell)
      GridTools::consistently_order_cells(ordered);
    const auto result = std::make_shared<Triangulation<dim>>();
    result->create_triangulation(vertices, ordered, boundary);
    return result;
  }



  template struct BodyCells<2>;
  template struct BodyCells<3>;
} // namespace StickSlip
