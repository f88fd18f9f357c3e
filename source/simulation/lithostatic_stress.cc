// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <stickslip/simulation/lithostatic_stress.h>

#include <functional>
#include <optional>

namespace StickSlip
{
  namespace
  {
    /** The mean density of a body over its thickness below or above a point. */
    template <int dim>
    double
    mean_density(const BodyGeometry<dim>                         &geometry,
                 const std::function<double(const Point<dim> &)> &density,
                 Point<dim>                                       point)
    {
      static const QIterated<1> quadrature(QGauss<1>(2), 200);
      const double              thickness = geometry.thickness_at(point);
      const double              base      = geometry.lower_at(point);
      double                    mean      = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          point[dim - 1] = base + thickness * quadrature.point(q)[0];
          mean += density(point) * quadrature.weight(q);
        }
      return mean;
    }



    /** The fault on top of a body, if there is one. */
    template <int dim>
    std::optional<unsigned int>
    fault_above(const SceneParameters<dim> &scene, const unsigned int body)
    {
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const auto sides = scene.below_and_above(f);
          for (const BodySide &part : sides[0])
            if (part.body == body)
              return f;
        }
      return {};
    }
  } // namespace



  template <int dim>
  std::vector<double>
  lithostatic_stress(const SceneParameters<dim>    &scene,
                     const unsigned int             fault,
                     const std::vector<Point<dim>> &points)
  {
    const double g = -scene.gravity_vector()[dim - 1];
    std::vector<std::function<double(const Point<dim> &)>> density;
    for (const BodyParameters<dim> &body : scene.bodies)
      density.push_back(
        body.material.density.template function<dim>(body.material.section));

    std::vector<double> stress(points.size(), 0.);
    for (unsigned int k = 0; k < points.size(); ++k)
      for (std::optional<unsigned int> f = fault; f;)
        {
          const unsigned int body =
            scene.nearest_body(scene.below_and_above(*f)[1], points[k]);
          const BodyGeometry<dim> &geometry = scene.bodies[body].geometry;
          const SpatialField      &field = scene.bodies[body].material.density;
          const Point<dim>         point = geometry.within_sides(points[k]);
          stress[k] += g *
                       (field.is_constant() ?
                          field.constant() :
                          mean_density(geometry, density[body], point)) *
                       geometry.thickness_at(point);
          f = fault_above(scene, body);
        }
    return stress;
  }



  template decltype(lithostatic_stress<2>) lithostatic_stress<2>;
  template decltype(lithostatic_stress<3>) lithostatic_stress<3>;
} // namespace StickSlip
