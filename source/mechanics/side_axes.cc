// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/grouped_cells.h>
#include <stickslip/mechanics/side_axes.h>
#include <stickslip/mesh/nodal_normals.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::array<double, dim>
    coordinates(const Point<dim> &point)
    {
      std::array<double, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point[d];
      return result;
    }
  } // namespace



  template <int dim>
  bool
  is_plane(const FaultSurface<dim> &side)
  {
    return std::all_of(
      side.points.begin(), side.points.end(), [&](const Point<dim> &point) {
        const Tensor<1, dim> offset = point - side.points.front();
        return std::abs(offset * side.normal) <= 1e-8 * offset.norm();
      });
  }



  template <int dim>
  unsigned int
  reference_of_side(const std::vector<Tensor<1, dim>> &normals)
  {
    const double cosine = std::cos(15. * numbers::PI / 180.);
    for (unsigned int d = 0; d < dim; ++d)
      if (std::all_of(normals.begin(), normals.end(), [&](const auto &normal) {
            return std::abs(normal[d]) <= cosine;
          }))
        return d;
    return numbers::invalid_unsigned_int;
  }



  template <int dim>
  Tensor<2, dim>
  axes_of_side(const Tensor<1, dim> &normal, const unsigned int reference)
  {
    std::array<Tensor<1, dim>, dim> axes;
    axes[dim - 1] = normal;
    if constexpr (dim == 2)
      {
        axes[0][0] = normal[1];
        axes[0][1] = -normal[0];
      }
    else
      {
        const unsigned int next = reference != numbers::invalid_unsigned_int ?
                                    reference :
                                    reference_of_side<dim>({normal});
        axes[0][next]           = 1.;
        axes[0] -= normal[next] * normal;
        axes[0] /= axes[0].norm();
        axes[1] = cross_product_3d(normal, axes[0]);
      }
    Tensor<2, dim> columns;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        columns[d][c] = axes[c][d];
    return columns;
  }



  template <int dim>
  SideNormals<dim>::SideNormals(const FaultSurface<dim> &side)
  {
    const double cosine = std::cos(25. * numbers::PI / 180.);
    const std::vector<Tensor<1, dim>> of_nodes = nodal_normals(side);
    for (unsigned int f = 0; f < side.faces.size(); ++f)
      for (unsigned int v = 0; v < side.n_vertices_of(f); ++v)
        {
          const unsigned int p = side.faces[f][v];
          if (of_nodes[p] * side.normal_of(f) < cosine)
            throw InputError("the side has a corner at " +
                             position_text(side.points[p]) +
                             "; each of its parts must be a group of its own.");
        }
    for (unsigned int p = 0; p < side.points.size(); ++p)
      normals[coordinates(side.points[p])] = of_nodes[p];
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  SideNormals<dim>::all() const
  {
    std::vector<Tensor<1, dim>> result;
    for (const auto &normal : normals)
      result.push_back(normal.second);
    return result;
  }



  template <int dim>
  const Tensor<1, dim> &
  SideNormals<dim>::at(const Point<dim> &point) const
  {
    const auto place = normals.find(coordinates(point));
    if (place != normals.end())
      return place->second;
    const auto distance = [&](const auto &node) {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        sum += (node.first[d] - point[d]) * (node.first[d] - point[d]);
      return sum;
    };
    return std::min_element(normals.begin(),
                            normals.end(),
                            [&](const auto &a, const auto &b) {
                              return distance(a) < distance(b);
                            })
      ->second;
  }



#define STICKSLIP_INSTANTIATE(dim)                             \
  template bool         is_plane(const FaultSurface<dim> &);   \
  template unsigned int reference_of_side(                     \
    const std::vector<Tensor<1, dim>> &);                      \
  template Tensor<2, dim> axes_of_side(const Tensor<1, dim> &, \
                                       const unsigned int);    \
  template class SideNormals<dim>;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
