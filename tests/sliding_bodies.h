// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_sliding_bodies_h
#define stickslip_tests_sliding_bodies_h

#include <limits>

#include "stuck_faults.h"

namespace StickSlip::Tests
{
  /** Slide every other body by a distance, and couple the faults anew. */
  template <int dim>
  void
  slide(SpatialScene<dim> &scene, const double distance)
  {
    NodalVector           displacement = scene.problem.make_nodal_vector();
    const MeshLevel<dim> &level        = scene.meshes.finest();
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      for (unsigned int dof = 0; dof < level.bodies[b]->dof_handler().n_dofs();
           ++dof)
        if (level.nodes.owned().is_element(level.global_node(b, dof)))
          displacement.local_element(level.node(b, dof) * dim) =
            (b % 2 == 0 ? 0. : distance);
    scene.problem.build_contact(displacement);
  }



  /** The operators of all levels, without friction. */
  template <int dim>
  void
  combine_without_friction(SpatialScene<dim> &scene)
  {
    LevelHierarchy<dim> &hierarchy = scene.problem.hierarchy();
    hierarchy.set_cycle_precision(CyclePrecision::double_precision);
    hierarchy.operators().combine({200., 1., 5e-3});
    hierarchy.linearise(std::vector<Tensor<2, dim>>(
                          hierarchy.finest().nonsmooth_nodes.size()),
                        hierarchy.finest().fixed);
  }



  /** Curvature and truncation that depend on the place on the slave sides. */
  template <int dim>
  void
  linearise_along_faults(SpatialScene<dim> &scene)
  {
    LevelHierarchy<dim>         &hierarchy = scene.problem.hierarchy();
    const LevelDescription<dim> &finest    = hierarchy.finest();
    NodeMask                     active    = finest.fixed;
    std::vector<Tensor<2, dim>>  hessians(finest.nonsmooth_nodes.size());
    for (const FaultContact<dim> &fault : scene.problem.jump_basis().faults())
      {
        double left = std::numeric_limits<double>::max();
        for (const Point<dim> &point : fault.slave.points)
          left = std::min(left, point[0]);
        for (unsigned int k = 0; k < fault.slave.nodes.size(); ++k)
          if (finest.nodes.owned().is_element(fault.slave.nodes[k]))
            {
              const unsigned int node =
                finest.nodes.local_index(fault.slave.nodes[k]);
              const auto place =
                std::lower_bound(finest.nonsmooth_nodes.begin(),
                                 finest.nonsmooth_nodes.end(),
                                 node);
              if (place == finest.nonsmooth_nodes.end() || *place != node)
                continue;
              const double x = fault.slave.points[k][0] - left;
              const double y = fault.slave.points[k][dim - 1];
              if (std::sin(7. * x + y) > 0.2)
                active.mask(node, 0);
              else
                hessians[place - finest.nonsmooth_nodes.begin()][0][0] =
                  1e5 * std::exp(x);
            }
      }
    hierarchy.linearise(hessians, active);
  }
} // namespace StickSlip::Tests

#endif
