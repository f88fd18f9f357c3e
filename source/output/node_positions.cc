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
            for (unsigned int d = 0; d < (are_level ? 1 : dim); ++d)
              positions.back().back().push_back(point[d]);
          }
        if (!are_level)
          add_way_along(shape, positions.back());
      }
  }



  template <int dim>
  std::string
  NodePositions<dim>::titles(const std::string &name) const
  {
    std::vector<std::string> columns = {"x"};
    if (!are_level)
      columns = dim == 2 ? std::vector<std::string>{"x", "y", "arc_length"} :
                           std::vector<std::string>{"x", "y", "z"};
    std::string result;
    for (const std::string &column : columns)
      result += ',' + name + '_' + column;
    return result;
  }



  template class NodePositions<2>;
  template class NodePositions<3>;
} // namespace StickSlip
