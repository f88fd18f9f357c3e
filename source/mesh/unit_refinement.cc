// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>

#include <stickslip/mesh/unit_refinement.h>
#include <stickslip/mesh/vertices_on_sides.h>

#include <algorithm>
#include <array>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;

    /** Numbers of the places of a unit: 3^sum over d of 0 at its lower end
     * along axis d, 1 at the upper one, 2 between them. Its corners, edges,
     * faces and the inside have one each. */
    template <int dim>
    constexpr unsigned int n_places = (dim == 2 ? 9 : 27);

    template <int dim>
    using Lattice = std::array<unsigned int, dim>;

    template <int dim>
    using CellIterator = typename Triangulation<dim>::cell_iterator;



    template <int dim>
    unsigned int
    place_of(const Lattice<dim> &end)
    {
      unsigned int place = 0;
      for (unsigned int d = dim; d-- > 0;)
        place = 3 * place + end[d];
      return place;
    }



    /** The place between two corners of a cell, which may be the same. */
    template <int dim>
    unsigned int
    place_between(const unsigned int v, const unsigned int w)
    {
      Lattice<dim> end;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int v_end = (v >> d) & 1, w_end = (w >> d) & 1;
          end[d] = v_end == w_end ? v_end : 2;
        }
      return place_of<dim>(end);
    }



    /** The number of axes along which a place is between the ends. */
    template <int dim>
    unsigned int
    dimension_of_place(unsigned int place)
    {
      unsigned int dimension = 0;
      for (; place > 0; place /= 3)
        dimension += (place % 3 == 2);
      return dimension;
    }



    /** The corners, edges, faces and insides of all units, counted one kind
     * after the other: the first unit that has them, and the least owner. */
    template <int dim>
    class UnitPlaces
    {
    public:
      UnitPlaces(const Triangulation<dim>        &units,
                 const std::vector<unsigned int> &owners)
        : first_edge(units.n_vertices())
        , first_face(first_edge + units.n_raw_lines())
        , first_inside(first_face + (dim == 3 ? units.n_raw_quads() : 0))
        , first_unit(first_inside + units.n_active_cells(), none)
        , owner(first_unit.size(), none)
      {
        for (const auto &unit : units.active_cell_iterators())
          {
            places_of.push_back(numbers_of(unit));
            const unsigned int u = unit->active_cell_index();
            for (const unsigned int i : places_of.back())
              {
                first_unit[i] = std::min(first_unit[i], u);
                owner[i]      = std::min(owner[i], owners[u]);
              }
          }
      }

      /** The process of the nodes at a place of a unit. */
      unsigned int
      owner_of(const unsigned int unit, const unsigned int place) const
      {
        return owner[places_of[unit][place]];
      }

      /** True if the nodes at a place are counted with this unit. */
      bool
      is_first(const unsigned int unit, const unsigned int place) const
      {
        return first_unit[places_of[unit][place]] == unit;
      }

    private:
      std::array<unsigned int, n_places<dim>>
      numbers_of(const CellIterator<dim> &unit) const
      {
        using Info = GeometryInfo<dim>;
        std::array<unsigned int, n_places<dim>> result;
        for (const unsigned int v : Info::vertex_indices())
          result[place_between<dim>(v, v)] = unit->vertex_index(v);
        for (unsigned int e = 0; e < Info::lines_per_cell; ++e)
          result[place_between<dim>(Info::line_to_cell_vertices(e, 0),
                                    Info::line_to_cell_vertices(e, 1))] =
            first_edge + unit->line_index(e);
        if constexpr (dim == 3)
          for (const unsigned int f : Info::face_indices())
            result[place_between<dim>(
              Info::face_to_cell_vertices(f, 0),
              Info::face_to_cell_vertices(f, Info::vertices_per_face - 1))] =
              first_face + unit->face_index(f);
        result[n_places<dim> - 1] = first_inside + unit->active_cell_index();
        return result;
      }

      const unsigned int        first_edge, first_face, first_inside;
      std::vector<unsigned int> first_unit, owner;
      std::vector<std::array<unsigned int, n_places<dim>>> places_of;
    };



    /** The nodes of a refined unit, by their position in steps of its smallest
     * cells. */
    template <int dim>
    class UnitNodes
    {
    public:
      explicit UnitNodes(const unsigned int depth)
        : n_steps(1u << depth)
        , order_of(Utilities::pow(n_steps + 1, dim), none)
      {
        add_below({}, n_steps);
        for (unsigned int place = 0; place < n_places<dim>; ++place)
          n_at_place[place] =
            Utilities::pow(n_steps - 1, dimension_of_place<dim>(place));
      }

      unsigned int
      place(const Lattice<dim> &node) const
      {
        Lattice<dim> end;
        for (unsigned int d = 0; d < dim; ++d)
          end[d] = node[d] == 0 ? 0 : node[d] == n_steps ? 1 : 2;
        return place_of<dim>(end);
      }

      /** The position of a node in the order of the first cell that has it. */
      unsigned int
      order(const Lattice<dim> &node) const
      {
        return order_of[position(node)];
      }

      /** The nodes in the order of the first cell that has them. */
      std::vector<Lattice<dim>> nodes;

      /** Numbers of nodes at each place. */
      std::array<unsigned int, n_places<dim>> n_at_place;

    private:
      unsigned int
      position(const Lattice<dim> &node) const
      {
        unsigned int result = 0;
        for (unsigned int d = dim; d-- > 0;)
          result = (n_steps + 1) * result + node[d];
        return result;
      }

      void
      add_below(const Lattice<dim> &lower_end, const unsigned int size)
      {
        for (unsigned int v = 0; v < (1u << dim); ++v)
          {
            Lattice<dim> corner = lower_end;
            for (unsigned int d = 0; d < dim; ++d)
              corner[d] += ((v >> d) & 1) * (size > 1 ? size / 2 : 1);
            if (size > 1)
              add_below(corner, size / 2);
            else if (unsigned int &order = order_of[position(corner)];
                     order == none)
              {
                order = nodes.size();
                nodes.push_back(corner);
              }
          }
      }

      const unsigned int        n_steps;
      std::vector<unsigned int> order_of;
    };



    /** Call @p visit(cell, lower end, path) for the cells that are so many
     * levels below a unit. The path counts them as if all were there. */
    template <int dim, typename Cell, typename Visitor>
    void
    for_each_real_cell(const Cell         &cell,
                       const unsigned int  levels,
                       const Visitor      &visit,
                       const Lattice<dim> &lower_end = {},
                       const unsigned int  path      = 0)
    {
      if (levels == 0)
        visit(cell, lower_end, path);
      else if (cell->has_children())
        for (unsigned int child = 0; child < (1u << dim); ++child)
          {
            Lattice<dim> corner = lower_end;
            for (unsigned int d = 0; d < dim; ++d)
              corner[d] += ((child >> d) & 1) << (levels - 1);
            for_each_real_cell<dim>(cell->child(child),
                                    levels - 1,
                                    visit,
                                    corner,
                                    (path << dim) + child);
          }
    }



    /** Refine the cells of a level that are in a marked unit, touch one, or
     * touch one of the sides. */
    template <int dim>
    void
    refine_where_needed(const std::set<types::boundary_id> &sides,
                        const std::vector<bool>            &is_marked,
                        const unsigned int                  unit_level,
                        const unsigned int                  level,
                        Triangulation<dim>                 &mesh)
    {
      std::vector<bool> is_needed = vertices_on_sides(mesh, sides);
      for (const auto &cell : mesh.active_cell_iterators_on_level(level))
        {
          CellIterator<dim> unit = cell;
          while (static_cast<unsigned int>(unit->level()) > unit_level)
            unit = unit->parent();
          if (is_marked[unit->index()])
            for (const auto v : cell->vertex_indices())
              is_needed[cell->vertex_index(v)] = true;
        }
      for (const auto &cell : mesh.active_cell_iterators_on_level(level))
        for (const auto v : cell->vertex_indices())
          if (is_needed[cell->vertex_index(v)])
            cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
    }
  } // namespace



  template <int dim>
  UnitRefinement<dim>::UnitRefinement(
    const std::shared_ptr<const Triangulation<dim>>        &units,
    const std::shared_ptr<const std::vector<unsigned int>> &owners,
    const unsigned int                                      depth,
    const unsigned int                                      process,
    const std::set<types::boundary_id>                     &sides)
    : units(units)
    , owners(owners)
    , depth(depth)
    , process(process)
    , sides(sides)
  {
    AssertDimension(owners->size(), units->n_active_cells());
    AssertThrow(units->n_active_cells() ==
                  units->n_cells(units->n_levels() - 1),
                ExcInternalError());
  }



  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  UnitRefinement<dim>::make_mesh() const
  {
    const auto mesh = std::make_shared<Triangulation<dim>>();
    mesh->copy_triangulation(*units);
    const unsigned int unit_level = units->n_levels() - 1;
    std::vector<bool>  is_owned(units->n_raw_cells(unit_level), false);
    for (const auto &unit : units->active_cell_iterators())
      is_owned[unit->index()] =
        ((*owners)[unit->active_cell_index()] == process);
    for (unsigned int l = unit_level; l < level(); ++l)
      refine_where_needed(sides, is_owned, unit_level, l, *mesh);
    return mesh;
  }



  template <int dim>
  unsigned int
  UnitRefinement<dim>::n_cells() const
  {
    return owners->size() << (dim * depth);
  }



  template <int dim>
  std::vector<unsigned int>
  UnitRefinement<dim>::cell_numbers(const Triangulation<dim> &mesh) const
  {
    std::vector<unsigned int> result(mesh.n_active_cells(), none);
    for (const auto &unit : units->active_cell_iterators())
      for_each_real_cell<dim>(
        CellIterator<dim>(&mesh, unit->level(), unit->index()),
        depth,
        [&](const auto &cell, const Lattice<dim> &, const unsigned int path) {
          result[cell->active_cell_index()] =
            (unit->active_cell_index() << (dim * depth)) + path;
        });
    return result;
  }



  template <int dim>
  NodeNumbers
  UnitRefinement<dim>::node_numbers(const DoFHandler<dim> &dofs) const
  {
    const UnitPlaces<dim> places(*units, *owners);
    const UnitNodes<dim>  in_unit(depth);

    NodeNumbers result;
    result.n_owned.resize(1 + *std::max_element(owners->begin(), owners->end()),
                          0);
    result.owner.resize(dofs.n_dofs(), none);
    result.serial.resize(dofs.n_dofs(), numbers::invalid_dof_index);
    result.place.resize(dofs.n_dofs(), numbers::invalid_dof_index);

    std::vector<types::global_dof_index> serial(in_unit.nodes.size()),
      place(in_unit.nodes.size());
    for (const auto &unit : units->active_cell_iterators())
      {
        const unsigned int u    = unit->active_cell_index();
        const auto         cell = typename DoFHandler<dim>::cell_iterator(
          &dofs.get_triangulation(), unit->level(), unit->index(), &dofs);
        if (cell->is_active())
          {
            // None of its nodes are here.
            for (unsigned int i = 0; i < n_places<dim>; ++i)
              if (places.is_first(u, i))
                {
                  result.n_nodes += in_unit.n_at_place[i];
                  result.n_owned[places.owner_of(u, i)] +=
                    in_unit.n_at_place[i];
                }
            continue;
          }
        for (unsigned int k = 0; k < in_unit.nodes.size(); ++k)
          if (const unsigned int i = in_unit.place(in_unit.nodes[k]);
              places.is_first(u, i))
            {
              serial[k] = result.n_nodes++;
              place[k]  = result.n_owned[places.owner_of(u, i)]++;
            }
        for_each_real_cell<dim>(cell,
                                depth,
                                [&](const auto         &real,
                                    const Lattice<dim> &lower_end,
                                    const unsigned int) {
                                  for (const auto v : real->vertex_indices())
                                    {
                                      Lattice<dim> node = lower_end;
                                      for (unsigned int d = 0; d < dim; ++d)
                                        node[d] += (v >> d) & 1;
                                      const unsigned int i =
                                        in_unit.place(node);
                                      if (!places.is_first(u, i))
                                        continue;
                                      const auto dof =
                                        real->vertex_dof_index(v, 0);
                                      const unsigned int k =
                                        in_unit.order(node);
                                      result.owner[dof] = places.owner_of(u, i);
                                      result.serial[dof] = serial[k];
                                      result.place[dof]  = place[k];
                                    }
                                });
      }
    return result;
  }



  template class UnitRefinement<2>;
  template class UnitRefinement<3>;
} // namespace StickSlip
