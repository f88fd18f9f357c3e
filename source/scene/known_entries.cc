// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/known_entries.h>
#include <stickslip/scene/scene_writer.h>

#include <algorithm>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** True if the section with this number in a path has a name of the
     * scene's own. */
    bool
    is_named(const std::vector<std::string> &sections, const unsigned int i)
    {
      static const std::vector<std::string> with_names = {
        "Bodies", "Faults", "Boundary conditions"};
      return (i == 1 &&
              std::find(with_names.begin(), with_names.end(), sections[0]) !=
                with_names.end()) ||
             (i == 3 && sections[2] == "Regions");
    }



    /** The path of an entry of any scene, with the names that an assignment
     * gives. */
    std::string
    path_for(const DeclaredEntry &entry, const Assignment &assignment)
    {
      std::string path;
      for (unsigned int i = 0; i < entry.sections.size(); ++i)
        path += (is_named(entry.sections, i) && i < assignment.sections.size() ?
                   assignment.sections[i] :
                   entry.sections[i]) +
                "/";
      return path + entry.name;
    }



    unsigned int
    n_edits(const std::string &a, const std::string &b)
    {
      // Numbers for the beginnings of b, and a beginning of a that grows.
      std::vector<unsigned int> edits(b.size() + 1);
      std::iota(edits.begin(), edits.end(), 0u);
      for (unsigned int i = 0; i < a.size(); ++i)
        {
          unsigned int diagonal = edits[0];
          edits[0]              = i + 1;
          for (unsigned int j = 0; j < b.size(); ++j)
            {
              const unsigned int replaced = diagonal + (a[i] != b[j] ? 1 : 0);
              diagonal                    = edits[j + 1];
              edits[j + 1] =
                std::min({replaced, edits[j] + 1, edits[j + 1] + 1});
            }
        }
      return edits.back();
    }
  } // namespace



  void
  refuse_unknown_entries(const std::vector<Assignment> &assignments)
  {
    const std::vector<DeclaredEntry> entries = entries_of_any_scene();
    for (const Assignment &assignment : assignments)
      {
        std::vector<std::string> paths;
        for (const DeclaredEntry &entry : entries)
          paths.push_back(path_for(entry, assignment));
        if (std::find(paths.begin(), paths.end(), assignment.path()) !=
            paths.end())
          continue;
        const std::string nearest = nearest_name(assignment.path(), paths);
        throw InputError(
          naming(assignment) + ": there is no such entry" +
          (nearest.empty() ? "" : "; did you mean '" + nearest + "'") + ".");
      }
  }



  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    std::string  nearest;
    unsigned int fewest = name.size() / 3 + 1;
    for (const std::string &candidate : candidates)
      {
        const unsigned int n = n_edits(name, candidate);
        if (n < fewest)
          {
            fewest  = n;
            nearest = candidate;
          }
      }
    return nearest;
  }
} // namespace StickSlip
