// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_boundary_values_h
#define stickslip_mechanics_boundary_values_h

#include <stickslip/algebra/node_frames.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/mechanics/boundary_condition.h>
#include <stickslip/mechanics/node_constraint.h>
#include <stickslip/mechanics/side_axes.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/parameters/expression.h>

#include <map>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The largest values met of loads that depend on time, for each side with
   * a boundary condition and each component, m/s or Pa; empty at the start.
   */
  template <int dim>
  using LargestLoads = std::vector<std::array<double, dim>>;

  /**
   * The boundary conditions of a scene on its meshes: the components that they
   * fix on each level, and their values. Where some of them are along the axes
   * of a side, components of its nodes have axes of their own; on a curved side
   * those of the nodal normals of the finest level, on all levels. All
   * components of a rigid body are fixed, with the velocity that is given for
   * one of its sides, or none. A single component is that out of the plane.
   */
  template <int dim, int n_components = dim>
  class BoundaryValues
  {
  public:
    /** @p body_names in the order of the meshes. Throws InputError where a
     * condition is along the axes of a side with a corner, of a curved side of
     * a rigid body, or of one whose tangential directions are not unique. */
    BoundaryValues(const MeshHierarchy<dim>                  &meshes,
                   const std::vector<BoundaryCondition<dim>> &conditions,
                   const std::vector<std::string>            &body_names);

    /** The components of the owned nodes of level @p l whose velocity is
     * prescribed, along the axes of frames(). */
    NodeMask
    dirichlet_mask(const unsigned int l) const;

    /** The axes of nodes on level @p l with a component that is prescribed
     * along another direction than those of space. */
    NodeFrames<n_components>
    frames(const unsigned int l) const;

    /** Set the prescribed velocities of owned nodes at @p time, in the axes of
     * space, m/s. */
    void
    set_velocities(const double time, NodalVector &velocity);

    /** True if tractions are prescribed anywhere. */
    bool
    has_tractions() const;

    /** Add the load of the prescribed tractions at @p time to owned nodes,
     * N. */
    void
    add_tractions(const double time, NodalVector &load);

    /** The length of the longest ramp, s. */
    double
    longest_ramp() const;

    /** True if prescribed velocities are the same at all times from the end of
     * the longest ramp on. */
    bool
    velocities_become_constant() const;

    /**
     * The error of a step from @p time on if all that is known of the loads
     * are their values at its two ends: of the displacement of driven sides,
     * and of the impulse of tractions, compared with Simpson's rule, over the
     * step size and the largest value met so far on the same side, which is
     * kept in
     * @p largest. Zero for loads that do not depend on time. Collective.
     */
    double
    loading_error(const double       time,
                  const double       tau,
                  LargestLoads<dim> &largest);

  private:
    struct Side
    {
      /** Components whose values depend on time. */
      std::array<bool, n_components> varies;

      unsigned int           body;
      BoundaryCondition<dim> condition;
      /** The directions of the components, as columns; of a curved side those
       * of its mean normal. */
      Tensor<2, n_components> axes;
      /** Of a curved side with conditions along its axes. */
      SideNormals<dim> normals;
      /** See reference_of_side(). */
      unsigned int reference = numbers::invalid_unsigned_int;
      /** One for each component, without the ramp. */
      std::vector<Expression<dim>> values;
      /** The owned nodes. */
      std::vector<unsigned int> nodes;
      std::vector<Point<dim>>   points;

      /** The directions at a node on any level. */
      Tensor<2, n_components>
      axes_at(const Point<dim> &point) const;

      /** The directions where a curved side has the outer normal @p normal. */
      Tensor<2, n_components>
      axes_with(const Tensor<1, dim> &normal) const;
    };

    /** Set the axes of a side with conditions along these. */
    static void
    find_axes(const FaultSurface<dim> &surface,
              const bool               is_rigid,
              Side                    &side);

    /** A node with a component that is prescribed along the axes of a side:
     * all prescribed components of all sides that it lies on. */
    struct TurnedNode
    {
      NodeConstraint<n_components> constraint;
      Point<dim>                   point;
      /** Side and component of each direction. */
      std::vector<std::pair<unsigned int, unsigned int>> values;
    };

    /** The nodes on a level, by global number. */
    std::map<types::global_dof_index, TurnedNode>
    find_turned_nodes(const unsigned int l) const;

    const MeshHierarchy<dim> &meshes;
    std::vector<Side>         sides;
    /** Owned nodes of the finest level, by local index. */
    std::map<unsigned int, TurnedNode> turned_nodes;
  };
} // namespace StickSlip

#endif
