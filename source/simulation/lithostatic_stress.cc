// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <stickslip/simulation/lithostatic_stress.h>

namespace StickSlip
{
  template <int dim>
  std::vector<double>
  lithostatic_stress(const SceneParameters<dim>    &scene,
                     const unsigned int             fault,
                     const std::vector<Point<dim>> &points)
  {
    const QIterated<1>  quadrature(QGauss<1>(2), 200);
    const double        g = -scene.gravity_vector()[dim - 1];
    std::vector<double> stress(points.size(), 0.);
    for (unsigned int i = fault + 1; i < scene.bodies.size(); ++i)
      {
        const BodyGeometry<dim> &geometry = scene.bodies[i].geometry;
        const MaterialFields    &material = scene.bodies[i].material;
        const auto               density =
          material.density.template function<dim>(material.section);
        for (unsigned int k = 0; k < points.size(); ++k)
          {
            Point<dim>   point     = geometry.within_sides(points[k]);
            const double thickness = geometry.thickness_at(point);
            double       mean      = 0.;
            if (material.density.is_constant())
              mean = material.density.constant();
            else
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  point[dim - 1] =
                    geometry.base + thickness * quadrature.point(q)[0];
                  mean += density(point) * quadrature.weight(q);
                }
            stress[k] += g * mean * thickness;
          }
      }
    return stress;
  }



  template std::vector<double>
  lithostatic_stress(const SceneParameters<2> &,
                     const unsigned int,
                     const std::vector<Point<2>> &);
  template std::vector<double>
  lithostatic_stress(const SceneParameters<3> &,
                     const unsigned int,
                     const std::vector<Point<3>> &);
} // namespace StickSlip
