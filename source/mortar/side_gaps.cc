// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/nodal_normals.h>
#include <stickslip/mortar/overlap_points.h>
#include <stickslip/mortar/side_gaps.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** By how much a smooth surface with these normals at the nodes is above
     * one of its faces, at the point x of a plane that the face is projected
     * onto, where its shape functions are @p phi; see side_gaps(). */
    template <int dim>
    double
    bulge(const FacePlane<dim>                     &plane,
          const FaceShape<dim>                     &shape,
          const FaultSurface<dim>                  &surface,
          const unsigned int                        face,
          const std::vector<Tensor<1, dim>>        &normals,
          const Point<dim - 1>                     &x,
          const typename OverlapPoint<dim>::Values &phi)
    {
      double result = 0.;
      for (unsigned int v = 0; v < shape.n_vertices(); ++v)
        {
          const Tensor<1, dim> &normal = normals[surface.faces[face][v]];
          // At the edge of a fold there is no slope.
          if (const double up = normal * plane.normal(); std::abs(up) > 0.5)
            result -= 0.5 / up * phi[v] *
                      (plane.components(normal) * (x - shape.vertices()[v]));
        }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  side_gaps(const FaultSurface<dim>       &whole_slave,
            const std::vector<Point<dim>> &slave_positions,
            const FaultSurface<dim>       &master,
            const std::vector<Point<dim>> &master_positions,
            const SlaveRange              &range)
  {
    const std::vector<Tensor<1, dim>> slave_normals =
                                        nodal_normals(whole_slave),
                                      master_normals = nodal_normals(master);
    const FaultSurface<dim> slave = faces_around(whole_slave, range);

    FaceMasses<dim>                                 masses(slave.faces.size());
    std::vector<typename OverlapPoint<dim>::Values> integrals(
      slave.faces.size());
    const auto add_point = [&](const OverlapPoint<dim> &point) {
      // Of smooth sides.
      const double gap = point.gap +
                         bulge(point.plane,
                               point.slave_shape,
                               slave,
                               point.slave_face,
                               slave_normals,
                               point.on_slave,
                               point.slave_phi) -
                         bulge(point.plane,
                               point.master_shape,
                               master,
                               point.master_face,
                               master_normals,
                               point.on_master,
                               point.master_phi);
      auto              &mass     = masses[point.slave_face];
      auto              &integral = integrals[point.slave_face];
      const auto        &phi      = point.slave_phi;
      const unsigned int n        = point.slave_shape.n_vertices();
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int j = 0; j < n; ++j)
            mass[i][j] += phi[i] * phi[j] * point.JxW;
          integral[i] += phi[i] * gap * point.JxW;
        }
    };
    for_each_overlap_point<dim>(
      slave, slave_positions, master, master_positions, add_point);

    const std::vector<DualBasis<dim>> bases = dual_bases(slave, masses);
    const SlaveWeights                weights =
      slave_weights(slave, slave_positions, masses, bases);
    std::vector<double> gaps(slave_positions.size());
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      for (unsigned int i = 0;
           bases[f].is_valid() && i < slave.n_vertices_of(f);
           ++i)
        {
          const auto &row = bases[f].coefficients()[i];
          gaps[slave.faces[f][i]] += std::inner_product(row.begin(),
                                                        row.end(),
                                                        integrals[f].begin(),
                                                        0.);
        }
    for (unsigned int p = 0; p < gaps.size(); ++p)
      gaps[p] = range.contains(p) && weights.is_active(p) ?
                  gaps[p] / weights.covered[p] :
                  std::numeric_limits<double>::quiet_NaN();
    return gaps;
  }



  template decltype(side_gaps<2>) side_gaps<2>;
  template decltype(side_gaps<3>) side_gaps<3>;
} // namespace StickSlip
