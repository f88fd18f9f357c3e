// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/base/make_set.h>
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



    /** An entry of any scene, with the names that subsections have. */
    DeclaredEntry
    named_for(DeclaredEntry entry, const std::vector<std::string> &sections)
    {
      for (unsigned int i = 0; i < entry.sections.size(); ++i)
        if (is_named(entry.sections, i))
          entry.sections[i] = i < sections.size() ? sections[i] : "<name>";
      return entry;
    }



    std::string
    joined(const std::vector<std::string> &sections)
    {
      std::string path;
      for (const std::string &section : sections)
        path += (path.empty() ? "" : "/") + section;
      return path;
    }



    std::string
    naming(const EmptySubsection &subsection)
    {
      return "'" + joined(subsection.sections) + "' (" + subsection.origin +
             ")";
    }



    /** Refuse a name of a subsection that is in no list of these. */
    void
    refuse_unlisted_name(const std::string              &naming,
                         const std::string              &name,
                         const std::string              &list,
                         const std::vector<std::string> &names)
    {
      if (std::find(names.begin(), names.end(), name) != names.end())
        return;
      const std::string nearest = nearest_name(name, names);
      throw InputError(
        naming + ": '" + name + "' is not in '" + list + "'" +
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
          named.push_back(named_for(entry, assignment.sections));
        if (find_declared(named, assignment) == named.end())
          refuse_entry(assignment, named);
      }
  }



  void
  refuse_unknown_subsections(const std::vector<EmptySubsection> &subsections)
  {
    const std::vector<DeclaredEntry> entries = entries_of_any_scene();
    for (const EmptySubsection &subsection : subsections)
      {
        const std::vector<std::string> &sections = subsection.sections;
        // Subsections that there are next to each of these, from outside in.
        for (unsigned int n = 0; n < sections.size(); ++n)
          {
            std::vector<std::string> names;
            for (const DeclaredEntry &entry : entries)
              {
                const auto named = named_for(entry, sections).sections;
                if (named.size() > n && std::equal(named.begin(),
                                                   named.begin() + n,
                                                   sections.begin()))
                  names.push_back(named[n]);
              }
            make_set(names);
            if (std::find(names.begin(), names.end(), sections[n]) !=
                names.end())
              continue;
            const std::string nearest = nearest_name(sections[n], names);
            throw InputError(
              naming(subsection) + ": there is no such subsection '" +
              sections[n] + "'" +
              (nearest.empty() ? "" : "; did you mean '" + nearest + "'") +
              (names.empty() ? "; there are none here" :
                               "; there are " + join_names(names)) +
              ".");
          }
      }
  }



  void
  refuse_unlisted_names(const std::vector<Assignment>      &assignments,
                        const std::vector<EmptySubsection> &empty_subsections,
                        const std::vector<std::string>     &top_sections)
  {
    const auto names = [&assignments](const std::string &list) {
      std::vector<std::string> result;
      for (const Assignment &assignment : assignments)
        if (assignment.path() == list)
          result = NameList::split(assignment.value);
      return result;
    };
    const auto look_at = [&](const std::vector<std::string> &sections,
                             const auto                     &what) {
      if (sections.empty() ||
          std::find(top_sections.begin(), top_sections.end(), sections[0]) ==
            top_sections.end())
        return;
      for (const unsigned int i : {1, 3})
        if (i < sections.size() && is_named(sections, i))
          {
            const std::string list =
              i == 3 ? sections[0] + "/" + sections[1] + "/Regions/Names" :
              sections[0] == "Boundary conditions" ? sections[0] + "/Sides" :
                                                     sections[0] + "/Names";
            refuse_unlisted_name(naming(what), sections[i], list, names(list));
          }
    };
    for (const Assignment &assignment : assignments)
      look_at(assignment.sections, assignment);
    for (const EmptySubsection &subsection : empty_subsections)
      look_at(subsection.sections, subsection);
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
