// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_parameters_h
#define stickslip_scene_scene_parameters_h

#include <deal.II/base/tensor.h>

#include <stickslip/friction/fault_parameters.h>
#include <stickslip/geometry/coarse_body.h>
#include <stickslip/geometry/fault_topology.h>
#include <stickslip/mechanics/boundary_condition.h>
#include <stickslip/mechanics/deformation.h>
#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mortar/contact_parameters.h>
#include <stickslip/output/output_parameters.h>
#include <stickslip/scene/block_entries.h>
#include <stickslip/scene/fault_geometry.h>
#include <stickslip/scene/mesh_accuracy.h>
#include <stickslip/scene/mesh_entries.h>
#include <stickslip/time/time_parameters.h>
#include <stickslip/tnnmg/solver_parameters.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * One body of the scene.
   */
  template <int dim>
  struct BodyParameters
  {
    std::string       name;
    BodyGeometry<dim> geometry;
    BlockEntries      block;
    MaterialFields    material;

    /** The path of the subsection of the entries. */
    std::string
    section() const
    {
      return "Bodies/" + name;
    }
  };

  /**
   * A whole scene as read from a parameter file.
   */
  template <int dim>
  struct SceneParameters
  {
    /** Of bodies in two dimensions. */
    Deformation deformation = Deformation::plane_strain;

    std::vector<BodyParameters<dim>> bodies;

    std::vector<FaultParameters> faults;

    /** Places of the faults above, in the same order. */
    std::vector<FaultGeometry> fault_geometries;

    /** The bodies and faults above, in the same order. */
    FaultTopology topology;

    /** Mesh files, and what they contain or blocks are; nothing where bodies
     * are bricks in a stack. */
    MeshEntries                         mesh_entries;
    std::shared_ptr<const CutMesh<dim>> mesh;

    /** Coarser meshes of the same bodies, finest first. */
    std::vector<std::shared_ptr<const CutMesh<dim>>> coarser_meshes;

    /** Refinement that the program chooses. */
    MeshAccuracy mesh_accuracy;

    std::vector<BoundaryCondition<dim>> boundary_conditions;

    /** True for horizontal axes along which all bodies are periodic. */
    std::array<bool, dim - 1> periodic;

    /** Gravitational acceleration, m/s^2. */
    double gravity = 9.81;

    /** Angle by which the faults dip towards positive x, degrees. */
    double dip = 0.;

    ContactParameters contact;
    TNNMGParameters   tnnmg;
    TimeParameters    time;
    OutputParameters  output;

    SceneParameters()
    {
      periodic.fill(false);
    }

    /** Number of components of displacements. */
    unsigned int
    n_components() const
    {
      return deformation == Deformation::antiplane ? 1 : dim;
    }

    /** The axis of a component of displacements. */
    char
    axis_name(const unsigned int component) const
    {
      return deformation == Deformation::antiplane ? 'z' : "xyz"[component];
    }

    /** The acceleration of gravity along the axes of the scene, m/s^2: the
     * last one is normal to the faults. */
    Tensor<1, dim>
    gravity_vector() const;

    /** The cells of all bodies before any refinement. Throws InputError if the
     * shape of a fault does not fit to them. */
    std::vector<CoarseBody<dim>>
    coarse_bodies() const;

    /** The point of a brick next to a point; in a block or a body of a mesh
     * file the point itself, which must be in it. */
    Point<dim>
    within_body(const unsigned int body, const Point<dim> &point) const;

    /** The sides of a fault along the last axis: that of the bodies below, then
     * that of the bodies above. Elsewhere its first and second side. */
    std::array<std::vector<BodySide>, 2>
    below_and_above(const unsigned int fault) const;

    /** The body of one side of a fault that is nearest to a point. */
    unsigned int
    nearest_body(const std::vector<BodySide> &side,
                 const Point<dim>            &point) const;

  private:
    std::vector<CoarseBody<dim>>
    coarse_bricks() const;

    std::vector<CoarseBody<dim>>
    coarse_bodies_of_mesh() const;
  };
} // namespace StickSlip

#endif
