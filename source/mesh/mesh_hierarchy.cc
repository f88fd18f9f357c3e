// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/index_set.h>
#include <stickslip/base/freed_memory.h>
#include <stickslip/base/input_error.h>
#include <stickslip/mesh/cell_partition.h>
#include <stickslip/mesh/fault_places.h>
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



    /** Cells that are divided between the processes at least, in units of the
     * least number of nodes of a process. So many divide as well as all, and
     * take little of the memory and time of a process. */
    constexpr unsigned int least_units = 40;



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
    n_nodes(const Bodies<dim> &bodies)
    {
      std::size_t n = 0;
      for (const auto &body : bodies)
        n += body->n_vertices();
      return n;
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



    /** The smallest size of a face (in three dimensions the root of its area)
     * on one of these sides, infinite if there is none. Collective. */
    template <int dim>
    double
    smallest_face(const BodyMesh<dim>                &body,
                  const std::set<types::boundary_id> &sides,
                  const MPI_Comm                     &communicator)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const auto &face : body.triangulation().active_face_iterators())
        if (face->at_boundary() && sides.count(face->boundary_id()) > 0)
          smallest =
            std::min(smallest, std::pow(face->measure(), 1. / (dim - 1)));
      return Utilities::MPI::min(smallest, communicator);
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



    template <int dim>
    bool
    is_any_refined(const Bodies<dim> &bodies)
    {
      return std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
        return body->can_be_coarsened();
      });
    }



    /** True if there is a coarser level: if a body is refined, or if all of
     * them have coarser cells than their coarse ones. */
    template <int dim>
    bool
    can_be_coarsened(const Bodies<dim> &bodies)
    {
      return is_any_refined<dim>(bodies) ||
             std::all_of(bodies.begin(), bodies.end(), [](const auto &body) {
               return body->has_coarser_cells();
             });
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
    coarsened_once(const Bodies<dim>   &bodies,
                   const FaultTopology &topology,
                   const MPI_Comm      &communicator)
    {
      std::vector<double> face;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        face.push_back(smallest_face<dim>(*bodies[b],
                                          topology.sides_at_faults(b),
                                          communicator));
      const auto can_wait = [&](const unsigned int b) {
        for (const unsigned int other : neighbours(topology, b))
          {
            // If it takes a level more, from four times larger faces on.
            const bool is_deeper =
              bodies[other]->n_coarsenings() > bodies[b]->n_coarsenings();
            const double ratio = is_deeper ? 0.49 : 0.26;
            if (bodies[other]->can_be_coarsened() &&
                face[other] < ratio * face[b])
              return true;
          }
        return false;
      };
      // Coarser cells are for all bodies, whose sides shall go on to fit.
      const bool  is_refined = is_any_refined<dim>(bodies);
      Bodies<dim> coarser    = bodies;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (!is_refined || (bodies[b]->can_be_coarsened() && !can_wait(b)))
          coarser[b] = BodyMesh<dim>::coarsened(*bodies[b]);
      return coarser;
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



    template <int dim>
    RefinementSteps
    steps_of(const CoarseBody<dim> &body)
    {
      return {body.uniform_refinements, body.refinement_passes};
    }



    /** The steps to the units of a body, of which so many are left then if it
     * has as many. */
    template <int dim>
    RefinementSteps
    steps_to_units(const CoarseBody<dim> &body, const unsigned int depth)
    {
      const RefinementSteps steps = steps_of(body);
      return steps.coarser(std::min(depth, steps.finest()));
    }



    /**
     * The meshes that are divided between the processes, how many steps of
     * refinement of each body are beyond them, as many as leave @p least_cells
     * in all, and how many finest cells each of their cells stands for.
     */
    template <int dim>
    struct DividedMeshes
    {
      DividedMeshes(const std::vector<CoarseBody<dim>> &coarse_bodies,
                    const FaultTopology                &topology,
                    const std::size_t                   least_cells)
        : meshes(coarse_bodies.size())
        , depths(coarse_bodies.size(), 0)
        , n_finest(coarse_bodies.size())
      {
        std::size_t               n_other_cells = 0;
        std::vector<unsigned int> with_units;
        unsigned int              deepest = 0;
        for (unsigned int b = 0; b < meshes.size(); ++b)
          if (BodyMesh<dim>::can_have_units(coarse_bodies[b]))
            {
              with_units.push_back(b);
              deepest = std::max(deepest, steps_of(coarse_bodies[b]).finest());
            }
          else
            {
              meshes[b] =
                std::make_shared<BodyMesh<dim>>(coarse_bodies[b],
                                                topology.sides_at_faults(b));
              n_finest[b].assign(meshes[b]->n_cells(), 1);
              n_other_cells += meshes[b]->n_cells();
            }

        const auto has_enough_cells = [&](const unsigned int depth) {
          std::size_t n_cells = n_other_cells;
          for (const unsigned int b : with_units)
            for (const unsigned int n :
                 count_finest_cells(*coarse_bodies[b].cells,
                                    topology.sides_at_faults(b),
                                    steps_to_units(coarse_bodies[b], depth)))
              n_cells += n;
          return n_cells >= least_cells;
        };
        unsigned int depth = 0;
        while (depth < deepest && has_enough_cells(depth + 1))
          ++depth;

        for (const unsigned int b : with_units)
          {
            const RefinementSteps steps = steps_of(coarse_bodies[b]),
                                  to_units =
                                    steps_to_units(coarse_bodies[b], depth);
            depths[b]                = steps.finest() - to_units.finest();
            CoarseBody<dim> body     = coarse_bodies[b];
            body.uniform_refinements = to_units.uniform;
            body.refinement_passes   = to_units.at_faults;
            const auto sides         = topology.sides_at_faults(b);
            meshes[b] = std::make_shared<BodyMesh<dim>>(body, sides);
            n_finest[b] =
              count_finest_cells(meshes[b]->triangulation(), sides, steps);
          }
      }

      Bodies<dim>                            meshes;
      std::vector<unsigned int>              depths;
      std::vector<std::vector<unsigned int>> n_finest;
    };



    /** Numbers of the nodes of all bodies, level by level from the finest
     * down, from the processes of the cells that have been divided. */
    template <int dim>
    class NodeNumbering
    {
    public:
      NodeNumbering(
        const Bodies<dim> &divided,
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
      next_level(const Bodies<dim> &bodies,
                 const Bodies<dim> &finer,
                 const unsigned int n_sharing)
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
      Bodies<dim> divided;
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

    Bodies<dim> meshes = divided.meshes;
    for (unsigned int i = 0; i < coarse_bodies.size(); ++i)
      if (divided.depths[i] > 0)
        meshes[i] = std::make_shared<BodyMesh<dim>>(divided.meshes[i],
                                                    owners_of_cells[i],
                                                    steps_of(coarse_bodies[i]),
                                                    divided.depths[i],
                                                    communicator);

    // Levels from the finest down. A process has two of them as a whole at a
    // time.
    NodeNumbering<dim> numbering(divided.meshes, owners_of_cells, n_processes);
    divided.meshes.clear();
    Bodies<dim> finer;
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
