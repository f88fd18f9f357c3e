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
#include <tuple>

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



    /** The normal of a face away from the centre of its cell, as long as the
     * face is large, m^(dim-1). */
    template <int dim>
    Tensor<1, dim>
    outward_area(const typename Triangulation<dim>::face_iterator &face,
                 const Point<dim>                                 &cell_centre)
    {
      Tensor<1, dim> area;
      if constexpr (dim == 2)
        area = cross_product_2d(face->vertex(1) - face->vertex(0));
      else
        area = 0.5 * cross_product_3d(face->vertex(3) - face->vertex(0),
                                      face->vertex(2) - face->vertex(1));
      return area * (face->center() - cell_centre) > 0. ? area : -area;
    }



    /** Refine every cell with a vertex on one of the sides. */
    template <int dim>
    void
    refine_at(const std::set<types::boundary_id> &sides,
              Triangulation<dim>                 &mesh)
    {
      std::vector<bool> is_on_side(mesh.n_vertices(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
            for (const auto v : face->vertex_indices())
              is_on_side[face->vertex_index(v)] = true;

      bool any = false;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto v : cell->vertex_indices())
          if (is_on_side[cell->vertex_index(v)])
            {
              cell->set_refine_flag();
              any = true;
            }
      if (any)
        mesh.execute_coarsening_and_refinement();
    }
  } // namespace



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyGeometry<dim>            &geometry,
                          const std::set<types::boundary_id> &sides_at_faults)
    : lateral_lower(geometry.lateral_lower)
    , period(geometry.period())
    , rigid(geometry.rigid)
    , mesh(std::make_unique<Triangulation<dim>>())
  {
    GridGenerator::subdivided_hyper_rectangle(
      *mesh,
      rigid ? std::vector<unsigned int>(dim, 1) :
              std::vector<unsigned int>(geometry.coarse_cells.begin(),
                                        geometry.coarse_cells.end()),
      geometry.lower_corner(),
      geometry.upper_corner(),
      /*colorize=*/true);
    if (geometry.is_sloped())
      GridTools::transform(
        [&geometry](const Point<dim> &point) { return geometry.sloped(point); },
        *mesh);
    const auto unrefined = std::make_shared<Triangulation<dim>>();
    unrefined->copy_triangulation(*mesh);
    coarse_cells = unrefined;
    join_periodic_sides(*mesh);
    if (rigid)
      {
        distribute_dofs();
        return;
      }
    mesh->refine_global(geometry.uniform_refinements);

    for (unsigned int pass = 0; pass < geometry.refinement_passes; ++pass)
      refine_at(sides_at_faults, *mesh);
    distribute_dofs();
  }



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyMesh &finer)
    : lateral_lower(finer.lateral_lower)
    , period(finer.period)
    , rigid(finer.rigid)
    , coarse_cells(finer.coarse_cells)
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
    join_periodic_sides(*mesh);
    refine_alike(*mesh, coarsened);
    AssertDimension(mesh->n_active_cells(), coarsened.n_active_cells());
    distribute_dofs();
  }



  template <int dim>
  void
  BodyMesh<dim>::join_periodic_sides(Triangulation<dim> &triangulation) const
  {
    std::vector<
      GridTools::PeriodicFacePair<typename Triangulation<dim>::cell_iterator>>
      pairs;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0)
        GridTools::collect_periodic_faces(
          triangulation, 2 * axis + 1, 2 * axis, axis, pairs);
    // Neighbours across the joint must not differ by more than one refinement.
    if (!pairs.empty())
      triangulation.add_periodicity(pairs);
  }



  template <int dim>
  void
  BodyMesh<dim>::distribute_dofs()
  {
    dofs = std::make_unique<DoFHandler<dim>>(*mesh);
    dofs->distribute_dofs(FE_Q<dim>(1));
    DoFTools::make_hanging_node_constraints(*dofs, constraints);
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0)
        DoFTools::make_periodicity_constraints(
          *dofs, 2 * axis + 1, 2 * axis, axis, constraints);
    constraints.close();
  }



  template <int dim>
  std::pair<types::global_dof_index, std::array<int, dim - 1>>
  BodyMesh<dim>::node_of_vertex(const types::global_dof_index dof,
                                const Point<dim>             &vertex) const
  {
    std::array<int, dim - 1> wraps    = {};
    bool                     is_image = false;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0 &&
          vertex[axis] > lateral_lower[axis] + (1. - 1e-10) * period[axis])
        {
          wraps[axis] = 1;
          is_image    = true;
        }
    if (!is_image)
      return {dof, wraps};
    const auto *entries = constraints.get_constraint_entries(dof);
    AssertThrow(entries != nullptr, ExcInternalError());
    // A hanging node's image: only its place on the other side is asked for
    // here, and that has no node of its own.
    if (entries->size() != 1)
      return {dof, {}};
    return {entries->front().first, wraps};
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

    struct Face
    {
      // Degrees of freedom, then positions in the surface.
      std::array<types::global_dof_index, n_vertices>  dofs;
      std::array<std::array<int, dim - 1>, n_vertices> wraps;
      Tensor<1, dim>                                   outward;
    };

    std::map<types::global_dof_index, Point<dim>> nodes;
    std::vector<Face>                             faces;
    for (const auto &cell : dofs->active_cell_iterators())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
            {
              faces.emplace_back();
              faces.back().outward = outward_area<dim>(face, cell->center());
              for (unsigned int v = 0; v < n_vertices; ++v)
                {
                  const auto [dof, wraps] =
                    node_of_vertex(face->vertex_dof_index(v, 0),
                                   face->vertex(v));
                  Point<dim> position = face->vertex(v);
                  for (unsigned int d = 0; d + 1 < dim; ++d)
                    if (wraps[d] != 0)
                      position[d] = lateral_lower[d];
                  faces.back().dofs[v]  = dof;
                  faces.back().wraps[v] = wraps;
                  nodes[dof]            = position;
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
        position[node.second] = surface.nodes.size();
        surface.nodes.push_back(node.second);
        surface.points.push_back(node.first);
      }
    for (Face &face : faces)
      for (auto &dof : face.dofs)
        dof = position[dof];
    std::sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) {
      return std::tie(a.dofs, a.wraps) < std::tie(b.dofs, b.wraps);
    });
    for (const Face &face : faces)
      {
        surface.faces.emplace_back();
        std::copy(face.dofs.begin(),
                  face.dofs.end(),
                  surface.faces.back().begin());
        if (period.norm() > 0)
          surface.wraps.push_back(face.wraps);
      }
    surface.period = period;
    std::vector<Tensor<1, dim>> areas;
    for (const Face &face : faces)
      areas.push_back(face.outward);
    surface.set_normals(areas);
    return surface;
  }



  template <int dim>
  std::vector<types::global_dof_index>
  BodyMesh<dim>::dofs_on_side(const types::boundary_id side) const
  {
    return surface(side).nodes;
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
  const Tensor<1, dim - 1> &
  BodyMesh<dim>::lateral_period() const
  {
    return period;
  }



  template class BodyMesh<2>;
  template class BodyMesh<3>;
} // namespace StickSlip
