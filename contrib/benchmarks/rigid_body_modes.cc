// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "rigid_body_modes.h"

namespace Measure
{
  namespace
  {
    /** Pairs of axes in whose planes the bodies can be turned. */
    template <int dim>
    std::vector<std::pair<unsigned int, unsigned int>>
    planes_of_rotation(const BodyMesh<dim> &body)
    {
      const auto is_periodic = [&](const unsigned int axis) {
        return axis + 1 < dim && body.lateral_period()[axis] > 0;
      };
      std::vector<std::pair<unsigned int, unsigned int>> planes;
      for (unsigned int first = 0; first < dim; ++first)
        for (unsigned int second = first + 1; second < dim; ++second)
          if (!is_periodic(first) && !is_periodic(second))
            planes.emplace_back(first, second);
      return planes;
    }
  } // namespace



  template <int dim>
  std::vector<NodalVector>
  rigid_body_modes(const SpatialProblem<dim> &problem)
  {
    const MeshLevel<dim> &level  = problem.meshes().finest();
    const auto            planes = planes_of_rotation(*level.bodies.front());

    std::vector<NodalVector> modes(dim + planes.size(),
                                   problem.make_nodal_vector());
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const std::vector<Point<dim>> points =
          level.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            if (!level.nodes.owned().is_element(level.global_node(b, i)))
              continue;
            const unsigned int first_component = level.node(b, i) * dim;
            for (unsigned int c = 0; c < dim; ++c)
              modes[c].local_element(first_component + c) = 1.;
            for (unsigned int r = 0; r < planes.size(); ++r)
              {
                const auto [c, d]                           = planes[r];
                NodalVector &rotation                       = modes[dim + r];
                rotation.local_element(first_component + c) = -points[i][d];
                rotation.local_element(first_component + d) = points[i][c];
              }
          }
      }

    std::vector<NodalVector> jump_modes(modes.size(), problem.make_vector());
    for (unsigned int m = 0; m < modes.size(); ++m)
      problem.to_jumps(jump_modes[m], modes[m]);
    return jump_modes;
  }



  template std::vector<NodalVector>
  rigid_body_modes<2>(const SpatialProblem<2> &);
  template std::vector<NodalVector>
  rigid_body_modes<3>(const SpatialProblem<3> &);
} // namespace Measure
