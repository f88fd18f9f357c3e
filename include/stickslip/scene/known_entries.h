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
   * of its bodies, faults and sides, with the nearest one that there is. This
   * comes first: what a scene misses may be there under a misspelt name.
   */
  void
  refuse_unknown_entries(const std::vector<Assignment> &assignments);

  /**
   * Throw InputError if no scene has a subsection like one of those with
   * nothing in them, with the nearest one that there is.
   */
  void
  refuse_unknown_subsections(const std::vector<EmptySubsection> &subsections);

  /**
   * Throw InputError if there is an entry in the subsection of a body, fault,
   * region or side that is not in the list of these: it would have no effect;
   * or if there is such a subsection with nothing in it. @p top_sections:
   * 'Bodies', 'Faults' or 'Boundary conditions'.
   */
  void
  refuse_unlisted_names(const std::vector<Assignment>      &assignments,
                        const std::vector<EmptySubsection> &empty_subsections,
                        const std::vector<std::string>     &top_sections);

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
