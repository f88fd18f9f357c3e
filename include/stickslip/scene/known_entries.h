// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_known_entries_h
#define stickslip_scene_known_entries_h

#include <stickslip/parameters/parameter_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Throw InputError if there is no such entry in any scene, whatever the names
   * of its bodies, faults and sides, with the nearest one that there is. A
   * scene that misses something may have it under a misspelt name.
   */
  void
  refuse_unknown_entries(const std::vector<Assignment> &assignments);

  /**
   * The candidate that takes the fewest characters inserted, removed or
   * replaced to come to from @p name; empty if that is more than a third of
   * them.
   */
  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates);
} // namespace StickSlip

#endif
