// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <stickslip/geometry/coarse_body.h>
#include <stickslip/geometry/fault_shape.h>

namespace StickSlip
{
  namespace
  {
    /** Means are taken in the brick of which a body is made. */
    template <int dim>
    class BlendedBrick : public ChartManifold<dim>
    {
    public:
      explicit BlendedBrick(const BodyGeometry<dim> &geometry)
        : geometry(geometry)
      {}

      virtual std::unique_ptr<Manifold<dim>>
      clone() const override
      {
        return std::make_unique<BlendedBrick<dim>>(geometry);
      }

      virtual Point<dim>
      pull_back(const Point<dim> &position) const override
      {
        return geometry.in_brick(position);
      }

      virtual Point<dim>
      push_forward(const Point<dim> &point) const override
      {
        return geometry.placed(point);
      }

    private:
      BodyGeometry<dim> geometry;
    };



    /** Vertices on sides with an elevation are there exactly, those inside
     * follow in proportion. */
    template <int dim>
    void
    bend(const BodyGeometry<dim> &geometry, Triangulation<dim> &cells)
    {
      constexpr types::manifold_id inside = 2 * dim;
      cells.set_all_manifold_ids(inside);
      cells.set_manifold(inside, BlendedBrick<dim>(geometry));
      SideShapes<dim> shapes;
      if (geometry.lower_elevation)
        shapes[2 * (dim - 1)] =
          std::make_shared<const GraphShape<dim>>(dim - 1,
                                                  geometry.lower_elevation);
      if (geometry.upper_elevation)
        shapes[2 * (dim - 1) + 1] =
          std::make_shared<const GraphShape<dim>>(dim - 1,
                                                  geometry.upper_elevation);
      for (const auto &[side, shape] : shapes)
        for (const auto &face : cells.active_face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
            for (const auto v : face->vertex_indices())
              face->vertex(v) = shape->place(face->vertex(v));
      set_shapes(cells, shapes);
    }
  } // namespace



  template <int dim>
  std::map<types::boundary_id, std::string>
  brick_side_names()
  {
    const std::array<const char *, 3> lower = {{"left", "front", "bottom"}};
    const std::array<const char *, 3> upper = {{"right", "back", "top"}};
    std::map<types::boundary_id, std::string> names;
    for (unsigned int axis = 0; axis < dim; ++axis)
      {
        const unsigned int name = axis + 1 == dim ? 2 : axis;
        names[2 * axis]         = lower[name];
        names[2 * axis + 1]     = upper[name];
      }
    return names;
  }



  template <int dim>
  CoarseBody<dim>
  coarse_brick(const BodyGeometry<dim> &geometry)
  {
    const auto cells = std::make_shared<Triangulation<dim>>();
    GridGenerator::subdivided_hyper_rectangle(
      *cells,
      geometry.rigid ? std::vector<unsigned int>(dim, 1) :
                       std::vector<unsigned int>(geometry.coarse_cells.begin(),
                                                 geometry.coarse_cells.end()),
      geometry.lower_corner(),
      geometry.upper_corner(),
      /*colorize=*/true);
    if (geometry.is_sloped() || geometry.has_elevation())
      GridTools::transform(
        [&geometry](const Point<dim> &point) { return geometry.placed(point); },
        *cells);
    if (geometry.has_elevation())
      bend(geometry, *cells);

    CoarseBody<dim> body;
    body.cells               = cells;
    body.uniform_refinements = geometry.uniform_refinements;
    body.refinement_passes   = geometry.refinement_passes;
    body.refinement_rows     = geometry.refinement_rows;
    body.refine_where        = geometry.where_to_refine();
    body.rigid               = geometry.rigid;
    body.period              = geometry.period();
    body.lateral_lower       = geometry.lateral_lower;

    body.side_names = brick_side_names<dim>();
    return body;
  }



  template decltype(brick_side_names<2>) brick_side_names<2>;
  template decltype(brick_side_names<3>) brick_side_names<3>;
  template struct CoarseBody<2>;
  template struct CoarseBody<3>;
  template CoarseBody<2>
  coarse_brick(const BodyGeometry<2> &);
  template CoarseBody<3>
  coarse_brick(const BodyGeometry<3> &);
} // namespace StickSlip
