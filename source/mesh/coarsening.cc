// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/mesh/coarsening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace StickSlip
{
  namespace
  {
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
    is_any_refined(const BodyMeshes<dim> &bodies)
    {
      return std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
        return body->can_be_coarsened();
      });
    }
  } // namespace



  template <int dim>
  bool
  can_be_coarsened(const BodyMeshes<dim> &bodies)
  {
    return is_any_refined<dim>(bodies) ||
           std::all_of(bodies.begin(), bodies.end(), [](const auto &body) {
             return body->has_coarser_cells();
           });
  }



  template <int dim>
  BodyMeshes<dim>
  coarsened_once(const BodyMeshes<dim> &bodies,
                 const FaultTopology   &topology,
                 const MPI_Comm        &communicator)
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
    const bool      is_refined = is_any_refined<dim>(bodies);
    BodyMeshes<dim> coarser    = bodies;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (!is_refined || (bodies[b]->can_be_coarsened() && !can_wait(b)))
        coarser[b] = BodyMesh<dim>::coarsened(*bodies[b]);
    return coarser;
  }



  template decltype(can_be_coarsened<2>) can_be_coarsened<2>;
  template decltype(can_be_coarsened<3>) can_be_coarsened<3>;
  template decltype(coarsened_once<2>)   coarsened_once<2>;
  template decltype(coarsened_once<3>)   coarsened_once<3>;
} // namespace StickSlip
