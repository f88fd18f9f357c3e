// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_stacked_bodies_h
#define stickslip_tests_stacked_bodies_h

#include <deal.II/base/tensor.h>

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <cmath>
#include <random>
#include <vector>

namespace StickSlip
{
  /** A body of 5 m (in three dimensions 5 m x 5 m) with the given cells. */
  template <int dim>
  BodyGeometry<dim>
  make_body(const double                         thickness,
            const std::array<unsigned int, dim> &coarse_cells,
            const unsigned int                   refinement_passes)
  {
    BodyGeometry<dim> body;
    body.thickness         = thickness;
    body.coarse_cells      = coarse_cells;
    body.refinement_passes = refinement_passes;
    return body;
  }



  /** The bodies one upon the other, the lowest one on the height zero. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  stack(std::vector<BodyGeometry<dim>> bodies)
  {
    double base = 0.;
    for (BodyGeometry<dim> &body : bodies)
      {
        body.base = base;
        base += body.thickness;
      }
    return bodies;
  }



  /** The topology of a stack, its bodies and faults named by numbers from one.
   */
  template <int dim>
  FaultTopology
  numbered_stack(const unsigned int n_bodies)
  {
    std::vector<std::string> names;
    for (unsigned int i = 1; i <= n_bodies; ++i)
      names.push_back(std::to_string(i));
    std::vector<std::string> faults(names.begin(), names.end() - 1);
    return stack_topology<dim>(names, faults);
  }



  /** The bodies with all cells halved so many times before the passes. */
  template <int dim>
  std::vector<BodyGeometry<dim>>
  halved(std::vector<BodyGeometry<dim>> bodies, const unsigned int times)
  {
    for (BodyGeometry<dim> &body : bodies)
      body.uniform_refinements = times;
    return bodies;
  }



  /** The two bodies of the published spring slider. */
  inline std::vector<BodyGeometry<2>>
  spring_slider_bodies()
  {
    return stack<2>(
      {make_body<2>(1., {{10, 2}}, 4), make_body<2>(1., {{10, 2}}, 4)});
  }



  /** The five bodies of the published layered scene. */
  inline std::vector<BodyGeometry<2>>
  layered_bodies()
  {
    return stack<2>({make_body<2>(1., {{10, 2}}, 4),
                     make_body<2>(0.3, {{16, 1}}, 3),
                     make_body<2>(0.09, {{55, 1}}, 2),
                     make_body<2>(0.3, {{16, 1}}, 3),
                     make_body<2>(1., {{10, 2}}, 4)});
  }



  /** Three bodies whose meshes do not match, the upper side of one fault and
   * the lower side of the other finer. */
  inline std::vector<BodyGeometry<2>>
  nonmatching_bodies()
  {
    return stack<2>({make_body<2>(1., {{10, 2}}, 2),
                     make_body<2>(0.5, {{14, 1}}, 2),
                     make_body<2>(1., {{9, 2}}, 2)});
  }



  /** Two blocks in three dimensions with nonmatching meshes. */
  inline std::vector<BodyGeometry<3>>
  nonmatching_blocks()
  {
    return stack<3>(
      {make_body<3>(3., {{2, 2, 2}}, 2), make_body<3>(2., {{3, 3, 1}}, 1)});
  }



  /** Call @p visit(body, dof, node, position, is hanging) for all nodes. */
  template <int dim, typename Visitor>
  void
  for_each_node(const MeshLevel<dim> &level, const Visitor &visit)
  {
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const BodyMesh<dim> &body      = *level.bodies[b];
        const auto           positions = body.node_positions();
        for (unsigned int dof = 0; dof < positions.size(); ++dof)
          visit(b,
                dof,
                level.node(b, dof),
                positions[dof],
                body.bound_nodes().is_constrained(dof));
      }
  }



  /** The nodal values of a function of body and position, zero at hanging
   * nodes, as the solver has it. */
  template <int dim, typename Function>
  NodalVector
  interpolate(const MeshLevel<dim> &level, const Function &function)
  {
    NodalVector values = level.nodes.make_vector();
    for_each_node(level,
                  [&](const unsigned int b,
                      const unsigned int,
                      const unsigned int node,
                      const Point<dim>  &x,
                      const bool         hanging) {
                    const Tensor<1, dim> value = function(b, x);
                    for (unsigned int c = 0; c < dim; ++c)
                      values.local_element(node * dim + c) =
                        hanging ? 0. : value[c];
                  });
    return values;
  }



  /** Scenes of stacked bodies, matching and not; all have hanging nodes on some
   * level. */
  template <int dim>
  std::vector<std::vector<BodyGeometry<dim>>>
  scenes()
  {
    if constexpr (dim == 2)
      return {spring_slider_bodies(), layered_bodies(), nonmatching_bodies()};
    else
      return {nonmatching_blocks()};
  }



  /** Set the values at hanging nodes to what their neighbours make them. */
  template <int dim>
  void
  fill_hanging_nodes(const MeshLevel<dim> &level, NodalVector &values)
  {
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
        for (unsigned int c = 0; c < dim; ++c)
          {
            double sum = 0.;
            for (const auto &master : line.entries)
              sum += master.second * values.local_element(
                                       level.node(b, master.first) * dim + c);
            values.local_element(level.node(b, line.index) * dim + c) = sum;
          }
  }



  /** Random values between -1 and 1, zero at hanging nodes. */
  template <int dim>
  NodalVector
  random_values(const MeshLevel<dim> &level, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    return interpolate(level, [&](const unsigned int, const Point<dim> &) {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = number(random);
      return value;
    });
  }



  /** The translations along the axes and the infinitesimal rotations in the
   * planes of each two axes. */
  template <int dim>
  std::vector<std::pair<Tensor<1, dim>, Tensor<2, dim>>>
  rigid_motions()
  {
    std::vector<std::pair<Tensor<1, dim>, Tensor<2, dim>>> motions;
    for (unsigned int c = 0; c < dim; ++c)
      {
        motions.emplace_back();
        motions.back().first[c] = 1.;
      }
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < c; ++d)
        {
          motions.emplace_back();
          motions.back().second[c][d] = 1.;
          motions.back().second[d][c] = -1.;
        }
    return motions;
  }
} // namespace StickSlip

#endif
