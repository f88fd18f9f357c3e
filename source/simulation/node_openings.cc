// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/contact_change.h>
#include <stickslip/simulation/node_openings.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    bool
    may_any_open(const SceneParameters<dim> &scene)
    {
      return std::any_of(scene.faults.begin(),
                         scene.faults.end(),
                         [](const FaultParameters &fault) {
                           return fault.may_open();
                         });
    }



    /** True unless the slip rate is known, where the sides stay together. */
    bool
    may_open(const FaultPart &part)
    {
      return part.friction->opening.may_open() &&
             !part.friction->has_prescribed_slip();
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<NodeOpening>
  make_node_openings(const SceneParameters<dim>            &scene,
                     const ContactSpace<dim, n_components> &space)
  {
    std::vector<NodeOpening> result;
    if (!may_any_open(scene))
      return result;
    const JumpBasis<dim>     &basis = space.jump_basis();
    const std::vector<double> distances =
      side_distances(space, space.make_nodal_vector());
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const std::vector<Point<dim>> &points = basis.faults()[f].slave.points;
        const unsigned int             first  = result.size();
        result.resize(first + points.size());
        for (const FaultPart &part : scene.faults[f].parts(points))
          {
            if (!may_open(part))
              continue;
            const OpeningParameters &opening = part.friction->opening;
            const auto               values  = [&](const SpatialField &field) {
              return field.values(part.select(points), part.section);
            };
            const std::vector<double> strength =
                                        values(opening.tensile_strength),
                                      cohesion = values(opening.cohesion),
                                      gap      = values(opening.initial_gap);
            for (unsigned int i = 0; i < part.positions.size(); ++i)
              {
                NodeOpening &node      = result[first + part.positions[i]];
                node.may_open          = true;
                node.tensile_strength  = strength[i];
                node.cohesion          = cohesion[i];
                node.bond_healing_time = opening.bond_healing_time;
                node.initial_gap       = gap[i];
                if (scene.topology.faults()[f].may_be_apart)
                  node.initial_gap +=
                    std::max(0., distances[first + part.positions[i]]);
              }
          }
      }
    return result;
  }



  template <int dim>
  std::vector<OpeningParts<dim>>
  make_opening_parts(const SceneParameters<dim> &scene)
  {
    std::vector<OpeningParts<dim>> result;
    if (!may_any_open(scene))
      return result;
    for (const FaultParameters &fault : scene.faults)
      {
        result.emplace_back();
        if (fault.may_open())
          result.back() = [&fault](const std::vector<Point<dim>> &points) {
            std::vector<bool> opens(points.size(), false);
            for (const FaultPart &part : fault.parts(points))
              if (may_open(part))
                for (const unsigned int k : part.positions)
                  opens[k] = true;
            return opens;
          };
      }
    return result;
  }



  template decltype(make_node_openings<2>)    make_node_openings<2>;
  template decltype(make_node_openings<3>)    make_node_openings<3>;
  template decltype(make_node_openings<2, 1>) make_node_openings<2, 1>;
  template decltype(make_opening_parts<2>)    make_opening_parts<2>;
  template decltype(make_opening_parts<3>)    make_opening_parts<3>;
} // namespace StickSlip
