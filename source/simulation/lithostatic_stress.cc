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
    /** The weight per area of one body. */
    template <int dim>
    class ColumnWeight
    {
    public:
      explicit ColumnWeight(const BodyParameters<dim> &body)
        : geometry(body.geometry)
        , field(body.material.density)
        , density(field.template function<dim>(body.material.section))
        , quadrature(QGauss<1>(2), 200)
      {}

      /** Its stress below the column over or under a point, Pa, with the
       * acceleration @p g, m/s^2. */
      double
      stress(const double g, Point<dim> point) const
      {
        point                  = geometry.within_sides(point);
        const double thickness = geometry.thickness_at(point);
        double       mean      = 0.;
        if (field.is_constant())
          mean = field.constant();
        else
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              point[dim - 1] =
                geometry.base + thickness * quadrature.point(q)[0];
              mean += density(point) * quadrature.weight(q);
            }
        return g * mean * thickness;
      }

    private:
      const BodyGeometry<dim>                  &geometry;
      const SpatialField                       &field;
      std::function<double(const Point<dim> &)> density;
      QIterated<1>                              quadrature;
    };



    /** The fault on top of a body, if there is one. */
    template <int dim>
    std::optional<unsigned int>
    fault_above(const SceneParameters<dim> &scene, const unsigned int body)
    {
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        for (const BodySide &part : scene.below_and_above(f)[0])
          if (part.body == body)
            return f;
      return {};
    }
  } // namespace



  template <int dim>
  std::vector<double>
  lithostatic_stress(const SceneParameters<dim>    &scene,
                     const unsigned int             fault,
                     const std::vector<Point<dim>> &points)
  {
    const double                   g = -scene.gravity_vector()[dim - 1];
    std::vector<ColumnWeight<dim>> bodies;
    for (const BodyParameters<dim> &body : scene.bodies)
      bodies.emplace_back(body);

    std::vector<double> stress(points.size(), 0.);
    for (unsigned int k = 0; k < points.size(); ++k)
      for (std::optional<unsigned int> f = fault; f;)
        {
          const unsigned int body =
            scene.nearest_body(scene.below_and_above(*f)[1], points[k]);
          stress[k] += bodies[body].stress(g, points[k]);
          f = fault_above(scene, body);
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
