// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/freed_memory.h>
#include <stickslip/base/input_error.h>
#include <stickslip/mesh/cell_partition.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    using Bodies = std::vector<std::shared_ptr<const BodyMesh<dim>>>;



    /**
     * The process of each node, body after body, from the owners of the
     * vertices of each body's mesh.
     */
    template <int dim>
    std::vector<unsigned int>
    node_owners(const Bodies<dim>                            &bodies,
                const std::vector<std::vector<unsigned int>> &vertex_owners)
    {
      std::vector<unsigned int> owners;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          const std::size_t first = owners.size();
          owners.resize(first + bodies[b]->dof_handler().n_dofs());
          const auto dofs = bodies[b]->dofs_of_vertices();
          for (unsigned int v = 0; v < dofs.size(); ++v)
            if (dofs[v] != numbers::invalid_dof_index)
              owners[first + dofs[v]] = vertex_owners[b][v];
        }
      return owners;
    }



    /**
     * Gather the nodes of neighbouring processes on one where there are too
     * few for all. The numbers of neighbouring parts are close to each other.
     */
    void
    gather(std::vector<unsigned int> &owners,
           const unsigned int         n_processes,
           const unsigned int         n_sharing)
    {
      for (unsigned int &owner : owners)
        {
          const unsigned int group = owner * n_sharing / n_processes;
          // The first process of the group.
          owner = (group * n_processes + n_sharing - 1) / n_sharing;
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



    /** The number of times that a mesh of trees can be coarsened; for
     * tetrahedra one, if at all. */
    template <int dim>
    unsigned int
    n_coarsenings(const BodyMesh<dim> &body)
    {
      return std::max<unsigned int>(body.triangulation().n_levels() - 1,
                                    body.can_be_coarsened() ? 1 : 0);
    }



    /** The smallest size of a face (in three dimensions the root of its area)
     * on one of these sides, infinite if there is none. */
    template <int dim>
    double
    smallest_face(const BodyMesh<dim>                &body,
                  const std::set<types::boundary_id> &sides)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const auto &face : body.triangulation().active_face_iterators())
        if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
          smallest =
            std::min(smallest, std::pow(face->measure(), 1. / (dim - 1)));
      return smallest;
    }



    /** The bodies across the faults of a body. */
    std::set<unsigned int>
    neighbours(const FaultTopology &topology, const unsigned int body)
    {
      std::set<unsigned int> result;
      for (const Fault &fault : topology.faults())
        for (const unsigned int s : {0, 1})
          for (const BodySide &here : fault.sides[s])
            if (here.body == body)
              for (const BodySide &there : fault.sides[1 - s])
                result.insert(there.body);
      return result;
    }



    /**
     * The meshes of the next coarser level. Those that have much larger faces
     * than a neighbour across a fault are kept until the neighbour is as coarse
     * or as coarse as it can be. What the nodes of a coarser side do is seen in
     * the finer body at their distance, and no other level than that one
     * smoothes it there; through a thin layer they are tied to the nodes of its
     * other side, which is seen where the layer is a cell thick and they are
     * all there.
     */
    template <int dim>
    Bodies<dim>
    coarsened_once(const Bodies<dim> &bodies, const FaultTopology &topology)
    {
      std::vector<double> face;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        face.push_back(
          smallest_face<dim>(*bodies[b], topology.sides_at_faults(b)));
      const auto can_wait = [&](const unsigned int b) {
        for (const unsigned int other : neighbours(topology, b))
          {
            // If it takes a level more, from four times larger faces on.
            const bool is_deeper =
              n_coarsenings(*bodies[other]) > n_coarsenings(*bodies[b]);
            const double ratio = is_deeper ? 0.49 : 0.26;
            if (bodies[other]->can_be_coarsened() &&
                face[other] < ratio * face[b])
              return true;
          }
        return false;
      };
      Bodies<dim> coarser = bodies;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (bodies[b]->can_be_coarsened() && !can_wait(b))
          coarser[b] = std::make_shared<BodyMesh<dim>>(*bodies[b]);
      return coarser;
    }



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

    // All meshes, the finest first.
    std::vector<Bodies<dim>> meshes(1);
    for (unsigned int i = 0; i < coarse_bodies.size(); ++i)
      meshes[0].push_back(
        std::make_shared<BodyMesh<dim>>(coarse_bodies[i],
                                        topology.sides_at_faults(i)));
    for (Bodies<dim> coarser = coarsened_once(meshes.back(), topology);
         coarser != meshes.back();
         coarser = coarsened_once(meshes.back(), topology))
      meshes.push_back(coarser);
    // Coarser cells are for all bodies, whose sides shall go on to fit.
    while (
      std::all_of(meshes.back().begin(),
                  meshes.back().end(),
                  [](const auto &body) { return body->has_coarser_cells(); }))
      {
        meshes.push_back(meshes.back());
        for (auto &body : meshes.back())
          body = std::make_shared<BodyMesh<dim>>(*body);
      }

    std::vector<std::vector<unsigned int>>       owners_of_vertices;
    const std::vector<std::vector<unsigned int>> owners_of_cells =
      partition_cells<dim>(meshes.front(), topology, n_processes);
    for (unsigned int i = 0; i < coarse_bodies.size(); ++i)
      owners_of_vertices.push_back(
        vertex_owners<dim>(*meshes.front()[i], owners_of_cells[i]));

    for (unsigned int l = 0; l < meshes.size(); ++l)
      {
        if (l > 0)
          for (unsigned int i = 0; i < coarse_bodies.size(); ++i)
            owners_of_vertices[i] =
              inherited_vertex_owners<dim>(*meshes[l][i],
                                           *meshes[l - 1][i],
                                           owners_of_vertices[i]);
        std::vector<unsigned int> owners =
          node_owners<dim>(meshes[l], owners_of_vertices);
        if (l + 1 == meshes.size())
          gather(owners, n_processes, 1);
        else if (l > 0)
          gather(owners,
                 n_processes,
                 std::clamp<std::size_t>(owners.size() / min_nodes_per_process,
                                         1,
                                         n_processes));
        levels.emplace_back(
          meshes[l], topology, owners, communicator, n_components);
        if (l == 0)
          check_plane_sides(levels.front(), topology);
      }

    // Rows of the prolongations that are needed: for the nodes of a level that
    // cells or prolongations or the contact may couple with owned ones.
    for (unsigned int l = 0; l + 1 < levels.size(); ++l)
      {
        IndexSet wanted = levels[l].nodes.owned();
        wanted.add_indices(levels[l].nodes.nodes()->ghost_indices());
        wanted.add_indices(levels[l].strip());
        // Every process has the hanging nodes of all faults.
        for (unsigned int f = 0; f < topology.faults().size(); ++f)
          for (const unsigned int side : {0, 1})
            {
              const auto &nodes = levels[l].surface(f, side).nodes;
              wanted.add_indices(nodes.begin(), nodes.end());
            }
        if (l > 0)
          wanted.add_indices(prolongations.back().columns(levels[l].n_nodes()));
        // Coarser cells that are not nested couple nodes farther away; they are
        // few.
        if (!meshes[l + 1].front()->is_nested_with(*meshes[l].front()))
          wanted.add_range(0, levels[l].n_nodes());
        wanted.compress();
        prolongations.emplace_back(levels[l + 1], levels[l], wanted);
      }
    if (n_processes > 1)
      {
        for (MeshLevel<dim> &level : levels)
          level.keep_own_cells();
        meshes.clear();
        give_back_freed_memory();
      }
    std::reverse(levels.begin(), levels.end());
    std::reverse(prolongations.begin(), prolongations.end());
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



  template class MeshHierarchy<2>;
  template class MeshHierarchy<3>;
} // namespace StickSlip
