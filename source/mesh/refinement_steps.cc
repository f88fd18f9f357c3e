// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/geometry_info.h>

#include <stickslip/mesh/refinement_steps.h>
#include <stickslip/mesh/vertices_on_sides.h>

#include <bitset>
#include <map>

namespace StickSlip
{
  namespace
  {
    /**
     * The corners, edges, faces and the inside of a cell that are on a fault:
     * place 3^d times e, summed up over the axes d, with e = 0 at the lower
     * end of the cell, 1 at the upper one, 2 between them.
     */
    template <int dim>
    using Contact = std::bitset<dim == 2 ? 9 : 27>;



    /** The place in its parent that a place of a child lies in. */
    template <int dim>
    unsigned int
    place_in_parent(unsigned int place, const unsigned int child)
    {
      unsigned int result = 0;
      for (unsigned int d = 0, power = 1; d < dim; ++d, power *= 3, place /= 3)
        {
          const unsigned int end = place % 3, half = (child >> d) & 1;
          result += power * (end == half ? end : 2);
        }
      return result;
    }



    template <int dim>
    Contact<dim>
    contact_of_child(const Contact<dim> &contact, const unsigned int child)
    {
      Contact<dim> result;
      for (unsigned int place = 0; place < result.size(); ++place)
        result[place] = contact[place_in_parent<dim>(place, child)];
      return result;
    }



    /** The place of the corner @p v of a cell, or of what is between it and the
     * corner @p w. */
    template <int dim>
    unsigned int
    place_between(const unsigned int v, const unsigned int w)
    {
      unsigned int result = 0;
      for (unsigned int d = 0, power = 1; d < dim; ++d, power *= 3)
        {
          const unsigned int end = (v >> d) & 1;
          result += power * (end == ((w >> d) & 1) ? end : 2);
        }
      return result;
    }



    template <int dim>
    bool
    touches(const Contact<dim> &contact)
    {
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        if (contact[place_between<dim>(v, v)])
          return true;
      return false;
    }



    /** The numbers of cells below one, by its contact and level. */
    template <int dim>
    class CellCount
    {
    public:
      explicit CellCount(const RefinementSteps &steps)
        : steps(steps)
      {}

      unsigned int
      below(const Contact<dim> &contact, const unsigned int level)
      {
        const bool touches_fault = touches<dim>(contact);
        if (steps.ends_at(level, touches_fault))
          return 1;
        if (!touches_fault)
          return 1u << (dim * (steps.uniform - level));
        const auto [known, is_new] =
          counts.emplace(std::make_pair(contact.to_ulong(), level), 0);
        if (is_new)
          for (const unsigned int child : GeometryInfo<dim>::vertex_indices())
            known->second +=
              below(contact_of_child<dim>(contact, child), level + 1);
        return known->second;
      }

    private:
      const RefinementSteps                                          steps;
      std::map<std::pair<unsigned long, unsigned int>, unsigned int> counts;
    };



    /** For each line of a mesh, if it is on one of the sides. */
    template <int dim>
    std::vector<bool>
    lines_on_sides(const Triangulation<dim>           &mesh,
                   const std::set<types::boundary_id> &sides)
    {
      std::vector<bool> result(mesh.n_raw_lines(), false);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
          {
            if constexpr (dim == 2)
              result[face->index()] = true;
            else
              for (unsigned int l = 0; l < face->n_lines(); ++l)
                result[face->line_index(l)] = true;
          }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  count_finest_cells(const Triangulation<dim>           &mesh,
                     const std::set<types::boundary_id> &at_faults,
                     const RefinementSteps              &steps)
  {
    using Info = GeometryInfo<dim>;
    std::vector<unsigned int> result;
    if (steps.at_faults == 0)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          result.push_back(1u << (dim * (steps.uniform - cell->level())));
        return result;
      }
    const std::vector<bool> vertex_is_there =
                              vertices_on_sides(mesh, at_faults),
                            line_is_there = lines_on_sides(mesh, at_faults);
    CellCount<dim> count(steps);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        Contact<dim> contact;
        for (const unsigned int v : Info::vertex_indices())
          contact[place_between<dim>(v, v)] =
            vertex_is_there[cell->vertex_index(v)];
        for (unsigned int e = 0; e < Info::lines_per_cell; ++e)
          contact[place_between<dim>(Info::line_to_cell_vertices(e, 0),
                                     Info::line_to_cell_vertices(e, 1))] =
            line_is_there[cell->line_index(e)];
        if constexpr (dim == 3)
          for (const unsigned int f : Info::face_indices())
            contact[place_between<dim>(
              Info::face_to_cell_vertices(f, 0),
              Info::face_to_cell_vertices(f, Info::vertices_per_face - 1))] =
              cell->at_boundary(f) &&
              at_faults.count(cell->face(f)->boundary_id()) > 0;
        result.push_back(count.below(contact, cell->level()));
      }
    return result;
  }



  template decltype(count_finest_cells<2>) count_finest_cells<2>;
  template decltype(count_finest_cells<3>) count_finest_cells<3>;
} // namespace StickSlip
