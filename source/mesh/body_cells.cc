// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/mesh/body_cells.h>

namespace StickSlip
{
  template <int dim>
  std::shared_ptr<const Triangulation<dim>>
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
