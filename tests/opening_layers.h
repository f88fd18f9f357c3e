// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_opening_layers_h
#define stickslip_tests_opening_layers_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "friction_chain.h"
#include "stuck_faults.h"

namespace StickSlip::Tests
{
  /**
   * The rate problem of a stack of bodies of 5 m, held below and dragged along
   * at the top, whose faults are pulled apart and pressed together in turn.
   */
  template <int dim>
  struct OpeningLayers
  {
    static constexpr int    dimension     = dim;
    static constexpr double normal_stress = 4.9e4;
    static constexpr double loading_rate  = 2e-4;

    /** Places (m) and the number of the fault to shear and normal traction over
     * the normal stress of friction, the latter positive where it pulls. */
    using Traction =
      std::function<std::pair<double, double>(const Point<dim> &,
                                              const unsigned int)>;

    MeshHierarchy<dim>  meshes;
    BoundaryValues<dim> boundary;
    SpatialProblem<dim> problem;

    /** Faults open not at all, everywhere, or only between x = 0.3 m and
     * 2.2 m. */
    OpeningLayers(const std::vector<BodyGeometry<dim>> &bodies,
                  const bool                            opens,
                  const bool                            opens_in_part = false,
                  const MPI_Comm     communicator          = MPI_COMM_WORLD,
                  const unsigned int min_nodes_per_process = 500)
      : meshes(stack<dim>(bodies), communicator, min_nodes_per_process)
      , boundary(meshes,
                 conditions(bodies.size()),
                 SpatialScene<dim>::names(bodies.size()))
      , problem(meshes,
                std::vector<MaterialFields>(bodies.size(), Material()),
                boundary,
                Tensor<1, dim>(),
                /*with_inertia=*/true,
                {},
                {},
                std::vector<OpeningParts<dim>>(
                  opens ? bodies.size() - 1 : 0,
                  [opens_in_part](const std::vector<Point<dim>> &points) {
                    std::vector<bool> opens;
                    for (const Point<dim> &x : points)
                      opens.push_back(!opens_in_part ||
                                      (x[0] > 0.3 && x[0] < 2.2));
                    return opens;
                  }))
    {}

    /** Calls action(local index, place, fault, weight, sign of opening) for the
     * owned contact nodes in ascending order of the nonsmooth nodes. */
    template <typename Action>
    void
    for_each_contact_node(const Action &action) const
    {
      const LevelDescription<dim> &finest = problem.hierarchy().finest();
      const auto                  &faults = problem.jump_basis().faults();
      std::map<types::global_dof_index, std::pair<unsigned int, unsigned int>>
        places;
      for (unsigned int f = 0; f < faults.size(); ++f)
        for (unsigned int k = 0; k < faults[f].slave.nodes.size(); ++k)
          places[faults[f].slave.nodes[k]] = {f, k};
      for (const unsigned int node : finest.nonsmooth_nodes)
        {
          const auto [f, k] = places.at(finest.nodes.global_index(node));
          action(node,
                 faults[f].slave.points[k],
                 f,
                 faults[f].coupling.weight[k],
                 int(faults[f].sides.sign()));
        }
    }

    /** Set the operator of a step, and return the right hand side of bodies at
     * rest under tractions on their faults. */
    NodalVector
    set_step(const double tau, const Traction &traction)
    {
      problem.combine(Newmark<dim>().operator_coefficients(tau));
      NodalVector b = problem.make_vector();
      for_each_contact_node([&](const unsigned int node,
                                const Point<dim>  &x,
                                const unsigned int f,
                                const double       weight,
                                const int          sign) {
        const auto [shear, normal] = traction(x, f);
        b.local_element(node * dim) += weight * normal_stress * shear;
        b.local_element(node * dim + dim - 1) +=
          sign * weight * normal_stress * normal;
      });
      return b;
    }

    /** Zero but for what is prescribed. */
    NodalVector
    start()
    {
      NodalVector w = problem.make_vector();
      boundary.set_velocities(10., w);
      return w;
    }

    /** Rate-and-state friction with the state alpha at a place and a number of
     * a node. */
    Friction<dim>
    friction(const std::function<double(const Point<dim> &, const unsigned int)>
               &alpha) const
    {
      std::vector<double> weights, states;
      for_each_contact_node([&](const unsigned int,
                                const Point<dim> &x,
                                const unsigned int,
                                const double weight,
                                const int) {
        states.push_back(alpha(x, weights.size()));
        weights.push_back(weight);
      });
      return make_friction<dim>(Kind::truncated,
                                problem.hierarchy().finest().nonsmooth_nodes,
                                weights,
                                normal_stress,
                                states);
    }

    /** Give its nodes bounds, m/s, and return these. */
    std::vector<Reference::Bound>
    let_open(Friction<dim> &friction,
             const std::function<double(const Point<dim> &, const unsigned int)>
               &bound) const
    {
      std::vector<Reference::Bound> result;
      std::vector<int>              signs;
      std::vector<double>           bounds;
      for_each_contact_node([&](const unsigned int node,
                                const Point<dim>  &x,
                                const unsigned int,
                                const double,
                                const int sign) {
        signs.push_back(sign);
        bounds.push_back(bound(x, bounds.size()));
        result.push_back({node, sign, bounds.back()});
      });
      FaultFriction<dim> &functional = faults_of(friction);
      functional.set_opening(signs);
      functional.set_opening_bounds(bounds);
      return result;
    }

    static FaultFriction<dim> &
    faults_of(const Friction<dim> &friction)
    {
      return dynamic_cast<FaultFriction<dim> &>(*friction.functional);
    }

    /** The number of nodes that are not in contact, on all processes. */
    unsigned int
    n_open(const Friction<dim> &friction, const NodalVector &w) const
    {
      const FaultFriction<dim> &faults = faults_of(friction);
      unsigned int              n      = 0;
      for (unsigned int k = 0; k < faults.nodes().size(); ++k)
        n += !faults.is_at_bound(k, block<dim>(w, faults.nodes()[k]), dim - 1);
      return Utilities::MPI::sum(n, w.get_mpi_communicator());
    }

  private:
    static std::vector<BoundaryCondition<dim>>
    conditions(const unsigned int n_bodies)
    {
      std::array<BoundaryType, dim> held, dragged;
      held.fill(BoundaryType::fixed);
      dragged.fill(BoundaryType::free);
      dragged[0] = BoundaryType::velocity;
      return {make_side<dim>("0", BodyMesh<dim>::lower_side, held),
              make_side<dim>(std::to_string(n_bodies - 1),
                             BodyMesh<dim>::upper_side,
                             dragged,
                             {{std::to_string(loading_rate)}})};
    }
  };
} // namespace StickSlip::Tests

#endif
