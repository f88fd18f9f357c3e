// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_smooth_surface_h
#define stickslip_geometry_smooth_surface_h

#include <stickslip/geometry/fault_shape.h>
#include <stickslip/geometry/height_function.h>
#include <stickslip/geometry/place_finder.h>

#include <map>
#include <vector>

namespace StickSlip
{
  /**
   * A smooth surface through the vertices of triangles and quadrilaterals in
   * space. At each vertex, the polynomial of third degree that fits the
   * vertices around is a height over the mean plane there (fewer terms where
   * these are few). A point in a face is moved as the polynomials of the
   * vertices of the face say, weighted by their (multi)linear functions: the
   * distance from a cap of a sphere falls with order 3.8 in the size of the
   * faces, the error of normals with 2.3 to 2.7, up to the edges.
   *
   * Edges at which faces turn by more than least_corner stay, and parts of the
   * surface on both sides of them do not know each other: these edges should be
   * straight.
   */
  class SmoothSurface : public FaultShape<3>
  {
  public:
    /** A plane on which points stay that are on it: that of an outer side. */
    struct Plane
    {
      Point<3>     point;
      Tensor<1, 3> normal;

      bool
      contains(const Point<3> &other, const double tolerance) const;
    };

    /** @p faces: the numbers of the three or four vertices, in deal.II's
     * order. */
    SmoothSurface(const std::vector<Point<3>>                  &points,
                  const std::vector<std::vector<unsigned int>> &faces,
                  const std::vector<Plane>                     &planes);

    virtual Point<3>
    place(const Point<3> &point) const override;

  private:
    /** Faces that no edge divides, and the height at each of their vertices. */
    struct Part
    {
      PlaceFinder<3>                         finder;
      std::map<unsigned int, HeightFunction> heights;
    };

    std::vector<Part>  parts;
    std::vector<Plane> planes;
  };
} // namespace StickSlip

#endif
