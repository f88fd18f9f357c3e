// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/place_finder.h>
#include <stickslip/mesh/coarser_mesh.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** The indicator of a side of a name. */
    template <int dim>
    std::map<types::boundary_id, std::string>::const_iterator
    find_side(const BodyCells<dim> &body, const std::string &name)
    {
      return std::find_if(body.side_names.begin(),
                          body.side_names.end(),
                          [&name](const auto &side) {
                            return side.second == name;
                          });
    }



    /** New indicators of the sides of a body by the names of @p finer. */
    template <int dim>
    void
    renumber_sides(const std::string    &name,
                   const BodyCells<dim> &finer,
                   BodyCells<dim>       &coarser)
    {
      for (const auto &side : finer.side_names)
        if (find_side(coarser, side.second) == coarser.side_names.end())
          throw InputError("The body '" + name + "' has no side '" +
                           side.second + "'.");
      std::map<types::boundary_id, types::boundary_id> numbers;
      for (const auto &side : coarser.side_names)
        {
          const auto of_finer = find_side(finer, side.second);
          if (of_finer == finer.side_names.end())
            throw InputError("The body '" + name + "' has a side '" +
                             side.second + "', but not in the finer mesh.");
          numbers[side.first] = of_finer->first;
        }
      for (auto &line : coarser.boundary.boundary_lines)
        line.boundary_id = numbers.at(line.boundary_id);
      for (auto &quad : coarser.boundary.boundary_quads)
        quad.boundary_id = numbers.at(quad.boundary_id);
      coarser.side_names = finer.side_names;
    }



    /** Check that all vertices of one mesh of a body are in or next to cells of
     * the other one. */
    template <int dim>
    void
    check_covers(const std::string        &name,
                 const BodyCells<dim>     &body,
                 const Triangulation<dim> &cells,
                 const bool                cells_are_coarser)
    {
      const PlaceFinder<dim> finder(cells);
      for (const Point<dim> &vertex : body.vertices)
        {
          const auto place = finder.find(vertex);
          if (place.distance > 0.5 * place.size)
            throw InputError("The body '" + name + "' is not the same: " +
                             (cells_are_coarser ? "the finer" : "the coarser") +
                             " mesh alone is at " + position_text(vertex) +
                             ".");
        }
    }
  } // namespace



  template <int dim>
  void
  match_to_finer(const CutMesh<dim> &finer, CutMesh<dim> &coarser)
  {
    AssertDimension(finer.bodies.size(), coarser.bodies.size());
    for (unsigned int b = 0; b < finer.bodies.size(); ++b)
      {
        const std::string &name = finer.topology.body_names()[b];
        renumber_sides(name, finer.bodies[b], coarser.bodies[b]);
        if (coarser.bodies[b].cells.size() >= finer.bodies[b].cells.size())
          throw InputError("The body '" + name + "' has " +
                           std::to_string(coarser.bodies[b].cells.size()) +
                           " cells, not fewer than the " +
                           std::to_string(finer.bodies[b].cells.size()) +
                           " of the finer mesh.");
        check_covers(name,
                     finer.bodies[b],
                     *coarser.bodies[b].triangulation(),
                     true);
        check_covers(name,
                     coarser.bodies[b],
                     *finer.bodies[b].triangulation(),
                     false);
      }
  }



  template void
  match_to_finer(const CutMesh<2> &, CutMesh<2> &);
  template void
  match_to_finer(const CutMesh<3> &, CutMesh<3> &);
} // namespace StickSlip
