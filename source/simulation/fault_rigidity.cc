// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/fault_rigidity.h>

namespace StickSlip
{
  template <int dim>
  std::vector<double>
  sum_over_sides(const SceneParameters<dim>                    &scene,
                 const unsigned int                             fault,
                 const std::vector<Point<dim>>                 &points,
                 const std::function<double(const Material &)> &number)
  {
    std::vector<double> sum(points.size(), 0.);
    for (const std::vector<BodySide> &side :
         scene.topology.faults()[fault].sides)
      for (const BodySide &part : side)
        {
          const BodyParameters<dim> &body = scene.bodies[part.body];
          if (body.geometry.rigid)
            continue;
          const auto material = body.material.template function<dim>();
          for (unsigned int k = 0; k < points.size(); ++k)
            if (scene.nearest_body(side, points[k]) == part.body)
              sum[k] +=
                number(material(scene.within_body(part.body, points[k])));
        }
    return sum;
  }



  template <int dim>
  std::vector<double>
  fault_rigidity(const SceneParameters<dim>    &scene,
                 const unsigned int             fault,
                 const std::vector<Point<dim>> &points)
  {
    std::vector<double> rigidity =
      sum_over_sides(scene, fault, points, [](const Material &material) {
        return 0.5 / material.shear_modulus();
      });
    for (double &value : rigidity)
      value = 1. / value;
    return rigidity;
  }



  template decltype(sum_over_sides<2>) sum_over_sides<2>;
  template decltype(sum_over_sides<3>) sum_over_sides<3>;
  template decltype(fault_rigidity<2>) fault_rigidity<2>;
  template decltype(fault_rigidity<3>) fault_rigidity<3>;
} // namespace StickSlip
