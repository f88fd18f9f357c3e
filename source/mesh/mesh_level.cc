// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/index_set.h>
#include <stickslip/base/checksum.h>
#include <stickslip/base/input_error.h>
#include <stickslip/base/make_set.h>
#include <stickslip/mesh/mesh_level.h>
#include <stickslip/mesh/vertices_on_sides.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** Call @p visit(body, cells, nodes) on each patch of real cells, with the
     * nodes to which their degrees of freedom are bound. */
    template <int dim, typename Visitor>
    void
    for_each_patch(const MeshLevel<dim> &level, const Visitor &visit)
    {
      std::vector<types::global_dof_index> dofs, nodes;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const DoFHandler<dim> &dof_handler = level.bodies[b]->dof_handler();
          dofs.resize(dof_handler.get_fe().n_dofs_per_cell());
          level.bodies[b]->patches().for_each(
            dof_handler, [&](const auto &cells) {
              // Cells of a patch are of one level of refinement.
              if (!level.bodies[b]->is_real(cells.front()))
                return;
              nodes.clear();
              for (const auto &cell : cells)
                {
                  cell->get_dof_indices(dofs);
                  for (const auto dof : dofs)
                    for (const auto &entry : level.resolve(b, dof))
                      nodes.push_back(entry.first);
                }
              visit(b, cells, nodes);
            });
        }
    }


    /** True if a vertex of one of the cells has such a node, whatever that is
     * bound to. */
    template <int dim, typename Cells, typename Predicate>
    bool
    has_node(const MeshLevel<dim> &level,
             const unsigned int    body,
             const Cells          &cells,
             const Predicate      &predicate)
    {
      for (const auto &cell : cells)
        for (const auto v : cell->vertex_indices())
          if (predicate(level.global_node(body, cell->vertex_dof_index(v, 0))))
            return true;
      return false;
    }



    /** For the active cells of each body, if MeshLevel::keep_own_cells() keeps
     * them. */
    template <int dim>
    std::vector<std::vector<bool>>
    find_kept_cells(const MeshLevel<dim> &level)
    {
      std::vector<std::vector<bool>> is_kept, is_on_kept_side;
      for (const auto &body : level.bodies)
        {
          is_kept.emplace_back(body->triangulation().n_active_cells(), false);
          is_on_kept_side.push_back(body->vertices_on_kept_sides());
        }
      std::vector<types::global_dof_index> masters;
      std::vector<unsigned int>            first_real(level.bodies.size(),
                                           numbers::invalid_unsigned_int);
      const auto is_owned = [&](const types::global_dof_index node) {
        return level.nodes.owned().is_element(node);
      };
      for_each_patch(
        level,
        [&](const unsigned int                          b,
            const auto                                 &cells,
            const std::vector<types::global_dof_index> &its_nodes) {
          const BodyMesh<dim> &body = *level.bodies[b];
          first_real[b] =
            std::min(first_real[b], cells.front()->active_cell_index());
          // Hanging nodes are not among those that they are bound to.
          const bool is_wanted =
            std::any_of(its_nodes.begin(), its_nodes.end(), is_owned) ||
            has_node(level, b, cells, is_owned);
          for (const auto &cell : cells)
            is_kept[b][cell->active_cell_index()] =
              is_wanted || body.is_rigid() ||
              has_marked_vertex<dim>(cell, is_on_kept_side[b]);
          if (!is_wanted || body.lateral_period().norm() == 0.)
            return;
          for (const auto &cell : cells)
            for (const auto v : cell->vertex_indices())
              if (const auto dof = cell->vertex_dof_index(v, 0);
                  body.bound_nodes().is_constrained(dof))
                for (const auto &master : level.resolve(b, dof))
                  masters.push_back(master.first);
        });

      // Images at one end of a body name nodes at the other.
      make_set(masters);
      const auto is_master = [&](const types::global_dof_index node) {
        return std::binary_search(masters.begin(), masters.end(), node);
      };
      if (!masters.empty())
        for_each_patch(
          level, [&](const unsigned int b, const auto &cells, const auto &) {
            if (has_node(level, b, cells, is_master))
              for (const auto &cell : cells)
                is_kept[b][cell->active_cell_index()] = true;
          });

      // No mesh is empty.
      for (unsigned int b = 0; b < is_kept.size(); ++b)
        if (std::find(is_kept[b].begin(), is_kept[b].end(), true) ==
            is_kept[b].end())
          is_kept[b][first_real[b]] = true;
      return is_kept;
    }
  } // namespace



  template <int dim>
  MeshLevel<dim>::MeshLevel(const BodyMeshes<dim>          &bodies,
                            const FaultTopology            &topology,
                            const std::vector<NodeNumbers> &of_bodies,
                            const MPI_Comm                 &communicator,
                            const unsigned int              n_components)
    : bodies(bodies)
    , first_node{0}
    , first_serial_node{0}
    , first_serial_cell{0}
  {
    AssertDimension(of_bodies.size(), bodies.size());
    const unsigned int n_processes =
      Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int me = Utilities::MPI::this_mpi_process(communicator);

    // Number by owner, and keep the order otherwise.
    std::vector<types::global_dof_index> next(n_processes + 1, 0);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        first_node.push_back(first_node.back() + of_bodies[b].owner.size());
        first_serial_node.push_back(first_serial_node.back() +
                                    of_bodies[b].n_nodes);
        first_serial_cell.push_back(first_serial_cell.back() +
                                    bodies[b]->n_cells());
        for (unsigned int p = 0; p < of_bodies[b].n_owned.size(); ++p)
          next[p + 1] += of_bodies[b].n_owned[p];
      }
    for (unsigned int p = 1; p < next.size(); ++p)
      next[p] += next[p - 1];
    IndexSet owned(n_nodes());
    owned.add_range(next[me], next[me + 1]);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const NodeNumbers                   &its = of_bodies[b];
        std::vector<types::global_dof_index> own_serial;
        if (me < its.n_owned.size())
          own_serial.resize(its.n_owned[me], numbers::invalid_dof_index);
        for (types::global_dof_index i = 0; i < its.owner.size(); ++i)
          if (its.owner[i] == numbers::invalid_unsigned_int)
            global_numbers.push_back(numbers::invalid_dof_index);
          else
            {
              global_numbers.push_back(next[its.owner[i]] + its.place[i]);
              if (its.owner[i] == me)
                own_serial[its.place[i]] = first_serial_node[b] + its.serial[i];
            }
        serial_nodes.insert(serial_nodes.end(),
                            own_serial.begin(),
                            own_serial.end());
        for (unsigned int p = 0; p < its.n_owned.size(); ++p)
          next[p] += its.n_owned[p];
      }
    AssertThrow(std::count(serial_nodes.begin(),
                           serial_nodes.end(),
                           numbers::invalid_dof_index) == 0,
                ExcInternalError());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const auto &line : bodies[b]->bound_nodes().get_lines())
        {
          GlobalRow &row = bound_rows[first_node[b] + line.index];
          for (const auto &master : line.entries)
            row.emplace_back(global_node(b, master.first), master.second);
        }

    for (const Fault &fault : topology.faults())
      {
        surfaces.push_back({{join(fault.sides[0], communicator),
                             join(fault.sides[1], communicator)}});
        for (const FaultSurface<dim> &surface : surfaces.back())
          if (surface.faces.empty())
            throw InputError("A side of the fault '" + fault.name +
                             "' has no faces.");
      }
    nodes =
      NodePartition(owned, find_ghosts(owned), n_components, communicator);
  }



  template <int dim>
  IndexSet
  MeshLevel<dim>::find_ghosts(const IndexSet &owned) const
  {
    std::vector<types::global_dof_index> ghosts;
    if (owned.n_elements() < n_nodes())
      for_each_patch(
        *this,
        [&](const unsigned int,
            const auto &,
            const std::vector<types::global_dof_index> &its_nodes) {
          const auto is_owned = [&](const types::global_dof_index node) {
            return owned.is_element(node);
          };
          if (std::any_of(its_nodes.begin(), its_nodes.end(), is_owned))
            std::remove_copy_if(its_nodes.begin(),
                                its_nodes.end(),
                                std::back_inserter(ghosts),
                                is_owned);
        });
    return make_index_set(n_nodes(), ghosts);
  }



  template <int dim>
  FaultSurface<dim>
  MeshLevel<dim>::whole_part(const BodySide &part,
                             const MPI_Comm &communicator) const
  {
    const BodyMesh<dim> &body = *bodies[part.body];
    if (body.numbers_in_units() == nullptr)
      {
        FaultSurface<dim> surface = body.surface(part.side);
        for (types::global_dof_index &node : surface.nodes)
          node = global_node(part.body, node);
        return surface;
      }

    constexpr auto      no_node = numbers::invalid_dof_index;
    std::vector<double> numbers_and_places;
    for (const SideFace<dim> &face : body.faces_on_side(part.side))
      {
        for (unsigned int v = 0; v < face.nodes.size(); ++v)
          {
            const types::global_dof_index dof = face.nodes[v];
            numbers_and_places.push_back(dof == no_node ? no_node :
                                                          body.whole_dof(dof));
            numbers_and_places.push_back(
              dof == no_node ? no_node : global_node(part.body, dof));
            for (unsigned int d = 0; d < dim; ++d)
              numbers_and_places.push_back(face.positions[v][d]);
            for (const int wrap : face.wraps[v])
              numbers_and_places.push_back(wrap);
          }
        for (unsigned int d = 0; d < dim; ++d)
          numbers_and_places.push_back(face.outward[d]);
      }
    std::vector<SideFace<dim>>                                           faces;
    std::unordered_map<types::global_dof_index, types::global_dof_index> number;
    for (const std::vector<double> &its :
         Utilities::MPI::all_gather(communicator, numbers_and_places))
      for (auto entry = its.begin(); entry != its.end();)
        {
          faces.emplace_back();
          SideFace<dim> &face = faces.back();
          for (unsigned int v = 0; v < face.nodes.size(); ++v)
            {
              face.nodes[v]         = *entry++;
              number[face.nodes[v]] = *entry++;
              for (unsigned int d = 0; d < dim; ++d)
                face.positions[v][d] = *entry++;
              for (int &wrap : face.wraps[v])
                wrap = *entry++;
            }
          for (unsigned int d = 0; d < dim; ++d)
            face.outward[d] = *entry++;
        }
    FaultSurface<dim> surface =
      surface_of_faces<dim>(faces, body.lateral_period());
    for (types::global_dof_index &node : surface.nodes)
      node = number[node];
    return surface;
  }



  template <int dim>
  FaultSurface<dim>
  MeshLevel<dim>::join(const std::vector<BodySide> &parts,
                       const MPI_Comm              &communicator) const
  {
    FaultSurface<dim>                               result;
    std::map<types::global_dof_index, unsigned int> places;
    std::vector<Tensor<1, dim>>                     face_areas;
    for (const BodySide &part : parts)
      {
        FaultSurface<dim> surface = whole_part(part, communicator);
        // Parts on the same body may have nodes in common.
        std::vector<unsigned int> place_of;
        for (unsigned int k = 0; k < surface.nodes.size(); ++k)
          {
            const auto node = surface.nodes[k];
            const auto [place, is_new] =
              places.emplace(node, result.nodes.size());
            place_of.push_back(place->second);
            if (!is_new)
              continue;
            result.nodes.push_back(node);
            result.points.push_back(surface.points[k]);
          }
        for (unsigned int f = 0; f < surface.faces.size(); ++f)
          {
            // Sizes only weight the mean of the normals here.
            face_areas.push_back(surface.face_size(f) * surface.normal_of(f));
            for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
              surface.faces[f][v] = place_of[surface.faces[f][v]];
            result.faces.push_back(surface.faces[f]);
          }
        result.wraps.insert(result.wraps.end(),
                            surface.wraps.begin(),
                            surface.wraps.end());
        result.period = surface.period;
      }
    result.nodes.shrink_to_fit();
    result.points.shrink_to_fit();
    result.faces.shrink_to_fit();
    result.set_normals(face_areas);
    return result;
  }



  template <int dim>
  std::uint32_t
  MeshLevel<dim>::checksum() const
  {
    // A sum, which no order and no partition changes.
    std::uint32_t sum = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const std::vector<Point<dim>> positions = bodies[b]->node_positions();
        for (types::global_dof_index dof = 0; dof < positions.size(); ++dof)
          if (nodes.owned().is_element(global_node(b, dof)))
            {
              const std::uint64_t number = serial_node(b, dof);
              sum += crc32(&number,
                           sizeof(number),
                           crc32(&positions[dof], sizeof(Point<dim>)));
            }
      }
    return Utilities::MPI::sum(sum, nodes.communicator());
  }



  template <int dim>
  void
  MeshLevel<dim>::keep_own_cells()
  {
    const std::vector<std::vector<bool>> is_kept = find_kept_cells(*this);
    std::vector<types::global_dof_index> first   = {0}, numbers;
    std::unordered_map<types::global_dof_index, GlobalRow> rows;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        std::vector<types::global_dof_index> dofs_before;
        const auto part = std::make_shared<const BodyMesh<dim>>(*bodies[b],
                                                                is_kept[b],
                                                                &dofs_before);
        for (types::global_dof_index dof = 0; dof < dofs_before.size(); ++dof)
          {
            const types::global_dof_index whole =
              first_node[b] + dofs_before[dof];
            if (const auto row = bound_rows.find(whole);
                row != bound_rows.end())
              rows.emplace(first.back() + dof, std::move(row->second));
            numbers.push_back(global_numbers[whole]);
          }
        bodies[b] = part;
        first.push_back(first.back() + dofs_before.size());
      }
    numbers.shrink_to_fit();
    first_node     = std::move(first);
    global_numbers = std::move(numbers);
    bound_rows     = std::move(rows);
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
  GlobalRow
  MeshLevel<dim>::resolve(const unsigned int            body,
                          const types::global_dof_index dof) const
  {
    if (!bodies[body]->bound_nodes().is_constrained(dof))
      return {{global_node(body, dof), 1.}};
    return bound_rows.at(first_node[body] + dof);
  }



  template <int dim>
  const FaultSurface<dim> &
  MeshLevel<dim>::surface(const unsigned int fault,
                          const unsigned int side) const
  {
    AssertIndexRange(fault, surfaces.size());
    AssertIndexRange(side, 2);
    return surfaces[fault][side];
  }



  template struct MeshLevel<2>;
  template struct MeshLevel<3>;
} // namespace StickSlip
