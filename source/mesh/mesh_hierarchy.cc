// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/index_set.h>
#include <stickslip/base/freed_memory.h>
#include <stickslip/base/input_error.h>
#include <stickslip/mesh/cell_partition.h>
#include <stickslip/mesh/coarsening.h>
#include <stickslip/mesh/divided_meshes.h>
#include <stickslip/mesh/fault_places.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The process of each node of a body from those of the vertices of its
     * mesh. */
    template <int dim>
    std::vector<unsigned int>
    node_owners(const BodyMesh<dim>             &body,
                const std::vector<unsigned int> &vertex_owners)
    {
      std::vector<unsigned int> owners(body.dof_handler().n_dofs());
      const auto                dofs = body.dofs_of_vertices();
      for (unsigned int v = 0; v < dofs.size(); ++v)
        if (dofs[v] != numbers::invalid_dof_index)
          owners[dofs[v]] = vertex_owners[v];
      return owners;
    }



    /** The number of nodes of all bodies. */
    template <int dim>
    std::size_t
    n_nodes(const BodyMeshes<dim> &bodies)
    {
      std::size_t n = 0;
      for (const auto &body : bodies)
        n += body->n_vertices();
      return n;
    }



    /**
     * Gather the nodes of neighbouring processes on one where there are too
     * few for all. The numbers of neighbouring parts are close to each other.
     * It is the last of them, since borders belong to those before.
     */
    void
    gather(std::vector<unsigned int> &owners,
           const unsigned int         n_processes,
           const unsigned int         n_sharing)
    {
      for (unsigned int &owner : owners)
        {
          const unsigned int group = owner * n_sharing / n_processes;
          // The first process of the next group.
          const unsigned int end =
            ((group + 1) * n_processes + n_sharing - 1) / n_sharing;
          owner = end - 1;
        }
    }



    /** Sides that are plane must lie in one plane and face each other. */
    template <int dim>
    void
    check_plane_sides(const MeshLevel<dim> &level,
                      const FaultTopology  &topology)
    {
      for (unsigned int f = 0; f < topology.faults().size(); ++f)
        {
          const FaultSurface<dim> &first  = level.surface(f, 0);
          const FaultSurface<dim> &second = level.surface(f, 1);
          if (first.is_plane() && second.is_plane() &&
              (first.normal * second.normal > -0.99 ||
               (!topology.faults()[f].may_be_apart &&
                std::abs((second.points[0] - first.points[0]) * first.normal) >
                  1e-6 * first.face_size(0))))
            throw InputError("The two sides of the fault '" +
                             topology.faults()[f].name +
                             "' do not face each other in one plane.");
        }
    }



    /** The places on the surfaces of a level of the nodes of those of the next
     * coarser one, for both sides of each fault. Collective. */
    template <int dim>
    std::vector<std::array<std::vector<unsigned int>, 2>>
    places_on_surfaces(const MeshLevel<dim>    &coarse,
                       const MeshLevel<dim>    &fine,
                       const NodalProlongation &own_rows,
                       const unsigned int       n_faults)
    {
      std::vector<types::global_dof_index> nodes;
      for (unsigned int f = 0; f < n_faults; ++f)
        for (const unsigned int side : {0, 1})
          nodes.insert(nodes.end(),
                       fine.surface(f, side).nodes.begin(),
                       fine.surface(f, side).nodes.end());
      const NodalProlongation prolongation(
        own_rows, fine.nodes, make_index_set(fine.n_nodes(), nodes));
      std::vector<std::array<std::vector<unsigned int>, 2>> result(n_faults);
      for (unsigned int f = 0; f < n_faults; ++f)
        for (const unsigned int side : {0, 1})
          result[f][side] = places_on_finer(coarse.surface(f, side),
                                            fine.surface(f, side),
                                            prolongation);
      return result;
    }



    /** Numbers of the nodes of all bodies, level by level from the finest
     * down, from the processes of the cells that have been divided. */
    template <int dim>
    class NodeNumbering
    {
    public:
      NodeNumbering(
        const BodyMeshes<dim> &divided,
        const std::vector<std::shared_ptr<const std::vector<unsigned int>>>
                          &owners_of_cells,
        const unsigned int n_processes)
        : divided(divided)
        , owners_of_cells(owners_of_cells)
        , owners_of_vertices(divided.size())
        , n_processes(n_processes)
      {}

      /** The numbers on the level of @p bodies, which so many processes share;
       * that of @p finer ones came before. */
      std::vector<NodeNumbers>
      next_level(const BodyMeshes<dim> &bodies,
                 const BodyMeshes<dim> &finer,
                 const unsigned int     n_sharing)
      {
        std::vector<NodeNumbers> numbers;
        for (unsigned int i = 0; i < bodies.size(); ++i)
          {
            const BodyMesh<dim> &mesh = *bodies[i];
            if (const NodeNumbers *in_units = mesh.numbers_in_units())
              {
                AssertThrow(n_sharing == n_processes, ExcInternalError());
                numbers.push_back(*in_units);
                continue;
              }
            if (bodies[i] == divided[i])
              {
                owners_of_vertices[i] =
                  vertex_owners<dim>(mesh, *owners_of_cells[i]);
                divided[i].reset();
              }
            else
              owners_of_vertices[i] =
                inherited_vertex_owners<dim>(mesh,
                                             *finer[i],
                                             owners_of_vertices[i]);
            std::vector<unsigned int> owners =
              node_owners<dim>(mesh, owners_of_vertices[i]);
            if (n_sharing < n_processes)
              gather(owners, n_processes, n_sharing);
            numbers.push_back(number_whole_mesh(owners, n_processes));
          }
        return numbers;
      }

    private:
      /** The meshes whose cells have been divided, until their level. */
      BodyMeshes<dim> divided;
      std::vector<std::shared_ptr<const std::vector<unsigned int>>>
                                             owners_of_cells;
      std::vector<std::vector<unsigned int>> owners_of_vertices;
      const unsigned int                     n_processes;
    };



    template <int dim>
    std::vector<CoarseBody<dim>>
    coarse_bricks(const std::vector<BodyGeometry<dim>> &geometries)
    {
      std::vector<CoarseBody<dim>> result;
      for (const BodyGeometry<dim> &geometry : geometries)
        result.push_back(coarse_brick(geometry));
      return result;
    }



    std::vector<std::string>
    numbers_from_one(const unsigned int n)
    {
      std::vector<std::string> result;
      for (unsigned int i = 0; i < n; ++i)
        result.push_back(std::to_string(i + 1));
      return result;
    }
  } // namespace



  template <int dim>
  MeshHierarchy<dim>::MeshHierarchy(
    const std::vector<BodyGeometry<dim>> &bodies,
    const MPI_Comm                       &communicator,
    const unsigned int                    min_nodes_per_process)
    : MeshHierarchy(bodies,
                    stack_topology<dim>(numbers_from_one(bodies.size()),
                                        numbers_from_one(bodies.size() - 1)),
                    communicator,
                    min_nodes_per_process)
  {}



  template <int dim>
  MeshHierarchy<dim>::MeshHierarchy(
    const std::vector<BodyGeometry<dim>> &bodies,
    const FaultTopology                  &topology,
    const MPI_Comm                       &communicator,
    const unsigned int                    min_nodes_per_process)
    : MeshHierarchy(coarse_bricks(bodies),
                    topology,
                    communicator,
                    min_nodes_per_process)
  {}



  template <int dim>
  MeshHierarchy<dim>::MeshHierarchy(
    const std::vector<CoarseBody<dim>> &coarse_bodies,
    const FaultTopology                &topology,
    const MPI_Comm                     &communicator,
    const unsigned int                  min_nodes_per_process,
    const unsigned int                  n_components)
    : faults(topology)
  {
    AssertDimension(coarse_bodies.size(), topology.body_names().size());
    const unsigned int n_processes =
      Utilities::MPI::n_mpi_processes(communicator);

    DividedMeshes<dim> divided(coarse_bodies,
                               topology,
                               n_processes == 1 ?
                                 std::numeric_limits<std::size_t>::max() :
                                 std::size_t(min_nodes_per_process) *
                                   std::max(n_processes, least_units));
    std::vector<std::shared_ptr<const std::vector<unsigned int>>>
      owners_of_cells;
    for (auto &owners : partition_cells<dim>(
           divided.meshes, topology, n_processes, divided.n_finest))
      owners_of_cells.push_back(
        std::make_shared<const std::vector<unsigned int>>(std::move(owners)));

    BodyMeshes<dim> meshes = divided.meshes;
    for (unsigned int i = 0; i < coarse_bodies.size(); ++i)
      if (divided.depths[i] > 0)
        meshes[i] = std::make_shared<BodyMesh<dim>>(divided.meshes[i],
                                                    owners_of_cells[i],
                                                    divided.steps[i],
                                                    divided.depths[i],
                                                    communicator);

    // Levels from the finest down. A process has two of them as a whole at a
    // time.
    NodeNumbering<dim> numbering(divided.meshes, owners_of_cells, n_processes);
    divided.meshes.clear();
    BodyMeshes<dim> finer;
    while (true)
      {
        const bool   is_coarsest = !can_be_coarsened<dim>(meshes);
        unsigned int n_sharing   = n_processes;
        if (is_coarsest)
          n_sharing = 1;
        else if (!levels.empty())
          n_sharing = std::clamp<std::size_t>(
            n_nodes<dim>(meshes) / min_nodes_per_process, 1, n_processes);
        levels.emplace_back(meshes,
                            topology,
                            numbering.next_level(meshes, finer, n_sharing),
                            communicator,
                            n_components);
        if (levels.size() == 1)
          check_plane_sides(levels.front(), topology);
        else
          {
            MeshLevel<dim> &fine = levels[levels.size() - 2];
            prolongations.emplace_back(levels.back(), fine);
            fault_places.push_back(
              places_on_surfaces(levels.back(),
                                 fine,
                                 prolongations.back(),
                                 topology.faults().size()));
            finer.clear();
            if (n_processes > 1)
              {
                fine.keep_own_cells();
                give_back_freed_memory();
              }
          }
        if (is_coarsest)
          break;
        finer  = std::move(meshes);
        meshes = coarsened_once(finer, topology, communicator);
      }
    if (n_processes > 1)
      {
        meshes.clear();
        levels.back().keep_own_cells();
        give_back_freed_memory();
      }
    give_back_large_blocks(sizeof(double) * n_components *
                           levels.front().nodes.n_local());
    std::reverse(levels.begin(), levels.end());
    std::reverse(prolongations.begin(), prolongations.end());
    std::reverse(fault_places.begin(), fault_places.end());
  }



  template <int dim>
  const MeshLevel<dim> &
  MeshHierarchy<dim>::level(const unsigned int l) const
  {
    return levels[l];
  }



  template <int dim>
  const NodalProlongation &
  MeshHierarchy<dim>::prolongation(const unsigned int l) const
  {
    AssertIndexRange(l - 1, prolongations.size());
    return prolongations[l - 1];
  }



  template <int dim>
  const std::vector<unsigned int> &
  MeshHierarchy<dim>::places_on_finer(const unsigned int l,
                                      const unsigned int fault,
                                      const unsigned int side) const
  {
    AssertIndexRange(l, fault_places.size());
    return fault_places[l][fault][side];
  }



  template class MeshHierarchy<2>;
  template class MeshHierarchy<3>;
} // namespace StickSlip
