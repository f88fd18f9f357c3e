// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/fe/fe.h>
#include <deal.II/lac/full_matrix.h>

#include <stickslip/base/questions.h>
#include <stickslip/geometry/place_finder.h>
#include <stickslip/mesh/nodal_prolongation.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** The end of the nodes that each process owns. */
    std::vector<types::global_dof_index>
    ends_of_owned(const NodePartition &nodes)
    {
      std::vector<types::global_dof_index> ends =
        Utilities::MPI::all_gather(nodes.communicator(),
                                   types::global_dof_index(nodes.n_owned()));
      std::partial_sum(ends.begin(), ends.end(), ends.begin());
      return ends;
    }



    /**
     * The rows of one body. Trees of a fine and a coarse mesh are walked
     * together; below an active coarse cell, @p values holds the coarse cell's
     * basis functions at the vertices of the current fine cell.
     */
    template <int dim>
    class BodyRows
    {
    public:
      BodyRows(const MeshLevel<dim>   &coarse,
               const MeshLevel<dim>   &fine,
               const unsigned int      body,
               const IndexSet         &wanted,
               std::vector<GlobalRow> &rows)
        : coarse(coarse)
        , fine(fine)
        , body(body)
        , wanted(wanted)
        , rows(rows)
        , coarse_dofs(coarse.bodies[body]->dof_handler().get_fe().dofs_per_cell)
        , fine_dofs(coarse_dofs.size())
      {}

      void
      make()
      {
        if (!coarse.bodies[body]->is_nested_with(*fine.bodies[body]))
          {
            from_places();
            return;
          }
        if (coarse.bodies[body] != fine.bodies[body] &&
            !fine.bodies[body]->vertex_parents().empty())
          {
            from_edges();
            return;
          }
        auto coarse_cell = coarse.bodies[body]->dof_handler().begin(0);
        const DoFHandler<dim> &fine_dof_handler =
          fine.bodies[body]->dof_handler();
        for (auto fine_cell = fine_dof_handler.begin(0);
             fine_cell != fine_dof_handler.end(0);
             ++fine_cell, ++coarse_cell)
          both(fine_cell, coarse_cell);
      }

    private:
      using Cell = typename DoFHandler<dim>::cell_iterator;

      /** Nodes of meshes that are no trees. None of them are bound. */
      void
      from_edges()
      {
        const auto &parents = fine.bodies[body]->vertex_parents();
        const std::vector<types::global_dof_index> coarse_node =
          nodes_of_vertices(coarse);
        for (const auto &cell :
             fine.bodies[body]->dof_handler().active_cell_iterators())
          for (const auto v : cell->vertex_indices())
            {
              const types::global_dof_index node =
                fine.global_node(body, cell->vertex_dof_index(v, 0));
              if (!wanted.is_element(node))
                continue;
              GlobalRow &row = rows[wanted.index_within_set(node)];
              if (!row.empty())
                continue;
              const auto &[a, b] = parents[cell->vertex_index(v)];
              if (a == b)
                row.emplace_back(coarse_node[a], 1.);
              else
                for (const unsigned int end : {a, b})
                  row.emplace_back(coarse_node[end], 0.5);
            }
      }

      /** Global numbers of the nodes at the vertices of a mesh without bound
       * nodes. */
      std::vector<types::global_dof_index>
      nodes_of_vertices(const MeshLevel<dim> &level) const
      {
        std::vector<types::global_dof_index> nodes =
          level.bodies[body]->dofs_of_vertices();
        for (types::global_dof_index &node : nodes)
          if (node != numbers::invalid_dof_index)
            node = level.global_node(body, node);
        return nodes;
      }

      /** Nodes in the cells of a mesh that is not nested; those on a side in
       * the faces of that side, so that both sides of a fault stay apart, and
       * points outside of a curved one are next to it. None are bound. */
      void
      from_places()
      {
        const Triangulation<dim> &coarse_mesh =
          coarse.bodies[body]->triangulation();
        const Triangulation<dim> &fine_mesh =
          fine.bodies[body]->triangulation();
        const std::vector<types::global_dof_index> coarse_node =
                                                     nodes_of_vertices(coarse),
                                                   fine_node =
                                                     nodes_of_vertices(fine);

        using Place = typename PlaceFinder<dim>::Place;
        std::map<unsigned int, Place> places;
        for (const types::boundary_id side : coarse_mesh.get_boundary_ids())
          {
            const PlaceFinder<dim> finder(coarse_mesh, side);
            for (const auto &face : fine_mesh.active_face_iterators())
              if (face->at_boundary() && face->boundary_id() == side)
                for (unsigned int v = 0; v < face->n_vertices(); ++v)
                  {
                    const Place place = finder.find(face->vertex(v));
                    const auto [so_far, is_new] =
                      places.emplace(face->vertex_index(v), place);
                    if (!is_new && place.distance < so_far->second.distance)
                      so_far->second = place;
                  }
          }
        const PlaceFinder<dim> finder(coarse_mesh);
        for (unsigned int v = 0; v < fine_mesh.n_vertices(); ++v)
          {
            if (!wanted.is_element(fine_node[v]))
              continue;
            const auto  known = places.find(v);
            const Place place = known != places.end() ?
                                  known->second :
                                  finder.find(fine_mesh.get_vertices()[v]);
            GlobalRow  &row   = rows[wanted.index_within_set(fine_node[v])];
            for (const auto &[vertex, value] : place.values)
              row.emplace_back(coarse_node[vertex], value);
          }
      }

      void
      both(const Cell &fine_cell, const Cell &coarse_cell)
      {
        if (coarse_cell->is_active())
          {
            if (!coarse.bodies[body]->is_real(coarse_cell))
              return;
            coarse_cell->get_dof_indices(coarse_dofs);
            below(fine_cell, IdentityMatrix(coarse_dofs.size()));
          }
        else if (fine_cell->has_children())
          for (unsigned int child = 0; child < fine_cell->n_children(); ++child)
            both(fine_cell->child(child), coarse_cell->child(child));
      }

      void
      below(const Cell &fine_cell, const FullMatrix<double> &values)
      {
        if (fine_cell->is_active())
          {
            fine_cell->get_dof_indices(fine_dofs);
            for (unsigned int i = 0; i < fine_dofs.size(); ++i)
              set_row(fine_dofs[i], values, i);
            return;
          }
        for (unsigned int child = 0; child < fine_cell->n_children(); ++child)
          {
            FullMatrix<double> product(values.m(), values.n());
            fine.bodies[body]
              ->dof_handler()
              .get_fe()
              .get_prolongation_matrix(child, fine_cell->refinement_case())
              .mmult(product, values);
            below(fine_cell->child(child), product);
          }
      }

      void
      set_row(const types::global_dof_index fine_dof,
              const FullMatrix<double>     &values,
              const unsigned int            i)
      {
        const types::global_dof_index node = fine.global_node(body, fine_dof);
        if (!wanted.is_element(node) ||
            fine.bodies[body]->bound_nodes().is_constrained(fine_dof))
          return;
        GlobalRow &row = rows[wanted.index_within_set(node)];
        if (!row.empty())
          return;
        for (unsigned int j = 0; j < coarse_dofs.size(); ++j)
          if (const double value = values(i, j))
            for (const auto &master : coarse.resolve(body, coarse_dofs[j]))
              {
                AssertThrow(master.first != numbers::invalid_dof_index,
                            ExcInternalError());
                row.emplace_back(master.first, value * master.second);
              }
      }

      const MeshLevel<dim>                &coarse;
      const MeshLevel<dim>                &fine;
      const unsigned int                   body;
      const IndexSet                      &wanted;
      std::vector<GlobalRow>              &rows;
      std::vector<types::global_dof_index> coarse_dofs, fine_dofs;
    };
  } // namespace



  template <int dim>
  NodalProlongation::NodalProlongation(const MeshLevel<dim> &coarse,
                                       const MeshLevel<dim> &fine)
    : fine_nodes(fine.nodes.owned())
  {
    std::vector<GlobalRow> found(fine_nodes.n_elements());
    for (unsigned int body = 0; body < fine.bodies.size(); ++body)
      BodyRows<dim>(coarse, fine, body, fine_nodes, found).make();
    for (const GlobalRow &row : found)
      rows.add_row(row);
    rows.close();
  }



  NodalProlongation::NodalProlongation(const NodalProlongation &own_rows,
                                       const NodePartition     &fine,
                                       const IndexSet          &wanted)
    : own_rows(&own_rows)
    , fine_nodes(wanted)
  {
    fine_nodes.subtract_set(fine.owned());
    using Nodes = std::vector<types::global_dof_index>;
    const std::vector<types::global_dof_index> ends = ends_of_owned(fine);
    std::map<unsigned int, Nodes>              asked_for;
    for (const types::global_dof_index node : fine_nodes)
      asked_for[std::upper_bound(ends.begin(), ends.end(), node) - ends.begin()]
        .push_back(node);

    // A row is its size, and numbers of nodes and values in turn.
    const auto rows_of = [&](const Nodes &nodes) {
      std::vector<double> message;
      for (const types::global_dof_index node : nodes)
        {
          const GlobalRow its = own_rows.row(node);
          message.push_back(its.size());
          for (const auto &entry : its)
            message.insert(message.end(), {double(entry.first), entry.second});
        }
      return message;
    };
    // Nodes of an owner follow each other.
    for (const auto &[process, message] :
         ask(asked_for, rows_of, fine.communicator()))
      for (auto next = message.begin(); next != message.end();)
        {
          for (unsigned int n = *next++; n > 0; --n, next += 2)
            rows.add_entry(*next, *(next + 1));
          rows.end_row();
        }
    rows.close();
  }



  GlobalRow
  NodalProlongation::row(const types::global_dof_index fine_node) const
  {
    if (own_rows != nullptr && own_rows->fine_nodes.is_element(fine_node))
      return own_rows->row(fine_node);
    AssertThrow(fine_nodes.is_element(fine_node), ExcInternalError());
    const auto its = rows[fine_nodes.index_within_set(fine_node)];
    return GlobalRow(its.begin(), its.end());
  }



  template NodalProlongation::NodalProlongation(const MeshLevel<2> &,
                                                const MeshLevel<2> &);
  template NodalProlongation::NodalProlongation(const MeshLevel<3> &,
                                                const MeshLevel<3> &);
} // namespace StickSlip
