// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/nodal_normals.h>
#include <stickslip/mortar/moved_surface.h>
#include <stickslip/mortar/secant_axes.h>
#include <stickslip/mortar/shared_coupling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::vector<Point<dim>>
    sum(const std::vector<Point<dim>>     &points,
        const std::vector<Tensor<1, dim>> &vectors)
    {
      std::vector<Point<dim>> result = points;
      for (unsigned int k = 0; k < points.size(); ++k)
        result[k] += vectors[k];
      return result;
    }



    /** The extent of the smallest face at each node, m. */
    template <int dim>
    std::vector<double>
    sizes_at_nodes(const FaultSurface<dim> &surface)
    {
      std::vector<double> sizes(surface.nodes.size(),
                                std::numeric_limits<double>::max());
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
          sizes[surface.faces[f][v]] =
            std::min(sizes[surface.faces[f][v]], surface.face_size(f));
      return sizes;
    }



    template <int dim>
    LargestGap
    largest(const std::vector<double> &gaps, const FaultSurface<dim> &surface)
    {
      const std::vector<double> sizes = sizes_at_nodes(surface);
      LargestGap                result;
      for (unsigned int k = 0; k < gaps.size(); ++k)
        if (!std::isnan(gaps[k]))
          {
            result.absolute = std::max(result.absolute, std::abs(gaps[k]));
            result.over_face =
              std::max(result.over_face, std::abs(gaps[k]) / sizes[k]);
          }
      return result;
    }



    /** The axes of a fault with these normals out of its slave side. */
    template <int dim>
    FaultAxes<dim>
    axes_of(std::vector<Tensor<1, dim>> normals,
            const FaultSides           &sides,
            const Tensor<1, dim>       &reference)
    {
      if (sides.slave_is_second())
        for (Tensor<1, dim> &normal : normals)
          normal *= -1.;
      return FaultAxes<dim>(normals, reference);
    }
  } // namespace



  template <int dim>
  SecantCoupling<dim>
  secant_coupling(const FaultSurface<dim>               &slave,
                  const FaultSurface<dim>               &master,
                  const FaultSides                      &sides,
                  const FaultDisplacement<dim>          &displacement,
                  const std::vector<Tensor<1, dim - 1>> &expected_slip,
                  const double                           farthest,
                  const Tensor<1, dim>                  &reference,
                  const MPI_Comm                        &communicator)
  {
    const FaultSurface<dim> slave_now =
      moved_surface(slave, sum(slave.points, displacement.slave));
    const FaultSurface<dim> master_now =
      moved_surface(master, sum(master.points, displacement.master));
    const auto gaps_at = [&](const std::vector<Point<dim>> &slave_positions) {
      return find_shared_gaps(slave_now,
                              slave_positions,
                              master_now,
                              master_now.points,
                              communicator);
    };
    const std::vector<double>   gaps    = gaps_at(slave_now.points);
    std::vector<Tensor<1, dim>> normals = nodal_normals(slave_now);

    SecantCoupling<dim> result{axes_of(normals, sides, reference),
                               displacement,
                               largest(gaps, slave)};
    if (expected_slip.empty() || farthest == 0.)
      return result;

    AssertDimension(expected_slip.size(), normals.size());
    // All nodes look ahead equally far: how far apart they are must not change.
    std::vector<Tensor<1, dim>> slip(normals.size()), ahead(normals.size());
    for (unsigned int k = 0; k < slip.size(); ++k)
      {
        const Tensor<2, dim> axes = result.axes.at(k);
        for (unsigned int c = 0; c < dim - 1; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            slip[k][d] += expected_slip[k][c] * axes[d][c];
        if (const double distance = slip[k].norm(); distance > 0.)
          ahead[k] = farthest / distance * slip[k];
        result.displacement.slave[k] += 0.5 * slip[k];
      }

    const std::vector<double> gaps_ahead =
      gaps_at(sum(slave_now.points, ahead));
    for (unsigned int k = 0; k < slip.size(); ++k)
      {
        if (std::isnan(gaps_ahead[k]))
          continue;
        const double slope =
          std::max(-largest_tilt,
                   std::min(largest_tilt, gaps_ahead[k] / farthest));
        normals[k] += slope / farthest * slip[k];
        normals[k] /= normals[k].norm();
      }
    result.axes = axes_of(normals, sides, reference);
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                   \
  template struct SecantCoupling<dim>;               \
  template SecantCoupling<dim> secant_coupling<dim>( \
    const FaultSurface<dim> &,                       \
    const FaultSurface<dim> &,                       \
    const FaultSides &,                              \
    const FaultDisplacement<dim> &,                  \
    const std::vector<Tensor<1, dim - 1>> &,         \
    const double,                                    \
    const Tensor<1, dim> &,                          \
    const MPI_Comm &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
