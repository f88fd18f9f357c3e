// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/face_area.h>
#include <stickslip/geometry/fault_shape.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/refined_cells.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    using CellIterator = typename Triangulation<dim>::cell_iterator;



    /** Flag the active cells below @p cell that have grandchildren at the same
     * place in a finer mesh; returns true if there are any. */
    template <int dim>
    bool
    flag_where_grandchildren(const CellIterator<dim> &cell,
                             const CellIterator<dim> &finer)
    {
      if (finer->is_active())
        return false;
      bool any = false;
      for (unsigned int child = 0; child < finer->n_children(); ++child)
        if (cell->is_active())
          any |= finer->child(child)->has_children();
        else
          any |= flag_where_grandchildren<dim>(cell->child(child),
                                               finer->child(child));
      if (any && cell->is_active())
        cell->set_refine_flag();
      return any;
    }



    /** Refine a mesh of the same coarse cells until it is like a finer one,
     * with every cell coarsened that can be. */
    template <int dim>
    void
    refine_less(Triangulation<dim> &mesh, const Triangulation<dim> &finer)
    {
      while (true)
        {
          bool any        = false;
          auto finer_cell = finer.begin(0);
          for (auto cell = mesh.begin(0); cell != mesh.end(0);
               ++cell, ++finer_cell)
            any |= flag_where_grandchildren<dim>(cell, finer_cell);
          if (!any)
            return;
          refine_flagged(mesh);
        }
    }



    /** The normal of a face away from the centre of its cell, as long as the
     * face is large, m^(dim-1). */
    template <int dim>
    Tensor<1, dim>
    outward_area(const typename Triangulation<dim>::face_iterator &face,
                 const Point<dim>                                 &cell_centre)
    {
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_face> vertices;
      for (const auto v : face->vertex_indices())
        vertices[v] = face->vertex(v);
      const Tensor<1, dim> area = face_area<dim>(vertices, face->n_vertices());
      return area * (face->center() - cell_centre) > 0. ? area : -area;
    }



    /** Refine every cell with a vertex on one of the sides, and where a
     * function is greater than zero if there is one, and so many @p rows of
     * cells from there. */
    template <int dim>
    void
    refine_at(const std::set<types::boundary_id>              &sides,
              const std::function<double(const Point<dim> &)> &where,
              const unsigned int                               rows,
              Triangulation<dim>                              &mesh)
    {
      std::vector<bool> is_on_side(mesh.n_vertices(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
            for (const auto v : face->vertex_indices())
              if (!where || where(face->vertex(v)) > 0.)
                is_on_side[face->vertex_index(v)] = true;

      for (unsigned int row = 1; row < rows; ++row)
        {
          const std::vector<bool> is_in_rows_before = is_on_side;
          for (const auto &cell : mesh.active_cell_iterators())
            for (const auto v : cell->vertex_indices())
              if (is_in_rows_before[cell->vertex_index(v)])
                for (const auto w : cell->vertex_indices())
                  is_on_side[cell->vertex_index(w)] = true;
        }

      bool any = false;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto v : cell->vertex_indices())
          if (is_on_side[cell->vertex_index(v)])
            {
              cell->set_refine_flag();
              any = true;
            }
      if (any)
        refine_flagged(mesh);
    }
  } // namespace



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyGeometry<dim>            &geometry,
                          const std::set<types::boundary_id> &sides_at_faults)
    : BodyMesh(coarse_brick(geometry), sides_at_faults)
  {}



  template <int dim>
  BodyMesh<dim>::BodyMesh(const CoarseBody<dim>              &body,
                          const std::set<types::boundary_id> &sides_at_faults)
    : lateral_lower(body.lateral_lower)
    , period(body.period)
    , rigid(body.rigid)
    , coarse_cells(body.cells)
    , coarser_cells(body.coarser_cells)
  {
    if constexpr (dim == 3)
      if (coarse_cells->all_reference_cells_are_simplex())
        {
          if (body.refinement_passes > 0 && !sides_at_faults.empty())
            throw InputError("Tetrahedra cannot be refined at faults only; "
                             "they must be small there in the mesh file.");
          mesh = coarse_cells;
          for (unsigned int i = 0; i < body.uniform_refinements && !rigid; ++i)
            {
              red_refinements.push_back(
                std::make_shared<const RedRefinement>(*mesh));
              mesh = red_refinements.back()->mesh;
            }
          distribute_dofs();
          return;
        }

    const std::shared_ptr<Triangulation<dim>> refined = copy_coarse_cells();
    if (!rigid)
      {
        refined->refine_global(body.uniform_refinements);
        for (unsigned int pass = 0; pass < body.refinement_passes; ++pass)
          refine_at(sides_at_faults,
                    body.refine_where,
                    body.refinement_rows,
                    *refined);
        refine_listed(body.refined_cells, *refined);
      }
    if (has_shapes(*refined))
      {
        straighten_hanging_vertices(*refined);
        refuse_inverted_cells(*refined);
      }
    mesh = refined;
    distribute_dofs();
  }



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyMesh &finer)
    : lateral_lower(finer.lateral_lower)
    , period(finer.period)
    , rigid(finer.rigid)
    , coarse_cells(finer.coarse_cells)
    , coarser_cells(finer.coarser_cells)
    , red_refinements(finer.red_refinements)
  {
    if (!finer.can_be_coarsened())
      {
        AssertThrow(has_coarser_cells(), ExcInternalError());
        coarse_cells = coarser_cells.front();
        coarser_cells.erase(coarser_cells.begin());
        mesh = coarse_cells;
        distribute_dofs();
        return;
      }

    if constexpr (dim == 3)
      if (!red_refinements.empty())
        {
          red_refinements.pop_back();
          mesh = red_refinements.empty() ? coarse_cells :
                                           red_refinements.back()->mesh;
          distribute_dofs();
          return;
        }

    // A mesh that has been coarsened keeps the memory of the finer one, and
    // triangles cannot be coarsened.
    const std::shared_ptr<Triangulation<dim>> refined = copy_coarse_cells();
    refine_less(*refined, *finer.mesh);
    AssertThrow(refined->n_active_cells() < finer.mesh->n_active_cells(),
                ExcMessage("The mesh of a body could not be coarsened."));
    if (has_shapes(*refined))
      straighten_hanging_vertices(*refined);
    mesh = refined;
    distribute_dofs();
  }



  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  BodyMesh<dim>::copy_coarse_cells() const
  {
    const auto result = std::make_shared<Triangulation<dim>>();
    result->copy_triangulation(*coarse_cells);
    join_periodic_sides(*result);
    return result;
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
    if (mesh->all_reference_cells_are_hyper_cube())
      dofs->distribute_dofs(FE_Q<dim>(1));
    else
      dofs->distribute_dofs(FE_SimplexP<dim>(1));
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
    return mesh->n_levels() > 1 || !red_refinements.empty();
  }



  template <int dim>
  bool
  BodyMesh<dim>::has_coarser_cells() const
  {
    return !coarser_cells.empty();
  }



  template <int dim>
  bool
  BodyMesh<dim>::is_nested_with(const BodyMesh &other) const
  {
    return coarse_cells == other.coarse_cells;
  }



  template <int dim>
  const std::vector<std::array<unsigned int, 2>> &
  BodyMesh<dim>::vertex_parents() const
  {
    static const std::vector<std::array<unsigned int, 2>> none;
    return red_refinements.empty() ? none : red_refinements.back()->parents;
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
              faces.back().dofs.fill(numbers::invalid_dof_index);
              for (unsigned int v = 0; v < face->n_vertices(); ++v)
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
        if (dof != numbers::invalid_dof_index)
          dof = position[dof];
    std::sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) {
      return std::tie(a.dofs, a.wraps) < std::tie(b.dofs, b.wraps);
    });
    for (const Face &face : faces)
      {
        surface.faces.emplace_back();
        // The invalid numbers of both types have all bits.
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
