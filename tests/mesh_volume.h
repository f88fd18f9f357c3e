// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_mesh_volume_h
#define stickslip_tests_mesh_volume_h

#include <deal.II/grid/tria.h>

namespace StickSlip::Tests
{
  using namespace dealii;

  /** The sum of the measures of all cells, m^dim. */
  template <int dim>
  double
  volume(const Triangulation<dim> &mesh)
  {
    double result = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      result += cell->measure();
    return result;
  }
} // namespace StickSlip::Tests

#endif
