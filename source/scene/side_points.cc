// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/mechanics/side_axes.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    // The corners and the centre of a brick that is flat along one axis, or
    // along none if that is dim.
    template <int dim>
    std::vector<Point<dim>>
    brick_points(const Point<dim>  &lower,
                 const Point<dim>  &upper,
                 const unsigned int flat_axis)
    {
      std::vector<Point<dim>> points;
      for (unsigned int corner = 0; corner < (1u << dim); ++corner)
        {
          if ((corner >> flat_axis) & 1u)
            continue;
          Point<dim> point;
          for (unsigned int axis = 0; axis < dim; ++axis)
            point[axis] = ((corner >> axis) & 1u) ? upper[axis] : lower[axis];
          points.push_back(point);
        }
      points.emplace_back(0.5 * (lower + upper));
      return points;
    }



    template <int dim>
    unsigned int
    body_number(const SceneParameters<dim>   &scene,
                const BoundaryCondition<dim> &condition)
    {
      const auto body =
        std::find_if(scene.bodies.begin(),
                     scene.bodies.end(),
                     [&condition](const BodyParameters<dim> &candidate) {
                       return candidate.name == condition.body;
                     });
      Assert(body != scene.bodies.end(), ExcMessage("There is no such body."));
      return body - scene.bodies.begin();
    }
  } // namespace



  template <int dim>
  std::vector<Point<dim>>
  side_points(const SceneParameters<dim>   &scene,
              const BoundaryCondition<dim> &condition)
  {
    const unsigned int number = body_number(scene, condition);
    if (scene.mesh != nullptr)
      return scene.mesh->bodies[number].vertices_on(condition.side);

    const BodyGeometry<dim> &geometry = scene.bodies[number].geometry;
    const unsigned int       axis     = condition.side / 2;
    Point<dim>               lower    = geometry.lower_corner();
    Point<dim>               upper    = geometry.upper_corner();
    if (condition.side % 2 == 0)
      upper[axis] = lower[axis];
    else
      lower[axis] = upper[axis];
    std::vector<Point<dim>> points = brick_points(lower, upper, axis);
    for (Point<dim> &point : points)
      point = geometry.placed(point);
    return points;
  }



  namespace
  {
    Tensor<1, 2>
    normal_to(const Tensor<1, 2> &edge, const Tensor<1, 2> &)
    {
      return Tensor<1, 2>({edge[1], -edge[0]});
    }



    Tensor<1, 3>
    normal_to(const Tensor<1, 3> &edge, const Tensor<1, 3> &other)
    {
      return cross_product_3d(edge, other);
    }
  } // namespace



  namespace
  {
    /** The axes of the plane through some points. */
    template <int dim>
    Tensor<2, dim>
    axes_through(const std::vector<Point<dim>> &points)
    {
      // The longest edge from the first point, and the largest triangle with
      // it.
      Tensor<1, dim> edge, normal;
      for (const Point<dim> &point : points)
        if ((point - points[0]).norm() > edge.norm())
          edge = point - points[0];
      for (const Point<dim> &point : points)
        if (const Tensor<1, dim> candidate = normal_to(edge, point - points[0]);
            candidate.norm() > normal.norm())
          normal = candidate;
      return axes_of_side(Tensor<1, dim>(normal / normal.norm()));
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<2, dim>>
  side_directions(const SceneParameters<dim>   &scene,
                  const BoundaryCondition<dim> &condition)
  {
    if (condition.axes == BoundaryAxes::space)
      return {unit_symmetric_tensor<dim>()};
    if (scene.mesh == nullptr)
      return {axes_through(side_points(scene, condition))};
    std::vector<Tensor<2, dim>> directions;
    const BodyCells<dim>       &body =
      scene.mesh->bodies[body_number(scene, condition)];
    const auto look_at = [&](const auto &faces) {
      for (const auto &face : faces)
        if (face.boundary_id == condition.side)
          {
            std::vector<Point<dim>> vertices;
            for (const unsigned int v : face.vertices)
              vertices.push_back(body.vertices[v]);
            directions.push_back(axes_through(vertices));
          }
    };
    if constexpr (dim == 2)
      look_at(body.boundary.boundary_lines);
    else
      look_at(body.boundary.boundary_quads);
    return directions;
  }



  template <int dim>
  std::vector<Point<dim>>
  body_points(const SceneParameters<dim> &scene, const unsigned int number)
  {
    if (scene.mesh != nullptr)
      return scene.mesh->bodies[number].vertices;
    const BodyGeometry<dim> &body = scene.bodies[number].geometry;
    std::vector<Point<dim>>  points =
      brick_points(body.lower_corner(), body.upper_corner(), dim);
    for (Point<dim> &point : points)
      point = body.placed(point);
    return points;
  }



  namespace
  {
    /** Points of the fault between two bodies; none if they do not meet. */
    template <int dim>
    std::vector<Point<dim>>
    points_between(const BodyGeometry<dim> &below,
                   const BodyGeometry<dim> &above,
                   const unsigned int       n_intervals)
    {
      Point<dim> lower = above.lower_corner();
      Point<dim> upper = below.upper_corner();
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        {
          lower[axis] =
            std::max(below.lateral_lower[axis], above.lateral_lower[axis]);
          upper[axis] =
            std::min(below.lateral_upper[axis], above.lateral_upper[axis]);
          if (lower[axis] >= upper[axis])
            return {};
        }

      // The corners and the centre first, which are easier to read in messages.
      std::vector<Point<dim>> points = brick_points(lower, upper, dim - 1);
      for (unsigned int i = 0; i < Utilities::pow(n_intervals + 1, dim - 1);
           ++i)
        {
          Point<dim> point = lower;
          for (unsigned int axis = 0, place = i; axis + 1 < dim; ++axis)
            {
              point[axis] += (upper[axis] - lower[axis]) *
                             (place % (n_intervals + 1)) / n_intervals;
              place /= n_intervals + 1;
            }
          points.push_back(point);
        }
      if (below.upper_elevation)
        for (Point<dim> &point : points)
          point[dim - 1] = below.upper_elevation(point);
      return points;
    }
  } // namespace



  template <int dim>
  std::vector<Point<dim>>
  fault_points(const SceneParameters<dim> &scene,
               const unsigned int          fault,
               const unsigned int          n_intervals)
  {
    const auto [below, above] = scene.below_and_above(fault);
    std::vector<Point<dim>> points;
    if (scene.mesh != nullptr)
      {
        for (const BodySide &part : below)
          for (const Point<dim> &point :
               scene.mesh->bodies[part.body].vertices_on(part.side))
            points.push_back(point);
        return points;
      }
    for (const BodySide &lower : below)
      for (const BodySide &upper : above)
        for (const Point<dim> &point :
             points_between(scene.bodies[lower.body].geometry,
                            scene.bodies[upper.body].geometry,
                            n_intervals))
          points.push_back(point);
    return points;
  }



  template decltype(side_points<2>)     side_points<2>;
  template decltype(side_points<3>)     side_points<3>;
  template decltype(side_directions<2>) side_directions<2>;
  template decltype(side_directions<3>) side_directions<3>;
  template decltype(body_points<2>)     body_points<2>;
  template decltype(body_points<3>)     body_points<3>;
  template decltype(fault_points<2>)    fault_points<2>;
  template decltype(fault_points<3>)    fault_points<3>;
} // namespace StickSlip
