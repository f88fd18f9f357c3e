// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <stickslip/mortar/overlap_points.h>

#include <numeric>
#include <optional>
#include <type_traits>

namespace StickSlip
{
  namespace
  {
    /** Elevations of the vertices of a face above the origin along a normal, m.
     */
    template <int dim>
    typename OverlapPoint<dim>::Values
    elevations(const Tensor<1, dim>          &normal,
               const FaultSurface<dim>       &surface,
               const std::vector<Point<dim>> &positions,
               const unsigned int             face)
    {
      typename OverlapPoint<dim>::Values result = {};
      const auto vertices = surface.face_vertices(positions, face);
      for (unsigned int v = 0; v < surface.n_vertices_of(face); ++v)
        result[v] = normal * vertices[v];
      return result;
    }



    template <typename Values>
    double
    product(const Values &a, const Values &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }



    Quadrature<1>
    cell_quadrature(const std::integral_constant<int, 2>)
    {
      return QGauss<1>(2);
    }



    // Products of two bilinear functions have degree four.
    Quadrature<2>
    cell_quadrature(const std::integral_constant<int, 3>)
    {
      return QGaussSimplex<2>(3);
    }
  } // namespace



  template <int dim>
  void
  for_each_overlap_point(
    const FaultSurface<dim>                              &slave,
    const std::vector<Point<dim>>                        &slave_positions,
    const FaultSurface<dim>                              &master,
    const std::vector<Point<dim>>                        &master_positions,
    const std::function<void(const OverlapPoint<dim> &)> &visit)
  {
    const Quadrature<dim - 1> quadrature =
      cell_quadrature(std::integral_constant<int, dim>());
    double reference_area = 0.;
    for (const double weight : quadrature.get_weights())
      reference_area += weight;
    const bool are_plane = slave.is_plane() && master.is_plane();

    // Cells of one pair of faces follow each other.
    const OverlapCell<dim>             *last = nullptr;
    std::optional<FacePlane<dim>>       plane;
    std::optional<FaceShape<dim>>       slave_shape, master_shape;
    const std::vector<OverlapCell<dim>> cells =
      compute_face_overlap(slave, slave_positions, master, master_positions);
    for (const OverlapCell<dim> &cell : cells)
      {
        const Tensor<1, dim> normal = slave.normal_of(cell.slave_face);
        const bool           is_new_slave =
          last == nullptr || last->slave_face != cell.slave_face;
        if (is_new_slave)
          {
            plane.emplace(normal);
            slave_shape.emplace(
              project_face(*plane, slave, slave_positions, cell.slave_face));
          }
        if (is_new_slave || last->master_face != cell.master_face)
          master_shape.emplace(
            project_face(*plane, master, master_positions, cell.master_face));
        last = &cell;
        // From the slave face to the master face, whose image it meets.
        Tensor<1, dim> shift;
        for (unsigned int d = 0; d < dim - 1; ++d)
          shift[d] = -cell.master_wraps[d] * slave.period[d];
        const Tensor<1, dim - 1> shift_in_plane = plane->components(shift);

        typename OverlapPoint<dim>::Values slave_heights  = {},
                                           master_heights = {};
        if (!are_plane)
          {
            slave_heights =
              elevations(normal, slave, slave_positions, cell.slave_face);
            master_heights =
              elevations(normal, master, master_positions, cell.master_face);
          }

        const double scale = cell.measure() / reference_area;
        for (unsigned int g = 0; g < quadrature.size(); ++g)
          {
            Point<dim - 1> x = cell.vertices[0];
            for (unsigned int d = 0; d < dim - 1; ++d)
              x += quadrature.point(g)[d] *
                   (cell.vertices[d + 1] - cell.vertices[0]);
            const Point<dim - 1> on_master = x + shift_in_plane;
            const auto           slave_phi = slave_shape->shape_values(x);
            const auto   master_phi = master_shape->shape_values(on_master);
            const double gap        = are_plane ?
                                        0. :
                                        product(slave_phi, slave_heights) -
                                   product(master_phi, master_heights) +
                                   shift * normal;
            visit({cell.slave_face,
                   cell.master_face,
                   *plane,
                   *slave_shape,
                   *master_shape,
                   x,
                   on_master,
                   slave_phi,
                   master_phi,
                   quadrature.weight(g) * scale,
                   gap});
          }
      }
  }



  template decltype(for_each_overlap_point<2>) for_each_overlap_point<2>;
  template decltype(for_each_overlap_point<3>) for_each_overlap_point<3>;
} // namespace StickSlip
