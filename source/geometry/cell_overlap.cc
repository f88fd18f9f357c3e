// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/cell_overlap.h>
#include <stickslip/geometry/face_area.h>

#include <iterator>

namespace StickSlip
{
  namespace
  {
    /** True if a point is on the inner side of all faces of a cell. */
    template <int dim>
    bool
    contains(const GroupedCells<dim> &mesh,
             const CellFaces<dim>    &faces,
             const unsigned int       cell,
             const Point<dim>        &point)
    {
      const Point<dim> centre = mesh.centre(mesh.cells[cell]);
      for (const unsigned int f : faces.faces_of_cell(cell))
        {
          const auto          &face   = faces.faces()[f];
          const Point<dim>     origin = face_centre<dim>(mesh, face);
          const Tensor<1, dim> normal = face_area<dim>(mesh, face);
          if (((point - origin) * normal) * ((centre - origin) * normal) <= 0.)
            return false;
        }
      return true;
    }
  } // namespace



  template <int dim>
  void
  check_overlap(const GroupedCells<dim> &mesh, const CellFaces<dim> &faces)
  {
    using Box = std::pair<BoundingBox<dim>, unsigned int>;
    std::vector<Box> boxes;
    boxes.reserve(mesh.cells.size());
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        std::vector<Point<dim>> vertices;
        for (unsigned int v = 0; v < mesh.cells[c].n_vertices; ++v)
          vertices.push_back(mesh.points[mesh.cells[c].vertices[v]]);
        boxes.emplace_back(BoundingBox<dim>(vertices), c);
      }
    const auto tree = pack_rtree(boxes);

    std::vector<Box> found;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto             &cell   = mesh.cells[c];
        const Point<dim>        centre = mesh.centre(cell);
        std::vector<Point<dim>> points = {centre};
        for (unsigned int v = 0; v < cell.n_vertices; ++v)
          points.push_back(0.75 * mesh.points[cell.vertices[v]] +
                           0.25 * Tensor<1, dim>(centre));
        for (const Point<dim> &point : points)
          {
            found.clear();
            tree.query(boost::geometry::index::intersects(point),
                       std::back_inserter(found));
            for (const Box &other : found)
              if (other.second != c &&
                  contains(mesh, faces, other.second, point))
                {
                  const std::string &first = mesh.body_names[cell.body];
                  const std::string &second =
                    mesh.body_names[mesh.cells[other.second].body];
                  throw InputError(
                    first == second ?
                      "Cells of the body '" + first + "' overlap at " +
                        position_text(point) + "." :
                      "The bodies '" + first + "' and '" + second +
                        "' overlap at " + position_text(point) + ".");
                }
          }
      }
  }



  template void
  check_overlap(const GroupedCells<2> &, const CellFaces<2> &);
  template void
  check_overlap(const GroupedCells<3> &, const CellFaces<3> &);
} // namespace StickSlip
