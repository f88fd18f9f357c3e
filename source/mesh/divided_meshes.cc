// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/divided_meshes.h>

#include <algorithm>
#include <set>

namespace StickSlip
{
  template <int dim>
  DividedMeshes<dim>::DividedMeshes(
    const std::vector<CoarseBody<dim>> &coarse_bodies,
    const FaultTopology                &topology,
    const std::size_t                   least_cells)
    : meshes(coarse_bodies.size())
    , steps(coarse_bodies.size())
    , depths(coarse_bodies.size(), 0)
    , n_finest(coarse_bodies.size())
  {
    std::size_t                               n_other_cells = 0;
    std::vector<unsigned int>                 with_units;
    std::vector<std::set<types::boundary_id>> sides;
    unsigned int                              deepest = 0;
    for (unsigned int b = 0; b < meshes.size(); ++b)
      {
        const CoarseBody<dim> &body = coarse_bodies[b];
        sides.push_back(topology.sides_at_faults(b));
        if (BodyMesh<dim>::can_have_units(body))
          {
            // Passes refine nothing where there is no fault.
            steps[b] = {body.uniform_refinements,
                        sides[b].empty() ? 0 : body.refinement_passes};
            with_units.push_back(b);
            deepest = std::max(deepest, steps[b].finest());
          }
        else
          {
            meshes[b] = std::make_shared<BodyMesh<dim>>(body, sides[b]);
            n_finest[b].assign(meshes[b]->n_cells(), 1);
            n_other_cells += meshes[b]->n_cells();
          }
      }

    const auto steps_to_units = [&](const unsigned int b,
                                    const unsigned int depth) {
      return steps[b].coarser(std::min(depth, steps[b].finest()));
    };
    const auto has_enough_cells = [&](const unsigned int depth) {
      std::size_t n_cells = n_other_cells;
      for (const unsigned int b : with_units)
        for (const unsigned int n : count_finest_cells(
               *coarse_bodies[b].cells, sides[b], steps_to_units(b, depth)))
          n_cells += n;
      return n_cells >= least_cells;
    };
    unsigned int depth = 0;
    while (depth < deepest && has_enough_cells(depth + 1))
      ++depth;

    for (const unsigned int b : with_units)
      {
        const RefinementSteps to_units = steps_to_units(b, depth);
        depths[b]                      = steps[b].finest() - to_units.finest();
        CoarseBody<dim> body           = coarse_bodies[b];
        body.uniform_refinements       = to_units.uniform;
        body.refinement_passes         = to_units.at_faults;
        meshes[b] = std::make_shared<BodyMesh<dim>>(body, sides[b]);
        if (steps[b].at_faults == 0)
          n_finest[b].assign(meshes[b]->n_cells(), 1u << (dim * depths[b]));
        else
          n_finest[b] =
            count_finest_cells(meshes[b]->triangulation(), sides[b], steps[b]);
      }
  }



  template struct DividedMeshes<2>;
  template struct DividedMeshes<3>;
} // namespace StickSlip
