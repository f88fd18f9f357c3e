// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/fault_shape.h>
#include <stickslip/mesh/leaf_cells.h>
#include <stickslip/mesh/unit_refinement.h>
#include <stickslip/mesh/vertices_on_sides.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Siblings of real trees are real, too. */
    template <int dim>
    void
    add_siblings(const Triangulation<dim> &mesh, std::vector<bool> &is_real)
    {
      const std::vector<bool> before = is_real;
      for (const auto &cell : mesh.active_cell_iterators())
        if (before[cell->active_cell_index()] && cell->level() > 0)
          {
            const auto parent = cell->parent();
            for (unsigned int child = 0; child < parent->n_children(); ++child)
              if (parent->child(child)->is_active())
                is_real[parent->child(child)->active_cell_index()] = true;
          }
    }
  } // namespace



  template <int dim>
  MeshShare<dim>
  UnitRefinement<dim>::make_share() const
  {
    if constexpr (dim == 3)
      if (units->all_reference_cells_are_simplex())
        return share_of_tetrahedra();
    return share_of_trees();
  }



  template <int dim>
  template <typename Visitor>
  void
  UnitRefinement<dim>::for_each_named_leaf(const Triangulation<dim> &mesh,
                                           const Visitor &visit) const
  {
    unsigned int number = 0;
    for_each_leaf(*units, [&](const auto &unit) {
      for_each_leaf_below(typename Triangulation<dim>::cell_iterator(
                            &mesh, unit->level(), unit->index()),
                          [&](const auto &cell, const std::uint64_t path) {
                            visit(cell,
                                  CellName(number, path),
                                  (*owners)[unit->active_cell_index()]);
                          });
      ++number;
    });
  }



  template <int dim>
  std::vector<bool>
  UnitRefinement<dim>::vertices_needed_anyway(
    const Triangulation<dim> &mesh) const
  {
    std::vector<bool> result = vertices_on_sides(mesh, whole_sides);
    result[mesh.begin(0)->vertex_index(0)] = true;
    return result;
  }



  template <int dim>
  std::vector<bool>
  UnitRefinement<dim>::needed_vertices(const Triangulation<dim> &mesh,
                                       const unsigned int        n_rows) const
  {
    std::vector<bool>  result = vertices_needed_anyway(mesh);
    const unsigned int me     = this_process();
    for_each_named_leaf(
      mesh, [&](const auto &cell, const CellName &, const unsigned int owner) {
        if (owner == me)
          for (const auto v : cell->vertex_indices())
            result[cell->vertex_index(v)] = true;
      });
    mark_rows_around(mesh, n_rows, result);
    return result;
  }



  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  UnitRefinement<dim>::make_trees() const
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
  MeshShare<dim>
  UnitRefinement<dim>::share_of_trees() const
  {
    MeshShare<dim>          share;
    const auto              mesh = make_trees();
    const std::vector<bool> touches_fault =
      vertices_on_sides(*mesh, sides_at_faults);
    const auto cells_of_whole = [&](const unsigned int rows) {
      const std::vector<bool> is_needed = needed_vertices(*mesh, rows);
      std::vector<bool>       result;
      for (const auto &cell : mesh->active_cell_iterators())
        result.push_back(
          has_marked_vertex<dim>(cell, is_needed) &&
          steps.ends_at(cell->level(),
                        has_marked_vertex<dim>(cell, touches_fault)));
      return result;
    };
    share.is_real = cells_of_whole(n_rows());
    if (has_shapes(*mesh))
      {
        if (steps.at_faults > 0)
          straighten_hanging_vertices(*mesh, cells_of_whole(n_rows() + 1));
        refuse_inverted_cells(*mesh, share.is_real);
      }
    if (couples_patches)
      add_siblings(*mesh, share.is_real);

    for_each_named_leaf(
      *mesh, [&](const auto &cell, const CellName &name, const unsigned int) {
        if (share.is_real[cell->active_cell_index()])
          {
            share.names.push_back(name);
            share.cells.emplace_back(cell->level(), cell->index());
          }
      });
    for_each_leaf(*units, [&](const auto &unit) {
      share.owners.push_back((*owners)[unit->active_cell_index()]);
    });
    share.mesh = mesh;
    return share;
  }



  template <>
  MeshShare<3>
  UnitRefinement<3>::share_of_tetrahedra() const
  {
    MeshShare<3> share;
    share.mesh   = units;
    share.owners = *owners;
    std::vector<CellName> names;
    for (unsigned int unit = 0; unit < owners->size(); ++unit)
      names.emplace_back(unit, 1);

    const unsigned int me          = this_process();
    const auto         find_needed = [&]() {
      std::vector<bool> marks = vertices_needed_anyway(*share.mesh), result;
      for (const auto &cell : share.mesh->active_cell_iterators())
        if (share.owners[names[cell->active_cell_index()].first] == me)
          for (const auto v : cell->vertex_indices())
            marks[cell->vertex_index(v)] = true;
      for (const auto &cell : share.mesh->active_cell_iterators())
        result.push_back(has_marked_vertex<3>(cell, marks));
      return result;
    };
    constexpr unsigned int n_parts = 8;
    for (unsigned int step = 0; step < depth; ++step)
      {
        const std::vector<bool> is_needed = find_needed();
        std::vector<CellName>   finer;
        for (unsigned int cell = 0; cell < names.size(); ++cell)
          if (is_needed[cell])
            for (unsigned int part = 0; part < n_parts; ++part)
              finer.emplace_back(names[cell].first,
                                 names[cell].second * n_parts + part);
        names = std::move(finer);
        share.red_refinement =
          std::make_shared<const RedRefinement>(*share.mesh, is_needed);
        share.mesh = share.red_refinement->mesh;
      }

    share.is_real = find_needed();
    if (couples_patches)
      for (unsigned int first = 0; first < names.size(); first += n_parts)
        {
          const auto begin = share.is_real.begin() + first,
                     end   = begin + n_parts;
          std::fill(begin, end, std::find(begin, end, true) != end);
        }
    for (unsigned int cell = 0; cell < names.size(); ++cell)
      if (share.is_real[cell])
        {
          share.names.push_back(names[cell]);
          share.cells.emplace_back(0, cell);
        }
    return share;
  }



  template struct UnitRefinement<2>;
  template struct UnitRefinement<3>;
} // namespace StickSlip
