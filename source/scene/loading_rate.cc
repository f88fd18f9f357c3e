// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/expression.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  double
  largest_prescribed_velocity(const SceneParameters<dim> &scene)
  {
    const unsigned int n_intervals = 100;
    double             largest     = 0;
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      {
        std::vector<Expression<dim>> velocity;
        for (unsigned int component = 0; component < dim; ++component)
          velocity.emplace_back(condition.type[component] ==
                                    BoundaryType::velocity ?
                                  condition.expression[component] :
                                  "0",
                                true);

        for (unsigned int i = 0; i <= n_intervals; ++i)
          {
            const double time = scene.time.end_time * i / n_intervals;
            for (const Point<dim> &point : side_points(scene, condition))
              {
                double square = 0;
                for (const Expression<dim> &component : velocity)
                  square += std::pow(component.value(point, time), 2);
                largest = std::max(largest, std::sqrt(square));
              }
          }
      }
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const std::vector<Point<dim>> points = fault_points(scene, f);
        for (const FaultPart &part : scene.faults[f].parts(points))
          for (const Tensor<1, dim - 1> &rate :
               part.friction->prescribed_slip_rates(part.select(points),
                                                    part.section))
            largest = std::max(largest, rate.norm());
      }
    return largest;
  }



  template <int dim>
  double
  event_start_slip_rate(const SceneParameters<dim> &scene)
  {
    return scene.output.event_start_slip_rate > 0 ?
             scene.output.event_start_slip_rate :
             2. * largest_prescribed_velocity(scene);
  }



  template decltype(largest_prescribed_velocity<2>)
    largest_prescribed_velocity<2>;
  template decltype(largest_prescribed_velocity<3>)
    largest_prescribed_velocity<3>;

  template decltype(event_start_slip_rate<2>) event_start_slip_rate<2>;
  template decltype(event_start_slip_rate<3>) event_start_slip_rate<3>;
} // namespace StickSlip
