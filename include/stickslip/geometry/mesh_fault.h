// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_mesh_fault_h
#define stickslip_geometry_mesh_fault_h

#include <array>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The place of a fault in mesh files.
   *
   * Either it is the faces of one physical group, which have a cell on both
   * sides; nodes may be the same on both sides or doubled. Or each of its sides
   * is a list of groups at the boundaries of bodies, whose meshes need not
   * match.
   */
  struct MeshFault
  {
    struct Side
    {
      std::string body;

      /** A group of boundary faces. Empty: what the body has of the fault. */
      std::string group;
    };

    std::string name;

    /** The group of its faces; not used if sides name groups. */
    std::string group;

    /** The bodies on both sides; the normal points from the first to the second
     * ones. Both empty: from the body of the lowest number; where the same body
     * is on both sides, upwards along the last axis that allows to say so. */
    std::array<std::vector<Side>, 2> between;

    /** See Fault::may_be_apart. */
    bool may_be_apart = false;

    /** True if the sides are groups at the boundaries of bodies. */
    bool
    has_side_groups() const
    {
      return !between[0].empty() && !between[0][0].group.empty();
    }
  };
} // namespace StickSlip

#endif
