// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/index_set.h>
#include <stickslip/mesh/mesh_level.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Call @p visit(body, cell, nodes) on each cell, with the nodes to which
     * its degrees of freedom are bound. */
    template <int dim, typename Visitor>
    void
    for_each_cell(const MeshLevel<dim> &level, const Visitor &visit)
    {
      std::vector<types::global_dof_index> dofs, nodes;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const DoFHandler<dim> &dof_handler = level.bodies[b]->dof_handler();
          dofs.resize(dof_handler.get_fe().n_dofs_per_cell());
          for (const auto &cell : dof_handler.active_cell_iterators())
            {
              cell->get_dof_indices(dofs);
              nodes.clear();
              for (const auto dof : dofs)
                for (const auto &entry : level.resolve(b, dof))
                  nodes.push_back(entry.first);
              visit(b, cell, nodes);
            }
        }
    }
  } // namespace



  template <int dim>
  MeshLevel<dim>::MeshLevel(
    const std::vector<std::shared_ptr<const BodyMesh<dim>>> &bodies,
    const std::vector<unsigned int>                         &node_owners,
    const MPI_Comm                                          &communicator)
    : bodies(bodies)
    , first_node{0}
    , global_numbers(node_owners.size())
  {
    for (const auto &body : bodies)
      {
        first_node.push_back(first_node.back() + body->dof_handler().n_dofs());
        surfaces.push_back({{body->surface(BodyMesh<dim>::lower_side),
                             body->surface(BodyMesh<dim>::upper_side)}});
      }
    AssertDimension(first_node.back(), node_owners.size());

    // Number by owner, and keep the order otherwise.
    std::vector<types::global_dof_index> next(
      Utilities::MPI::n_mpi_processes(communicator) + 1, 0);
    for (const unsigned int owner : node_owners)
      ++next[owner + 1];
    for (unsigned int p = 1; p < next.size(); ++p)
      next[p] += next[p - 1];
    IndexSet           owned(n_nodes());
    const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
    owned.add_range(next[me], next[me + 1]);
    for (types::global_dof_index i = 0; i < n_nodes(); ++i)
      global_numbers[i] = next[node_owners[i]]++;

    strip_nodes = find_strip();
    nodes       = NodePartition(owned, find_ghosts(owned), dim, communicator);
  }



  template <int dim>
  IndexSet
  MeshLevel<dim>::find_ghosts(const IndexSet &owned) const
  {
    std::vector<types::global_dof_index> ghosts;
    if (owned.n_elements() < n_nodes())
      for_each_cell(
        *this,
        [&](const unsigned int,
            const auto &,
            const std::vector<types::global_dof_index> &cell_nodes) {
          const auto is_owned = [&](const types::global_dof_index node) {
            return owned.is_element(node);
          };
          if (std::any_of(cell_nodes.begin(), cell_nodes.end(), is_owned))
            std::remove_copy_if(cell_nodes.begin(),
                                cell_nodes.end(),
                                std::back_inserter(ghosts),
                                is_owned);
        });
    return make_index_set(n_nodes(), ghosts);
  }



  template <int dim>
  IndexSet
  MeshLevel<dim>::find_strip() const
  {
    std::vector<types::global_dof_index> strip;
    for_each_cell(
      *this,
      [&](const unsigned int                          body,
          const auto                                 &cell,
          const std::vector<types::global_dof_index> &cell_nodes) {
        if (cell->at_boundary())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                ((body > 0 &&
                  face->boundary_id() == BodyMesh<dim>::lower_side) ||
                 (body + 1 < bodies.size() &&
                  face->boundary_id() == BodyMesh<dim>::upper_side)))
              strip.insert(strip.end(), cell_nodes.begin(), cell_nodes.end());
      });
    return make_index_set(n_nodes(), strip);
  }



  template <int dim>
  types::global_dof_index
  MeshLevel<dim>::n_nodes() const
  {
    return global_numbers.size();
  }



  template <int dim>
  types::global_dof_index
  MeshLevel<dim>::global_node(const unsigned int            body,
                              const types::global_dof_index dof) const
  {
    return global_numbers[first_node[body] + dof];
  }



  template <int dim>
  unsigned int
  MeshLevel<dim>::node(const unsigned int            body,
                       const types::global_dof_index dof) const
  {
    return nodes.local_index(global_node(body, dof));
  }



  template <int dim>
  std::vector<std::pair<types::global_dof_index, double>>
  MeshLevel<dim>::resolve(const unsigned int            body,
                          const types::global_dof_index dof) const
  {
    const auto *masters =
      bodies[body]->bound_nodes().get_constraint_entries(dof);
    if (masters == nullptr)
      return {{global_node(body, dof), 1.}};
    std::vector<std::pair<types::global_dof_index, double>> row;
    for (const auto &master : *masters)
      row.emplace_back(global_node(body, master.first), master.second);
    return row;
  }



  template <int dim>
  const FaultSurface<dim> &
  MeshLevel<dim>::surface(const unsigned int       body,
                          const types::boundary_id side) const
  {
    Assert(side == BodyMesh<dim>::lower_side ||
             side == BodyMesh<dim>::upper_side,
           ExcMessage("Faults are on lower and upper sides."));
    return surfaces[body][side == BodyMesh<dim>::upper_side ? 1 : 0];
  }



  template <int dim>
  const IndexSet &
  MeshLevel<dim>::strip() const
  {
    return strip_nodes;
  }



  template struct MeshLevel<2>;
  template struct MeshLevel<3>;
} // namespace StickSlip
