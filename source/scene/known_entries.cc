// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/name_list.h>
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



    /** An entry of any scene, with the names that an assignment gives. */
    DeclaredEntry
    named_for(DeclaredEntry entry, const Assignment &assignment)
    {
      for (unsigned int i = 0; i < entry.sections.size(); ++i)
        if (is_named(entry.sections, i))
          entry.sections[i] =
            i < assignment.sections.size() ? assignment.sections[i] : "<name>";
      return entry;
    }



    /** Refuse an assignment in a subsection that no list of names has. */
    void
    refuse_unlisted_name(const Assignment               &assignment,
                         const unsigned int              section,
                         const std::string              &list,
                         const std::vector<std::string> &names)
    {
      const std::string &name = assignment.sections[section];
      if (std::find(names.begin(), names.end(), name) != names.end())
        return;
      const std::string nearest = nearest_name(name, names);
      throw InputError(
        naming(assignment) + ": '" + name + "' is not in '" + list + "'" +
        (nearest.empty() ? "" : "; did you mean '" + nearest + "'") + "; " +
        (names.empty() ? "there are no names" :
                         "names there are " + join_names(names)) +
        ".");
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
        std::vector<DeclaredEntry> named;
        for (const DeclaredEntry &entry : entries)
          named.push_back(named_for(entry, assignment));
        if (find_declared(named, assignment) == named.end())
          refuse_entry(assignment, named);
      }
  }



  void
  refuse_unlisted_names(const std::vector<Assignment>  &assignments,
                        const std::vector<std::string> &top_sections)
  {
    const auto names = [&assignments](const std::string &list) {
      std::vector<std::string> result;
      for (const Assignment &assignment : assignments)
        if (assignment.path() == list)
          result = NameList::split(assignment.value);
      return result;
    };
    for (const Assignment &assignment : assignments)
      {
        const std::vector<std::string> &sections = assignment.sections;
        if (sections.empty() ||
            std::find(top_sections.begin(), top_sections.end(), sections[0]) ==
              top_sections.end())
          continue;
        for (const unsigned int i : {1, 3})
          if (i < sections.size() && is_named(sections, i))
            {
              const std::string list =
                i == 3 ? sections[0] + "/" + sections[1] + "/Regions/Names" :
                sections[0] == "Boundary conditions" ? sections[0] + "/Sides" :
                                                       sections[0] + "/Names";
              refuse_unlisted_name(assignment, i, list, names(list));
            }
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
