// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/scene/scene_parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  template <int dim>
  Tensor<1, dim>
  SceneParameters<dim>::gravity_vector() const
  {
    const double   angle = dip * numbers::PI / 180.;
    Tensor<1, dim> result;
    result[0]       = gravity * std::sin(angle);
    result[dim - 1] = -gravity * std::cos(angle);
    return result;
  }



  template <int dim>
  std::vector<CoarseBody<dim>>
  SceneParameters<dim>::coarse_bodies() const
  {
    std::vector<CoarseBody<dim>> result =
      mesh == nullptr ? coarse_bricks() : coarse_bodies_of_mesh();
    for (unsigned int b = 0; b < mesh_accuracy.refined_cells.size(); ++b)
      result[b].refined_cells = mesh_accuracy.refined_cells[b];
    for (unsigned int b = 0; b < bodies.size(); ++b)
      result[b].couples_patches =
        bodies[b].material.volumetric_strain == VolumetricStrain::patch_mean;
    for (const BoundaryCondition<dim> &condition : boundary_conditions)
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (condition.axes == BoundaryAxes::side &&
            condition.body == bodies[b].name)
          result[b].whole_sides.insert(condition.side);
    return result;
  }



  template <int dim>
  std::vector<CoarseBody<dim>>
  SceneParameters<dim>::coarse_bricks() const
  {
    std::vector<CoarseBody<dim>> result;
    for (const BodyParameters<dim> &body : bodies)
      result.push_back(coarse_brick(body.geometry));
    return result;
  }



  template <int dim>
  std::vector<CoarseBody<dim>>
  SceneParameters<dim>::coarse_bodies_of_mesh() const
  {
    std::vector<CoarseBody<dim>>                        result;
    std::vector<std::shared_ptr<const FaultShape<dim>>> shapes;
    for (unsigned int f = 0; f < fault_geometries.size(); ++f)
      shapes.push_back(
        fault_geometries[f].make_shape(mesh->bodies, topology.faults()[f]));
    std::vector<BodyCells<dim>> body_cells = mesh->bodies;
    move_onto_shapes(body_cells, topology, shapes);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        result.emplace_back();
        CoarseBody<dim>         &body     = result.back();
        const BodyGeometry<dim> &geometry = bodies[b].geometry;
        const auto               cells    = body_cells[b].triangulation();
        set_shapes(*cells, shapes_of_body(b, topology, shapes));
        body.cells = cells;
        for (const auto &coarser : coarser_meshes)
          body.coarser_cells.push_back(coarser->bodies[b].triangulation());
        body.side_names          = mesh->bodies[b].side_names;
        body.uniform_refinements = geometry.uniform_refinements;
        body.refinement_passes   = geometry.refinement_passes;
        body.refinement_rows     = geometry.refinement_rows;
        body.refine_where        = geometry.where_to_refine();
        body.rigid               = geometry.rigid;
      }
    return result;
  }



  template <int dim>
  Point<dim>
  SceneParameters<dim>::within_body(const unsigned int body,
                                    const Point<dim>  &point) const
  {
    return mesh == nullptr ? bodies[body].geometry.within_sides(point) : point;
  }



  template <int dim>
  std::array<std::vector<BodySide>, 2>
  SceneParameters<dim>::below_and_above(const unsigned int fault) const
  {
    std::array<std::vector<BodySide>, 2> sides = topology.faults()[fault].sides;
    if (mesh != nullptr)
      return sides;
    const auto base = [&](const auto &side) {
      return bodies[side.front().body].geometry.base;
    };
    if (base(sides[1]) < base(sides[0]))
      std::swap(sides[0], sides[1]);
    return sides;
  }



  template <int dim>
  unsigned int
  SceneParameters<dim>::nearest_body(const std::vector<BodySide> &side,
                                     const Point<dim>            &point) const
  {
    if (side.size() == 1)
      return side[0].body;
    const auto distance = [&](const BodySide &part) {
      if (mesh == nullptr)
        return bodies[part.body].geometry.within_sides(point).distance(point);
      double least = std::numeric_limits<double>::max();
      for (const Point<dim> &vertex :
           mesh->bodies[part.body].vertices_on(part.side))
        least = std::min(least, vertex.distance(point));
      return least;
    };
    return std::min_element(side.begin(),
                            side.end(),
                            [&](const BodySide &a, const BodySide &b) {
                              return distance(a) < distance(b);
                            })
      ->body;
  }



  template struct SceneParameters<2>;
  template struct SceneParameters<3>;
} // namespace StickSlip
