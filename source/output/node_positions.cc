// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/node_positions.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** The way along a fault; three dimensions have none. */
    void
    add_way_along(const FaultLayout<2>             &fault,
                  std::vector<std::vector<double>> &positions)
    {
      const std::vector<double> way = arc_lengths(fault);
      for (unsigned int k = 0; k < way.size(); ++k)
        positions[k].push_back(way[k]);
    }

    void
    add_way_along(const FaultLayout<3> &, std::vector<std::vector<double>> &)
    {}
  } // namespace



  template <int dim>
  NodePositions<dim>::NodePositions(const std::vector<FaultLayout<dim>> &shapes)
    : are_level(std::all_of(shapes.begin(),
                            shapes.end(),
                            [](const auto &shape) { return shape.is_level(); }))
  {
    for (const FaultLayout<dim> &shape : shapes)
      {
        positions.emplace_back();
        for (const Point<dim> &point : shape.surface.points)
          {
            positions.back().emplace_back();
            for (unsigned int d = 0; d < (are_level ? dim - 1 : dim); ++d)
              positions.back().back().push_back(point[d]);
          }
        if (!are_level)
          add_way_along(shape, positions.back());
      }
  }



  template <int dim>
  TableColumns
  NodePositions<dim>::columns(const std::string &name,
                              const std::string &what) const
  {
    const std::string axes = "xyz";
    TableColumns      result;
    for (unsigned int d = 0; d < (are_level ? dim - 1 : dim); ++d)
      result.push_back(
        {name + '_' + axes[d],
         "m",
         std::string(1, axes[d]) + " of the reference position of " + what});
    if (dim == 2 && !are_level)
      result.push_back(
        {name + "_arc_length", "m", "way along the fault to " + what});
    return result;
  }



  template class NodePositions<2>;
  template class NodePositions<3>;
} // namespace StickSlip
