// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/rigid_body_modes.h>

namespace StickSlip
{
  namespace
  {
    /** Velocity at @p x of the rotation in the plane of two axes. */
    template <int dim>
    Tensor<1, dim>
    rotation(const Point<dim>  &x,
             const unsigned int first,
             const unsigned int second)
    {
      Tensor<1, dim> v;
      v[first]  = -x[second];
      v[second] = x[first];
      return v;
    }
  } // namespace



  template <int dim>
  std::vector<NodalVector>
  rigid_body_modes(const SpatialProblem<dim> &problem)
  {
    constexpr unsigned int n_modes = dim + (dim == 2 ? 1 : 3);

    const MeshLevel<dim>    &level = problem.meshes().finest();
    std::vector<NodalVector> modes(n_modes, problem.make_nodal_vector());
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const std::vector<Point<dim>> points =
          level.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            if (!level.nodes.owned().is_element(level.global_node(b, i)))
              continue;
            const unsigned int node = level.node(b, i);
            for (unsigned int m = 0; m < n_modes; ++m)
              {
                Tensor<1, dim> v;
                if (m < dim)
                  v[m] = 1.;
                else
                  v = rotation(points[i], (m - dim) / 2, 1 + (m - dim + 1) / 2);
                for (unsigned int c = 0; c < dim; ++c)
                  modes[m].local_element(node * dim + c) = v[c];
              }
          }
      }

    std::vector<NodalVector> jump_modes(n_modes, problem.make_vector());
    for (unsigned int m = 0; m < n_modes; ++m)
      problem.to_jumps(jump_modes[m], modes[m]);
    return jump_modes;
  }



  template std::vector<NodalVector>
  rigid_body_modes<2>(const SpatialProblem<2> &);
  template std::vector<NodalVector>
  rigid_body_modes<3>(const SpatialProblem<3> &);
} // namespace StickSlip
