// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_layered_slider_h
#define stickslip_tests_layered_slider_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/time/newmark.h>

#include <functional>

#include "friction_chain.h"

namespace StickSlip::Tests
{
  /**
   * The rate problem of two bodies of 5 m x 1 m in uniform shear, the lower one
   * held at its bottom and the upper one dragged along at its top. Gravity is
   * left out; the normal stress on the fault is given. In three dimensions the
   * bodies are 5 m wide as well.
   */
  template <int dim>
  struct LayeredSliderIn
  {
    static constexpr double normal_stress   = 4.9e4;
    static constexpr double loading_rate    = 2e-4;
    static constexpr double first_body_base = -1.;

    MeshHierarchy<dim>  meshes;
    BoundaryValues<dim> boundary;
    SpatialProblem<dim> problem;

    LayeredSliderIn(const std::array<unsigned int, dim> &lower_cells,
                    const std::array<unsigned int, dim> &upper_cells,
                    const unsigned int                   refinement_passes,
                    const MPI_Comm     communicator          = MPI_COMM_WORLD,
                    const unsigned int min_nodes_per_process = 500)
      : meshes({body(first_body_base, lower_cells, refinement_passes),
                body(first_body_base + 1., upper_cells, refinement_passes)},
               communicator,
               min_nodes_per_process)
      , boundary(meshes, conditions(), {"lower", "upper"})
      , problem(meshes, {Material(), Material()}, boundary, Tensor<1, dim>())
    {}

    /**
     * Set the operator, and return the right hand side, of a Newmark step of
     * size @p tau. The bodies are in static equilibrium after the top has been
     * moved with the fault stuck, so far that the shear traction is @p
     * traction (Pa) except near the ends.
     */
    NodalVector
    set_step(const double tau, const double traction)
    {
      SystemState<dim> state;
      state.time          = 10.;
      state.velocity      = problem.make_nodal_vector();
      state.acceleration  = problem.make_nodal_vector();
      state.displacement  = problem.make_nodal_vector();
      NodalVector  w      = problem.make_vector();
      const double strain = traction / Material().shear_modulus();
      for_each_node([&](const unsigned int node, const Point<dim> &x) {
        state.displacement.local_element(dim * node) =
          strain * (x[dim - 1] - first_body_base);
        state.velocity.local_element(dim * node) =
          loading_rate * (x[dim - 1] - first_body_base) / 2.;
      });
      problem.to_jumps(w, state.displacement);

      // Uniform shear pulls at the free sides; a V-cycle halves the error.
      LevelHierarchy<dim> &hierarchy = problem.hierarchy();
      hierarchy.operators().combine({0., 0., 1.});
      NodeMask stuck = hierarchy.finest().fixed;
      for (const unsigned int p : hierarchy.finest().nonsmooth_nodes)
        stuck.mask_node(p);
      hierarchy.linearise(std::vector<Tensor<2, dim>>(
                            hierarchy.finest().nonsmooth_nodes.size()),
                          stuck);
      const NodalVector zero     = problem.make_vector();
      NodalVector       residual = zero, correction = zero;
      for (unsigned int cycle = 0; cycle < 60; ++cycle)
        {
          hierarchy.operators().matrix().residual(residual, zero, w);
          stuck.apply(residual);
          hierarchy.v_cycle(correction, residual);
          w += correction;
        }
      problem.to_nodal(state.displacement, w);

      problem.combine(Newmark<dim>().operator_coefficients(tau));
      return Newmark<dim>().right_hand_side(problem, state, tau);
    }

    /** Zero but for what is prescribed. */
    NodalVector
    start()
    {
      NodalVector w = problem.make_vector();
      boundary.set_velocities(10., w);
      return w;
    }

    /** Friction with the state alpha at a position along the fault and the
     * number of the node. */
    Friction<dim>
    friction(
      const Kind                                                 kind,
      const std::function<double(const double, const unsigned)> &alpha) const
    {
      const FaultContact<dim>     &contact = problem.jump_basis().faults()[0];
      const LevelDescription<dim> &finest  = problem.hierarchy().finest();
      std::vector<double>          weights, states;
      for (const unsigned int node : finest.nonsmooth_nodes)
        {
          const unsigned int k = std::find(contact.slave.nodes.begin(),
                                           contact.slave.nodes.end(),
                                           finest.nodes.global_index(node)) -
                                 contact.slave.nodes.begin();
          weights.push_back(contact.coupling.weight[k]);
          states.push_back(alpha(contact.slave.points[k][0], k));
        }
      return make_friction<dim>(
        kind, finest.nonsmooth_nodes, weights, normal_stress, states);
    }

    /** The owned ones. */
    void
    for_each_node(const std::function<void(const unsigned int,
                                           const Point<dim> &)> &action) const
    {
      const MeshLevel<dim> &level = meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const std::vector<Point<dim>> points =
            level.bodies[b]->node_positions();
          for (unsigned int i = 0; i < points.size(); ++i)
            if (level.nodes.owned().is_element(level.global_node(b, i)))
              action(level.node(b, i), points[i]);
        }
    }

  private:
    static BodyGeometry<dim>
    body(const double                         base,
         const std::array<unsigned int, dim> &cells,
         const unsigned int                   passes)
    {
      BodyGeometry<dim> geometry;
      geometry.base              = base;
      geometry.coarse_cells      = cells;
      geometry.refinement_passes = passes;
      return geometry;
    }

    static std::vector<BoundaryCondition<dim>>
    conditions()
    {
      BoundaryCondition<dim> bottom, top;
      bottom.body = "lower";
      bottom.side = BodyMesh<dim>::lower_side;
      bottom.type.fill(BoundaryType::fixed);
      top.body = "upper";
      top.side = BodyMesh<dim>::upper_side;
      top.type.fill(BoundaryType::free);
      top.type[0]       = BoundaryType::velocity;
      top.expression[0] = "2e-4";
      return {bottom, top};
    }
  };

  using LayeredSlider = LayeredSliderIn<2>;
} // namespace StickSlip::Tests

#endif
