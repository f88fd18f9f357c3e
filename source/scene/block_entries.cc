// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/coarse_body.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/parameters/point_list.h>
#include <stickslip/scene/block_entries.h>
#include <stickslip/scene/mesh_entries.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Declare a list of points. */
    void
    add_points(ParameterHandler  &prm,
               const std::string &entry,
               std::string       &value,
               const PointList   &pattern,
               const std::string &documentation)
    {
      prm.declare_entry(entry, value, pattern, documentation);
      prm.add_action(entry,
                     [&value](const std::string &text) { value = text; });
    }
  } // namespace



  void
  BlockEntries::add_parameters(ParameterHandler &prm, const unsigned int dim)
  {
    const std::string plane = dim == 2 ? "x and y" : "x and z";
    add_points(prm,
               "Corners",
               corners,
               PointList(4),
               "The body is a block with these corners: " + plane +
                 " of each, in m, counter-clockwise from the lower left one, "
                 "separated by commas" +
                 (dim == 2 ? "" :
                             "; it goes along y as 'Extent along y' says") +
                 ". Sides are named as those of bricks. Either all bodies are "
                 "blocks or none; they have no order, and each fault names its "
                 "sides in 'Between'. Empty: a brick in a stack, or in a mesh "
                 "file.");
    const std::array<std::pair<const char *, const char *>, 4> sides = {
      {{"Left", "from bottom to top"},
       {"Right", "from bottom to top"},
       {"Bottom", "from left to right"},
       {"Top", "from left to right"}}};
    for (unsigned int i = 0; i < 4; ++i)
      add_points(prm,
                 std::string(sides[i].first) + " polyline",
                 polylines[i],
                 PointList(),
                 "Points of this side of a block between its corners, " +
                   plane + " of each, in m, " + sides[i].second +
                   ", separated by commas. They are vertices of coarse cells, "
                   "of which there must be one for each piece. Empty: a "
                   "straight line.");
    if (dim == 3)
      add_numbers(prm,
                  "Extent along y",
                  along_y,
                  NumberRange().in("m"),
                  "Lower and upper end of a block along y, in m.");
  }



  template <int dim>
  Block<dim>
  BlockEntries::block(const std::string &body_name) const
  {
    Block<dim> result;
    result.name                        = body_name;
    result.section                     = "Bodies/" + body_name;
    const std::vector<Point<2>> points = PointList::values(corners);
    AssertDimension(points.size(), 4);
    std::copy(points.begin(), points.end(), result.corners.begin());
    for (unsigned int i = 0; i < 4; ++i)
      result.polylines[i] = PointList::values(polylines[i]);
    result.along_y = along_y;
    if (dim == 3 && along_y[0] >= along_y[1])
      throw InputError("'" + result.section +
                       "/Extent along y': the first number must be less than "
                       "the second.");
    return result;
  }



  template <int dim>
  void
  check_between_blocks(const std::string              &entry,
                       const std::string              &text,
                       const std::vector<std::string> &body_names)
  {
    const auto between = parse_between(text);
    if (between[0].empty())
      throw InputError("'" + entry +
                       "' = '': must name the sides of the fault, such as "
                       "'lower top, upper bottom', since bodies have "
                       "'Corners'.");
    std::vector<std::string> sides;
    for (const auto &side : brick_side_names<dim>())
      sides.push_back(side.second);
    std::vector<std::string> so_far;
    for (const auto &side : between)
      for (const MeshFault::Side &part : side)
        {
          const std::string name =
            part.body + (part.group.empty() ? "" : " ") + part.group;
          const std::string what = "'" + entry + "' = '" + text + "': ";
          if (std::find(body_names.begin(), body_names.end(), part.body) ==
              body_names.end())
            throw InputError(what + "there is no body '" + part.body +
                             "'; the bodies are " + join_names(body_names) +
                             ".");
          if (std::find(sides.begin(), sides.end(), part.group) == sides.end())
            throw InputError(what + "'" + name +
                             "' is no side; the sides of a block are " +
                             join_names(sides) + ".");
          if (std::find(so_far.begin(), so_far.end(), name) != so_far.end())
            throw InputError(what + "'" + name + "' is named twice.");
          so_far.push_back(name);
        }
  }



  template Block<2>
  BlockEntries::block(const std::string &) const;
  template Block<3>
  BlockEntries::block(const std::string &) const;
  template decltype(check_between_blocks<2>) check_between_blocks<2>;
  template decltype(check_between_blocks<3>) check_between_blocks<3>;
} // namespace StickSlip
