// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mortar/moved_surface.h>

namespace StickSlip
{
  namespace
  {
    /** The area vector of a face with vertices in deal.II's order; in three
     * dimensions that of the diagonals of a quadrilateral. */
    Tensor<1, 2>
    area_vector(const std::array<Point<2>, 2> &x, const unsigned int)
    {
      return cross_product_2d(x[1] - x[0]);
    }



    Tensor<1, 3>
    area_vector(const std::array<Point<3>, 4> &x, const unsigned int n_vertices)
    {
      return n_vertices == 3 ? cross_product_3d(x[1] - x[0], x[2] - x[0]) :
                               cross_product_3d(x[3] - x[0], x[2] - x[1]);
    }
  } // namespace



  template <int dim>
  FaultSurface<dim>
  moved_surface(const FaultSurface<dim>       &surface,
                const std::vector<Point<dim>> &positions)
  {
    AssertDimension(positions.size(), surface.points.size());
    FaultSurface<dim> moved = surface;
    moved.points            = positions;
    moved.face_normals.clear();
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      {
        const unsigned int    n      = surface.n_vertices_of(f);
        const Tensor<1, dim> &before = surface.normal_of(f);
        // The order of the vertices tells on which side the body is.
        const bool is_outward =
          area_vector(surface.face_vertices(surface.points, f), n) * before >
          0.;
        Tensor<1, dim> area =
          area_vector(surface.face_vertices(positions, f), n);
        if (!is_outward)
          area *= -1.;
        AssertThrow(area * before > 0.,
                    ExcMessage(
                      "A face on a side of a fault has no area or is turned "
                      "inside out. The deformation next to the fault is too "
                      "large for the mesh."));
        moved.face_normals.push_back(area / area.norm());
      }
    return moved;
  }



  template FaultSurface<2>
  moved_surface(const FaultSurface<2> &, const std::vector<Point<2>> &);
  template FaultSurface<3>
  moved_surface(const FaultSurface<3> &, const std::vector<Point<3>> &);
} // namespace StickSlip
