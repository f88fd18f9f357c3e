// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_sine_bodies_h
#define stickslip_tests_sine_bodies_h

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>

#include <stickslip/geometry/block.h>
#include <stickslip/geometry/coarse_body.h>
#include <stickslip/mesh/coarser_mesh.h>

#include <cmath>
#include <vector>

namespace StickSlip::Tests
{
  enum class Cells
  {
    quadrilaterals,
    triangles
  };

  /**
   * Two bodies of 2 m x 0.6 m with a fault between them that is one wave of a
   * sine, by meshes that are not nested: the vertices of each are on the sine,
   * and both sides have the same ones.
   */
  template <int dim>
  struct SineBodies
  {
    /** From the finest to the coarsest, the indicators of sides being alike. */
    std::vector<CutMesh<dim>> meshes;
    Cells                     shape;
    unsigned int              uniform_refinements;

    SineBodies(const double                     amplitude,
               const std::vector<unsigned int> &n_cells_along,
               const Cells                      shape,
               const unsigned int               uniform_refinements)
      : shape(shape)
      , uniform_refinements(uniform_refinements)
    {
      for (const unsigned int n : n_cells_along)
        {
          std::vector<Point<2>> wave;
          for (unsigned int i = 1; i < n; ++i)
            wave.emplace_back(-1. + 2. * i / n,
                              amplitude * std::sin(2. * numbers::PI * i / n));
          std::vector<Block<dim>> blocks(2);
          for (const unsigned int b : {0, 1})
            {
              const double y    = 0.6 * b;
              blocks[b].name    = b == 0 ? "lower" : "upper";
              blocks[b].corners = {
                {{-1., y - 0.6}, {1., y - 0.6}, {1., y}, {-1., y}}};
              blocks[b].polylines[b == 0 ? 3 : 2] = wave;
              blocks[b].along_y                   = {{-0.3, 0.3}};
              blocks[b].cells.fill(std::max(n / 3, 2u));
              blocks[b].cells[0] = n;
            }
          meshes.push_back(
            cut_at_faults(cells_of_blocks(blocks),
                          {{"fault",
                            "fault",
                            {{{{"lower", "top"}}, {{"upper", "bottom"}}}}}}));
          if (meshes.size() > 1)
            match_to_finer(meshes[meshes.size() - 2], meshes.back());
        }
    }

    /** The bodies of the finest mesh with some of the coarser ones. */
    std::vector<CoarseBody<dim>>
    coarse_bodies(const unsigned int n_coarser) const
    {
      std::vector<CoarseBody<dim>> bodies(2);
      for (const unsigned int b : {0, 1})
        {
          bodies[b].cells               = cells(meshes[0].bodies[b]);
          bodies[b].side_names          = meshes[0].bodies[b].side_names;
          bodies[b].uniform_refinements = uniform_refinements;
          for (unsigned int k = 1; k <= n_coarser; ++k)
            bodies[b].coarser_cells.push_back(cells(meshes[k].bodies[b]));
        }
      return bodies;
    }

  private:
    std::shared_ptr<const Triangulation<dim>>
    cells(const BodyCells<dim> &body) const
    {
      if (shape == Cells::quadrilaterals)
        return body.triangulation();
      const auto triangles = std::make_shared<Triangulation<dim>>();
      GridGenerator::convert_hypercube_to_simplex_mesh(*body.triangulation(),
                                                       *triangles);
      return triangles;
    }
  };
} // namespace StickSlip::Tests

#endif
