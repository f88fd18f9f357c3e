// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/leaf_cells.h>
#include <stickslip/mesh/unit_refinement.h>
#include <stickslip/mesh/vertices_on_sides.h>

namespace StickSlip
{
  template <int dim>
  std::vector<bool>
  UnitRefinement<dim>::needed_vertices(const Triangulation<dim> &mesh,
                                       const unsigned int        n_rows) const
  {
    std::vector<bool> result = vertices_on_sides(mesh, whole_sides);
    // No mesh is without cells.
    result[mesh.begin(0)->vertex_index(0)] = true;
    const unsigned int process = Utilities::MPI::this_mpi_process(communicator);
    for (const auto &unit : units->active_cell_iterators())
      if (owner(unit) == process)
        for_each_leaf_below(typename Triangulation<dim>::cell_iterator(
                              &mesh, unit->level(), unit->index()),
                            [&](const auto &cell, const std::uint64_t) {
                              for (const auto v : cell->vertex_indices())
                                result[cell->vertex_index(v)] = true;
                            });
    mark_rows_around(mesh, n_rows, result);
    return result;
  }



  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  UnitRefinement<dim>::make_mesh() const
  {
    const auto mesh = std::make_shared<Triangulation<dim>>();
    mesh->copy_triangulation(*units);
    while (true)
      {
        const std::vector<bool> touches_fault =
          vertices_on_sides(*mesh, sides_at_faults);
        // Cells far away may touch a fault without knowing it; so one row more
        // than is needed, where that matters.
        const std::vector<bool> is_needed =
          needed_vertices(*mesh, n_rows() + (steps.at_faults == 0 ? 0 : 1));
        bool any = false;
        for (const auto &cell : mesh->active_cell_iterators())
          if (has_marked_vertex<dim>(cell, is_needed) &&
              !steps.ends_at(cell->level(),
                             has_marked_vertex<dim>(cell, touches_fault)))
            {
              cell->set_refine_flag();
              any = true;
            }
        if (!any)
          return mesh;
        mesh->execute_coarsening_and_refinement();
      }
  }



  template <int dim>
  std::vector<bool>
  UnitRefinement<dim>::real_cells(const Triangulation<dim> &mesh) const
  {
    const std::vector<bool> touches_fault =
                              vertices_on_sides(mesh, sides_at_faults),
                            is_needed = needed_vertices(mesh, n_rows());
    std::vector<bool> result(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      result[cell->active_cell_index()] =
        has_marked_vertex<dim>(cell, is_needed) &&
        steps.ends_at(cell->level(),
                      has_marked_vertex<dim>(cell, touches_fault));
    return result;
  }



  template struct UnitRefinement<2>;
  template struct UnitRefinement<3>;
} // namespace StickSlip
