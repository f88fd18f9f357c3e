// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_stuck_faults_h
#define stickslip_tests_stuck_faults_h

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <stickslip/multigrid/linearised_operator.h>
#include <stickslip/problem/spatial_problem.h>

#include "stacked_bodies.h"

namespace StickSlip
{
  /** A side with conditions that act in full from the start. */
  template <int dim>
  BoundaryCondition<dim>
  make_side(const std::string                   &body,
            const unsigned int                   side,
            const std::array<BoundaryType, dim> &type,
            const std::array<std::string, dim>  &expression = {})
  {
    BoundaryCondition<dim> condition;
    condition.body       = body;
    condition.side       = side;
    condition.type       = type;
    condition.expression = expression;
    for (std::string &text : condition.expression)
      if (text.empty())
        text = "0";
    condition.ramp_length = 0.;
    return condition;
  }



  /** A whole scene in space; bodies are named 0, 1, 2... from below. */
  template <int dim>
  struct SpatialScene
  {
    MeshHierarchy<dim>    meshes;
    std::vector<Material> materials;
    BoundaryValues<dim>   boundary;
    SpatialProblem<dim>   problem;

    SpatialScene(const std::vector<BodyGeometry<dim>>      &bodies,
                 const std::vector<BoundaryCondition<dim>> &conditions,
                 const std::vector<Material>               &materials,
                 const Tensor<1, dim>                      &gravity,
                 const MPI_Comm     communicator          = MPI_COMM_WORLD,
                 const unsigned int min_nodes_per_process = 500)
      : meshes(bricks(bodies, conditions, materials),
               stack_topology<dim>(names(bodies.size()),
                                   names(bodies.size() - 1, 1)),
               communicator,
               min_nodes_per_process)
      , materials(materials)
      , boundary(meshes, conditions, names(bodies.size()))
      , problem(meshes, {materials.begin(), materials.end()}, boundary, gravity)
    {}

    /** Bodies of any cells; they are named in the topology. */
    SpatialScene(const std::vector<CoarseBody<dim>>        &bodies,
                 const FaultTopology                       &topology,
                 const std::vector<BoundaryCondition<dim>> &conditions,
                 const std::vector<Material>               &materials,
                 const Tensor<1, dim>                      &gravity,
                 const MPI_Comm communicator = MPI_COMM_WORLD)
      : meshes(bodies, topology, communicator)
      , materials(materials)
      , boundary(meshes, conditions, topology.body_names())
      , problem(meshes, {materials.begin(), materials.end()}, boundary, gravity)
    {}

    /** With gravity of this size along the last axis. */
    SpatialScene(const std::vector<BodyGeometry<dim>>      &bodies,
                 const std::vector<BoundaryCondition<dim>> &conditions,
                 const std::vector<Material>               &materials,
                 const double                               gravity,
                 const MPI_Comm     communicator          = MPI_COMM_WORLD,
                 const unsigned int min_nodes_per_process = 500)
      : SpatialScene(bodies,
                     conditions,
                     materials,
                     Tensor<1, dim>(-gravity *
                                    Point<dim>::unit_vector(dim - 1)),
                     communicator,
                     min_nodes_per_process)
    {}

    /** Bricks with the whole sides and coupled patches that their conditions
     * and materials ask for. */
    static std::vector<CoarseBody<dim>>
    bricks(const std::vector<BodyGeometry<dim>>      &bodies,
           const std::vector<BoundaryCondition<dim>> &conditions,
           const std::vector<Material>               &materials)
    {
      std::vector<CoarseBody<dim>> result;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          result.push_back(coarse_brick(bodies[b]));
          result.back().couples_patches =
            materials[b].volumetric_strain == VolumetricStrain::patch_mean;
        }
      for (const BoundaryCondition<dim> &condition : conditions)
        if (condition.axes == BoundaryAxes::side)
          result[std::stoul(condition.body)].whole_sides.insert(condition.side);
      return result;
    }

    static std::vector<std::string>
    names(const unsigned int n, const unsigned int first = 0)
    {
      std::vector<std::string> result;
      for (unsigned int b = 0; b < n; ++b)
        result.push_back(std::to_string(first + b));
      return result;
    }
  };



  /** The components that are not fixed, and no jumps: the faults are stuck. */
  template <int dim>
  NodeMask
  stuck_mask(const LevelHierarchy<dim> &hierarchy)
  {
    NodeMask mask = hierarchy.finest().fixed;
    for (const unsigned int p : hierarchy.finest().nonsmooth_nodes)
      mask.mask_node(p);
    return mask;
  }



  /**
   * Improve the active components of @p w until A w = b holds there, for the
   * operator A = sum of coefficients times M, C and K. Returns the number of
   * iterations.
   */
  template <int dim>
  unsigned int
  solve_linear(SpatialProblem<dim>       &problem,
               const std::vector<double> &coefficients,
               const NodeMask            &active,
               const NodalVector         &b,
               NodalVector               &w,
               const double               reduction = 1e-14)
  {
    LevelHierarchy<dim> &hierarchy = problem.hierarchy();
    problem.combine(coefficients);
    hierarchy.linearise(std::vector<Tensor<2, dim>>(
                          hierarchy.finest().nonsmooth_nodes.size()),
                        active);
    NodalVector residual = b, correction = b;
    hierarchy.operators().matrix().residual(residual, b, w);
    active.apply(residual);
    correction = 0.;
    if (residual.l2_norm() == 0.)
      return 0;
    SolverControl control(500, reduction * residual.l2_norm());
    SolverCG<NodalVector>(control).solve(LinearisedOperator<dim>{hierarchy},
                                         correction,
                                         residual,
                                         CyclePreconditioner<dim>{hierarchy});
    w += correction;
    return control.last_step();
  }
} // namespace StickSlip

#endif
