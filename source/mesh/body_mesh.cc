// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/geometry/fault_shape.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/cell_lines.h>
#include <stickslip/mesh/hanging_nodes.h>
#include <stickslip/mesh/partial_mesh.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/mesh/tree_order.h>
#include <stickslip/mesh/vertices_on_sides.h>

#include <algorithm>
#include <utility>

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
      std::vector<bool> is_on_side = vertices_on_sides(mesh, sides);
      if (where)
        for (unsigned int v = 0; v < is_on_side.size(); ++v)
          if (is_on_side[v])
            is_on_side[v] = (where(mesh.get_vertices()[v]) > 0.);

      mark_rows_around(mesh, std::max(rows, 1u) - 1, is_on_side);

      bool any = false;
      for (const auto &cell : mesh.active_cell_iterators())
        if (has_marked_vertex<dim>(cell, is_on_side))
          {
            cell->set_refine_flag();
            any = true;
          }
      if (any)
        refine_flagged(mesh);
    }



    /** Some sides, with those at faults, which have nodes in common with them.
     */
    std::set<types::boundary_id>
    with_faults(std::set<types::boundary_id>        sides,
                const std::set<types::boundary_id> &sides_at_faults)
    {
      if (!sides.empty())
        sides.insert(sides_at_faults.begin(), sides_at_faults.end());
      return sides;
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
    , couples_patches(body.couples_patches)
    , fault_sides(sides_at_faults)
    , kept_sides(with_faults(body.whole_sides, sides_at_faults))
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
  BodyMesh<dim>::BodyMesh(
    const std::shared_ptr<const BodyMesh>                  &units,
    const std::shared_ptr<const std::vector<unsigned int>> &owners,
    const RefinementSteps                                  &steps,
    const unsigned int                                      depth,
    const MPI_Comm                                         &communicator)
    : lateral_lower(units->lateral_lower)
    , period(units->period)
    , rigid(units->rigid)
    , couples_patches(units->couples_patches)
    , fault_sides(units->fault_sides)
    , kept_sides(units->kept_sides)
    , coarse_cells(units->coarse_cells)
    , coarser_cells(units->coarser_cells)
    , units(units)
    , refinement(std::make_unique<UnitRefinement<dim>>(
        UnitRefinement<dim>{units->unstraightened(),
                            owners,
                            steps,
                            depth,
                            fault_sides,
                            sides_of_shares(),
                            couples_patches,
                            communicator}))
  {
    MeshShare<dim> share;
    carry_out_agreed(communicator, [&]() { share = refinement->make_share(); });
    mesh       = share.mesh;
    real_cells = share.is_real;
    if (share.red_refinement != nullptr)
      red_refinements.push_back(share.red_refinement);
    number_dofs();
    unit_numbers = std::make_unique<const UnitNumbers>(
      number_share(share, *dofs, communicator));
    if (steps.at_faults > 0)
      add_hanging_nodes(*dofs, real_cells, constraints);
    bind_images();
    constraints.close();
    find_patches();
  }



  template <int dim>
  std::shared_ptr<const BodyMesh<dim>>
  BodyMesh<dim>::coarsened(const BodyMesh &finer)
  {
    if (finer.refinement == nullptr)
      return std::shared_ptr<const BodyMesh>(new BodyMesh(finer));
    if (finer.refinement->depth == 1)
      return finer.units;
    return std::make_shared<BodyMesh>(finer.units,
                                      finer.refinement->owners,
                                      finer.refinement->steps.coarser(1),
                                      finer.refinement->depth - 1,
                                      finer.refinement->communicator);
  }



  template <int dim>
  BodyMesh<dim>::BodyMesh(const BodyMesh &finer)
    : lateral_lower(finer.lateral_lower)
    , period(finer.period)
    , rigid(finer.rigid)
    , couples_patches(finer.couples_patches)
    , fault_sides(finer.fault_sides)
    , kept_sides(finer.kept_sides)
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
  BodyMesh<dim>::BodyMesh(const BodyMesh                       &whole,
                          const std::vector<bool>              &is_kept,
                          std::vector<types::global_dof_index> *dofs_before)
    : lateral_lower(whole.lateral_lower)
    , period(whole.period)
    , rigid(whole.rigid)
    , couples_patches(whole.couples_patches)
    , fault_sides(whole.fault_sides)
    , kept_sides(whole.kept_sides)
  {
    PartialMesh<dim> kept(*whole.mesh, is_kept);
    mesh = kept.mesh;
    number_dofs();

    cell_patches     = CellPatches(whole.cell_patches, is_kept);
    part             = Part();
    part->n_vertices = whole.n_vertices();
    part->n_cells    = whole.n_cells();
    for (const unsigned int cell : kept.cells)
      cell_numbers.push_back(whole.whole_cell(cell));
    std::vector<types::global_dof_index>       before(dofs->n_dofs());
    const std::vector<types::global_dof_index> here = dofs_of_vertices(),
                                               in_whole =
                                                 whole.dofs_of_vertices();
    std::vector<types::global_dof_index> number(whole.dofs->n_dofs(),
                                                numbers::invalid_dof_index);
    for (unsigned int v = 0; v < here.size(); ++v)
      {
        const types::global_dof_index dof = in_whole[kept.vertices[v]];
        before[here[v]]                   = dof;
        number[dof]                       = here[v];
      }
    for (const types::global_dof_index dof : before)
      part->dofs.push_back(whole.whole_dof(dof));
    part->dofs.shrink_to_fit();

    for (const auto &line : whole.constraints.get_lines())
      {
        if (number[line.index] == numbers::invalid_dof_index)
          continue;
        const types::global_dof_index bound = number[line.index];
        constraints.add_line(bound);
        if (std::all_of(
              line.entries.begin(), line.entries.end(), [&](const auto &entry) {
                return number[entry.first] != numbers::invalid_dof_index;
              }))
          for (const auto &entry : line.entries)
            constraints.add_entry(bound, number[entry.first], entry.second);
      }
    constraints.close();
    if (dofs_before != nullptr)
      *dofs_before = std::move(before);
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
  std::shared_ptr<const Triangulation<dim>>
  BodyMesh<dim>::unstraightened() const
  {
    if (!has_shapes(*mesh) || !mesh->has_hanging_nodes())
      return mesh;
    const std::shared_ptr<Triangulation<dim>> result = copy_coarse_cells();
    refine_listed(refined_cells(*mesh), *result);
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
  BodyMesh<dim>::number_dofs()
  {
    dofs = std::make_unique<DoFHandler<dim>>(*mesh);
    if (mesh->all_reference_cells_are_hyper_cube())
      dofs->distribute_dofs(FE_Q<dim>(1));
    else
      dofs->distribute_dofs(FE_SimplexP<dim>(1));
  }



  template <int dim>
  void
  BodyMesh<dim>::distribute_dofs()
  {
    number_dofs();
    // Bodies that couple patches have no graded shares, and take a step of
    // conjugate gradients more in the order of trees.
    if (red_refinements.empty() && !couples_patches &&
        mesh->n_active_cells() > mesh->n_cells(mesh->n_levels() - 1))
      cell_numbers = number_by_trees(*dofs);
    DoFTools::make_hanging_node_constraints(*dofs, constraints);
    bind_images();
    constraints.close();
    find_patches();
  }



  template <int dim>
  void
  BodyMesh<dim>::bind_images()
  {
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0)
        DoFTools::make_periodicity_constraints(
          *dofs, 2 * axis + 1, 2 * axis, axis, constraints);
  }



  template <int dim>
  void
  BodyMesh<dim>::find_patches()
  {
    if (couples_patches)
      cell_patches = red_refinements.empty() ?
                       CellPatches::of_trees(*mesh) :
                       CellPatches::of_equal_parts(*mesh);
  }



  template <int dim>
  unsigned int
  BodyMesh<dim>::n_coarsenings() const
  {
    if (refinement != nullptr)
      return refinement->depth + units->n_coarsenings();
    return std::max<unsigned int>(mesh->n_levels() - 1, red_refinements.size());
  }



  template <int dim>
  bool
  BodyMesh<dim>::can_have_units(const CoarseBody<dim> &body)
  {
    if (!body.refined_cells.empty() || body.rigid)
      return false;
    if (body.refinement_passes == 0)
      return true;
    // Rows would have to go on behind a joint, patches reach farther than
    // cells, and most cells would be in the few rows of units at the faults,
    // which would have to be cut where they are lines.
    return body.cells->all_reference_cells_are_hyper_cube() &&
           body.refinement_rows == 1 && !body.refine_where &&
           body.period.norm() == 0. && !body.couples_patches &&
           !has_lines(*body.cells);
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
    return surface_of_faces<dim>(faces_on_side(side), period);
  }



  template <int dim>
  std::vector<SideFace<dim>>
  BodyMesh<dim>::faces_on_side(const types::boundary_id side) const
  {
    return BodySides<dim>{*dofs, constraints, lateral_lower, period}.faces(
      side, [this](const auto &cell) { return is_real(cell); });
  }



  template <int dim>
  std::vector<types::global_dof_index>
  BodyMesh<dim>::dofs_on_side(const types::boundary_id side) const
  {
    return surface(side).nodes;
  }



  template <int dim>
  std::vector<types::global_dof_index>
  BodyMesh<dim>::dofs_of_vertices() const
  {
    std::vector<types::global_dof_index> result(mesh->n_vertices(),
                                                numbers::invalid_dof_index);
    for (const auto &cell : dofs->active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        result[cell->vertex_index(v)] = cell->vertex_dof_index(v, 0);
    return result;
  }



  template <int dim>
  std::set<types::boundary_id>
  BodyMesh<dim>::sides_of_shares() const
  {
    std::set<types::boundary_id> sides = kept_sides;
    // Bound nodes on one of two joined sides name those on the other.
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0)
        sides.insert({2 * axis, 2 * axis + 1});
    return with_faults(std::move(sides), fault_sides);
  }



  template <int dim>
  std::vector<bool>
  BodyMesh<dim>::vertices_on_kept_sides() const
  {
    return vertices_on_sides(*mesh, kept_sides);
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
  unsigned int
  BodyMesh<dim>::n_vertices() const
  {
    return part         ? part->n_vertices :
           unit_numbers ? unit_numbers->nodes.n_nodes :
                          mesh->n_used_vertices();
  }



  template <int dim>
  unsigned int
  BodyMesh<dim>::n_cells() const
  {
    return part         ? part->n_cells :
           unit_numbers ? unit_numbers->n_cells :
                          mesh->n_active_cells();
  }



  template <int dim>
  MeshFigures
  BodyMesh<dim>::figures() const
  {
    MeshFigures result;
    result.n_vertices = n_vertices();
    result.n_cells    = n_cells();
    for (const auto &cell : mesh->active_cell_iterators())
      if (is_real(cell))
        {
          result.smallest = std::min(result.smallest, cell->diameter());
          result.largest  = std::max(result.largest, cell->diameter());
        }
    return result;
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
