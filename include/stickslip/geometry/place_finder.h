// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_place_finder_h
#define stickslip_geometry_place_finder_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Finds the cell of a mesh, or the face on one of its sides, in which a point
   * is or to which it is nearest, and the (multi)linear basis functions there.
   */
  template <int dim>
  class PlaceFinder
  {
  public:
    struct Place
    {
      /** Vertices of the triangulation and the values of their basis functions
       * at the place; they are not negative and add up to one. */
      std::vector<std::pair<unsigned int, double>> values;

      /** Distance of the point from the place, m; zero if it is inside. */
      double distance;

      /** The diameter of the cell or face, m. */
      double size;
    };

    /** Places in active cells. */
    explicit PlaceFinder(const Triangulation<dim> &mesh);

    /** Places in the active faces with a boundary indicator. */
    PlaceFinder(const Triangulation<dim> &mesh, const types::boundary_id side);

    /** Places in faces that join some of @p points in deal.II's order. */
    PlaceFinder(const std::vector<std::vector<unsigned int>> &faces,
                const std::vector<Point<dim>>                &points);

    /** The place of a point, or the one next to it. */
    Place
    find(const Point<dim> &point) const;

  private:
    struct Patch
    {
      std::vector<unsigned int> vertices;
      std::vector<Point<dim>>   points;

      /** Dimension of the patch, and whether it is a simplex. */
      unsigned int structdim;
      bool         is_simplex;
    };

    /** Boxes around the patches. */
    struct Tree;

    void
    make_tree();

    static Place
    place_in(const Patch &patch, const Point<dim> &point);

    std::vector<Patch>          patches;
    std::shared_ptr<const Tree> tree;
  };
} // namespace StickSlip

#endif
