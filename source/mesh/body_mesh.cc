// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/mesh/body_mesh.h>

#include <algorithm>
#include <map>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    using CellIterator = typename Triangulation<dim>::cell_iterator;



    /** Flag what is active below @p cell and refined below @p pattern; returns
     * whether there is any. */
    template <int dim>
    bool
    flag_for_refinement(const CellIterator<dim> &cell,
                        const CellIterator<dim> &pattern)
    {
      if (pattern->is_active())
        return false;
      if (cell->is_active())
        {
          cell->set_refine_flag();
          return true;
        }
      bool any = false;
      for (unsigned int child = 0; child < cell->n_children(); ++child)
        any |=
          flag_for_refinement<dim>(cell->child(child), pattern->child(child));
      return any;
    }



    /** Refine a mesh of the same coarse cells until it is like @p pattern. */
    template <int dim>
    void
    refine_alike(Triangulation<dim> &mesh, const Triangulation<dim> &pattern)
    {
      while (true)
        {
          bool any             = false;
          auto cell_of_pattern = pattern.begin(0);
          for (auto cell = mesh.begin(0); cell != mesh.end(0);
               ++cell, ++cell_of_pattern)
            any |= flag_for_refinement<dim>(cell, cell_of_pattern);
          if (!any)
            return;
          mesh.execute_coarsening_and_refinement();
        }
    }
  } // namespace



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyGeometry<dim> &geometry,
                          const bool               fault_below,
                          const bool               fault_above)
    : mesh(std::make_unique<Triangulation<dim>>())
  {
    GridGenerator::subdivided_hyper_rectangle(
      *mesh,
      std::vector<unsigned int>(geometry.coarse_cells.begin(),
                                geometry.coarse_cells.end()),
      geometry.lower_corner(),
      geometry.upper_corner(),
      /*colorize=*/true);
    const auto unrefined = std::make_shared<Triangulation<dim>>();
    unrefined->copy_triangulation(*mesh);
    coarse_cells = unrefined;
    mesh->refine_global(geometry.uniform_refinements);

    const auto touches_a_fault = [&](const auto &cell) {
      for (const auto &vertex : cell->vertex_indices())
        {
          const double height    = cell->vertex(vertex)[dim - 1];
          const double precision = 1e-10 * geometry.thickness;
          if ((fault_below &&
               std::abs(height - geometry.lower_corner()[dim - 1]) <
                 precision) ||
              (fault_above &&
               std::abs(height - geometry.upper_corner()[dim - 1]) < precision))
            return true;
        }
      return false;
    };
    for (unsigned int pass = 0; pass < geometry.refinement_passes; ++pass)
      {
        bool any = false;
        for (const auto &cell : mesh->active_cell_iterators())
          if (touches_a_fault(cell))
            {
              cell->set_refine_flag();
              any = true;
            }
        if (any)
          mesh->execute_coarsening_and_refinement();
      }
    distribute_dofs();
  }



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyMesh &finer)
    : coarse_cells(finer.coarse_cells)
    , mesh(std::make_unique<Triangulation<dim>>())
  {
    Triangulation<dim> coarsened;
    coarsened.copy_triangulation(*finer.mesh);
    for (const auto &cell : coarsened.active_cell_iterators())
      if (cell->level() > 0)
        cell->set_coarsen_flag();
    coarsened.execute_coarsening_and_refinement();
    AssertThrow(coarsened.n_active_cells() < finer.mesh->n_active_cells(),
                ExcMessage("The mesh of a body could not be coarsened."));

    // A mesh that has been coarsened keeps the memory of the finer one.
    mesh->copy_triangulation(*coarse_cells);
    refine_alike(*mesh, coarsened);
    AssertDimension(mesh->n_active_cells(), coarsened.n_active_cells());
    distribute_dofs();
  }



  template <int dim>
  void
  BodyMesh<dim>::distribute_dofs()
  {
    dofs = std::make_unique<DoFHandler<dim>>(*mesh);
    dofs->distribute_dofs(FE_Q<dim>(1));
    DoFTools::make_hanging_node_constraints(*dofs, constraints);
    constraints.close();
  }



  template <int dim>
  bool
  BodyMesh<dim>::can_be_coarsened() const
  {
    return mesh->n_levels() > 1;
  }



  template <int dim>
  FaultSurface<dim>
  BodyMesh<dim>::surface(const types::boundary_id side) const
  {
    constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_face;

    std::map<types::global_dof_index, Point<dim>>                nodes;
    std::vector<std::array<types::global_dof_index, n_vertices>> faces;
    for (const auto &cell : dofs->active_cell_iterators())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
            {
              faces.emplace_back();
              for (unsigned int v = 0; v < n_vertices; ++v)
                {
                  faces.back()[v]        = face->vertex_dof_index(v, 0);
                  nodes[faces.back()[v]] = face->vertex(v);
                }
            }

    std::vector<std::pair<Point<dim>, types::global_dof_index>> sorted;
    for (const auto &node : nodes)
      sorted.emplace_back(node.second, node.first);
    std::sort(sorted.begin(), sorted.end(), [](const auto &a, const auto &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.first[d] != b.first[d])
          return a.first[d] < b.first[d];
      return a.second < b.second;
    });

    FaultSurface<dim>                               surface;
    std::map<types::global_dof_index, unsigned int> position;
    for (const auto &node : sorted)
      {
        position[node.second] = surface.dofs.size();
        surface.dofs.push_back(node.second);
        surface.points.push_back(node.first);
      }
    for (const auto &face : faces)
      {
        surface.faces.emplace_back();
        for (unsigned int v = 0; v < n_vertices; ++v)
          surface.faces.back()[v] = position[face[v]];
      }
    std::sort(surface.faces.begin(), surface.faces.end());
    return surface;
  }



  template <int dim>
  std::vector<types::global_dof_index>
  BodyMesh<dim>::dofs_on_side(const types::boundary_id side) const
  {
    return surface(side).dofs;
  }



  template <int dim>
  std::vector<Point<dim>>
  BodyMesh<dim>::node_positions() const
  {
    std::vector<Point<dim>> positions(dofs->n_dofs());
    for (const auto &cell : dofs->active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        positions[cell->vertex_dof_index(v, 0)] = cell->vertex(v);
    return positions;
  }



  template <int dim>
  std::pair<double, double>
  BodyMesh<dim>::cell_diameters() const
  {
    return {GridTools::minimal_cell_diameter(*mesh),
            GridTools::maximal_cell_diameter(*mesh)};
  }



  template <int dim>
  const Triangulation<dim> &
  BodyMesh<dim>::triangulation() const
  {
    return *mesh;
  }



  template <int dim>
  const DoFHandler<dim> &
  BodyMesh<dim>::dof_handler() const
  {
    return *dofs;
  }



  template <int dim>
  const AffineConstraints<double> &
  BodyMesh<dim>::hanging_nodes() const
  {
    return constraints;
  }



  template class BodyMesh<2>;
  template class BodyMesh<3>;
} // namespace StickSlip
