// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/geometry/face_area.h>
#include <stickslip/mortar/moved_surface.h>

namespace StickSlip
{
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
          face_area<dim>(surface.face_vertices(surface.points, f), n) * before >
          0.;
        Tensor<1, dim> area =
          face_area<dim>(surface.face_vertices(positions, f), n);
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
